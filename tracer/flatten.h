// The scene's forest of objects → a list of things in world space, each either one primitive, a
// tree of solid geometry, or a placement of such a list that is kept once. Transforms, inversions
// and whatever children inherit are resolved here.
#pragma once

#include <cstdint>
#include <vector>

#include "base/bounds.h"
#include "base/diagnostic.h"
#include "scene/scene.h"
#include "tracer/geometry.h"
#include "tracer/placements.h"
#include "tracer/sharing.h"

namespace durer::tracer {

/// One primitive as placed.
struct FlatLeaf {
  const scene::Object* object = nullptr;
  SharedTransform to_world;
  bool inverted = false;
  bool muted = false;  // part of a clip: its surface is never seen
  bool by_uv = false;  // its texture lies on the surface: see PrimitiveType::place_for_uv
  std::uint8_t mask = 0;
  std::uint32_t gate = scene::none;  // index into Flat::gates
  std::uint32_t leaf = scene::none;  // index into Flat::leaves; none: part of a clip or bound
};

enum class Op : std::uint8_t {
  leaf,
  any,    // union: hits of every child count
  merge,  // hits inside other children do not count
  all,    // intersection: hits count inside all other children
};

/// Of whose textures a bare surface in a solid may take its own (objects §9.5).
enum class Lenders : std::uint8_t {
  all,     // those of every child that holds the point
  first,   // those of the first child, if it holds the point: a difference
  body,    // those of the first child: the others clip it
  nobody,  // a difference whose first child has no geometry
};

struct FlatNode {
  Op op = Op::leaf;
  Lenders lenders = Lenders::all;
  std::uint32_t part = scene::none;     // leaf: index into Flat::parts
  std::vector<std::uint32_t> children;  // others: indices into Flat::nodes
};

/// The object whose box tells where a camera may be inside of an entry: itself, or the union around
/// it that the oracle keeps whole.
struct BoxedObject {
  scene::ObjectId object = scene::none;
  std::uint32_t frame = 0;  // index into Flat::frames

  friend bool operator==(const BoxedObject&, const BoxedObject&) = default;
};

/// What is tested against the rest of the scene as one thing.
struct FlatEntry {
  std::uint32_t node = scene::none;
  std::uint32_t interior = 0;                // of the object as a whole
  std::uint32_t placement = scene::none;     // instead of a node: index into Flat::placements
  BoxedObject boxed;
};

/// All that stands in one space: in the world, or in contents that are placed many times. These
/// number their interiors on their own; 0 is the one that they receive from outside.
struct FlatGroup {
  std::vector<FlatEntry> entries;
  std::vector<InteriorInstance> interiors;
};

/// `bounded_by`: a ray must meet the box and each of these trees, and pass the outer gate.
struct FlatGate {
  Bounds3 box = Bounds3::everything();
  std::vector<std::uint32_t> nodes;
  std::uint32_t outer = scene::none;
};

struct Flat {
  const scene::Scene* scene = nullptr;  // where boxes of objects matter
  FlatGroup world;
  std::vector<FlatGroup> groups;  // contents that are kept once; those within others come first
  std::vector<Placement> placements;

  std::vector<Leaf> leaves;
  std::vector<Surface> surfaces;
  std::vector<scene::Light> lights;
  std::vector<std::vector<std::uint32_t>> lamp_sets;  // see Surface::lamps
  std::vector<Projection> projections;
  std::vector<PhotonTarget> photon_targets;

  std::vector<FlatLeaf> parts;
  std::vector<FlatNode> nodes;
  std::vector<FlatGate> gates;
  std::vector<Transform> frames{Transform()};  // from spaces around objects to that of their group
  std::vector<std::uint32_t> cutaways;  // nodes whose leaves have Surface::cutaway
  int noise_generator = 2;  // of functions that are shapes
};

/// Reports every object that cannot be rendered; the result is then incomplete.
[[nodiscard]] Flat flatten(const scene::Scene& scene, Diagnostics& diagnostics,
                           const SharingLimits& limits = {});

/// The same for one object of the scene, as if it stood alone and could be seen by everything.
[[nodiscard]] Flat flatten_object(const scene::Scene& scene, scene::ObjectId object,
                                  Diagnostics& diagnostics, const Transform& to_world = {});

}  // namespace durer::tracer
