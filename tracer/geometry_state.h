// What a Geometry holds. Built once (geometry_build.cpp), then only read.
#pragma once

#include <atomic>
#include <mutex>

#include <limits>
#include <memory>
#include <vector>

#include "tracer/accel/accel.h"
#include "tracer/accel/box_tree.h"
#include "tracer/csg/cutaway.h"
#include "tracer/csg/solid_targets.h"
#include "tracer/csg/sweep.h"
#include "tracer/flatten.h"
#include "tracer/geometry.h"
#include "tracer/placements.h"
#include "tracer/primitives/describe.h"

namespace durer::tracer {

/// An object as `containing` needs it.
struct Body {
  enum class Kind : std::uint8_t { primitive, solid, placement };
  Kind kind = Kind::primitive;
  bool inverted = false;
  std::uint32_t index = 0;  // shape, index into Parts::solids, or number of the placement
  std::uint32_t interior = 0;
  const Store* store = nullptr;     // of a primitive
  std::uint32_t box = scene::none;  // index into Group::boxes; none: nothing is known
};

/// All that stands in one space: in the world, or in contents that are placed many times.
struct Group {
  std::vector<TypeStores> lone;  // per primitive type: those that stand alone
  std::unique_ptr<SolidTargets> solids;
  std::unique_ptr<PlacementTargets> placements;
  std::unique_ptr<Accel> accel;

  std::vector<Body> bodies;  // in order of declaration
  /// Of objects with an endless inside but a surface that ends, such as discs and what is inverse:
  /// the oracle does not ask for their inside beyond the box of the surface (shading §2.8).
  std::vector<Bounds3> boxes;
  bool reaches_far = false;  // some inside is endless, with a box or without
  Bounds3 inside;            // no point is inside of any of them outside of this
  /// Where bodies are, for those who ask often: most scenes ask once, where their camera is, and
  /// are better off without. Made on demand by index_bodies().
  struct Index {
    BoxTree boxes;  // of the bodies that are finite …
    std::vector<std::uint32_t> body_of_box;
    std::vector<std::uint32_t> endless;  // … and the others
  };
  mutable std::atomic<int> questions{0};
  mutable std::once_flag index_made;
  mutable Index index;

  Group(const Parts& parts, const std::vector<Placement>& all,
        const std::vector<PlacementTargets::Contents>& contents);
  /// Everything that the hierarchy holds.
  [[nodiscard]] std::vector<const Targets*> targets() const;
};

/// What a kind of ray may see, as Visibility.
[[nodiscard]] inline std::uint8_t mask_of(RayKind kind) {
  switch (kind) {
    case RayKind::image: return seen_by_image;
    case RayKind::transmission: return seen_by_transmission;
    case RayKind::reflection: return seen_by_reflection;
    case RayKind::shadow: return casts_shadow;
    case RayKind::gathering: return seen_by_gathering;
  }
  return 0;
}

struct GeometryScratch {
  explicit GeometryScratch(const Parts& parts) : sweep(parts.make_state()) {}

  SweepState sweep;
  std::vector<std::uint32_t> bodies;
  // Of rays that go side by side.
  Packet<RayQuery> queries;
  Packet<ShadowRay> shadow_rays;
  PutOff put_off;
};

struct Geometry::State {
  std::vector<Leaf> leaves;
  std::vector<std::uint8_t> leaf_inverted;  // normals are negated
  std::vector<Surface> surfaces;
  std::vector<InteriorInstance> interiors;
  std::vector<scene::Light> lights;
  std::vector<std::vector<std::uint32_t>> lamp_sets;
  std::vector<Projection> projections;
  std::vector<PhotonTarget> photon_targets;
  std::vector<Cutaway> cutaways;

  std::vector<TypeStores> operands;  // per primitive type: those inside solids, clips and bounds
  Surroundings around;
  Parts parts;
  std::vector<Placement> placements;
  std::vector<std::unique_ptr<Group>>
      groups;  // those within others come first; the last: the world
  std::vector<PlacementTargets::Contents> contents;  // of the groups
  const Accel* accel = nullptr;                      // of the world
  mutable std::once_flag casters_found;
  mutable CasterIndex casters;  // of the world
  bool translucent_shadows = true;
  bool answers_together = false;  // some object of the world answers several rays together

  State(Flat flat, Hierarchy hierarchy);
  [[nodiscard]] const Group& world() const { return *groups.back(); }
  /// Appends the interiors of all bodies of the group that contain `p`, in the group's numbering.
  void containing(const Group& group, dvec3 p, std::vector<std::uint32_t>& out,
                  std::vector<std::uint32_t>& found, SweepState& sweep) const;
  /// Made when somebody asks for it. Thread-safe.
  [[nodiscard]] const CasterIndex& caster_index() const;
  void set_opaque(const std::vector<bool>& by_surface);

  [[nodiscard]] RayQuery query(const Ray& ray, double t_from, double t_to, RayKind kind,
                               GeometryScratch& scratch) const {
    return {ray, t_from, t_to, &parts, &scratch.sweep, nullptr, {}, {}, mask_of(kind), false};
  }
  [[nodiscard]] static double after(double t) {
    return t * (1 + std::numeric_limits<double>::epsilon());
  }
  /// Of what stops light behind t_from.
  [[nodiscard]] RayQuery shadow_query(const Ray& ray, double t_from, double t_to,
                                      GeometryScratch& scratch) const {
    return {ray, after(t_from), t_to, &parts, &scratch.sweep, nullptr, {}, {}, blocks_light, true};
  }
  /// All of a hit but its normal and, in shared contents, the way down.
  void fill_in(const RayQuery& query, Hit& hit) const {
    const Found& found = query.found;
    hit.t = query.t_to;
    hit.leaf = found.leaf;
    hit.store = found.store;
    hit.shape = found.shape;
    hit.part = found.part;
    hit.p = query.ray.at(hit.t);
    hit.interior = leaves[found.leaf].inner_interior;
    hit.depth = found.depth;
  }
  /// Fills in what a hit in shared contents knows of the spaces around them, and its normal.
  void resolve_path(const PlacementPath& inner_first, Hit& hit) const;
  /// From the normal of the primitive to that of the object.
  void orient(Hit& hit) const {
    if (leaf_inverted[hit.leaf] != 0) hit.n = -hit.n;
  }
  // Rays that all ask one object and nobody else (geometry_together.cpp).
  [[nodiscard]] Accel::Companion only_companion() const;
  void closest_on(const Accel::Companion& one, const PacketRays& rays, RayKind kind,
                  PacketMeeting& out) const;
  [[nodiscard]] RaySet occluded_by(const Accel::Companion& one, PacketRays& rays,
                                   RaySet asked) const;
  /// The normals of hits in the world itself (geometry_together.cpp).
  void add_normals(std::span<MeetingRay> rays) const;
  void add_normals_of_shape(std::span<Hit* const> hits) const;
  template <typename F>
  void each_store(F&& f) const {
    const auto each = [&f](const std::vector<TypeStores>& all) {
      for (const TypeStores& s : all) {
        f(*s.baked);
        f(*s.placed);
      }
    };
    for (const auto& group : groups) each(group->lone);
    each(operands);
  }

 private:
  [[nodiscard]] bool contains(const Body& body, dvec3 p, SweepState& sweep) const;
  [[nodiscard]] bool reaches_far(const Body& body) const;
  void add_box(Group& group, const Flat& flat, const BoxedObject& boxed) const;
  [[nodiscard]] Bounds3 inside_bounds(const Body& body) const;
  /// Thread-safe; does nothing the second time.
  void index_bodies(const Group& group) const;
  void add_group(const Flat& flat, const FlatGroup& from);
  void finish_group(Group& group, PlacementTargets::Contents& result, Hierarchy hierarchy);
  void update_masks();
  void add_gates(const Flat& flat);
  void add_cutaways(const Flat& flat);
  void add_entry(Group& group, const Flat& flat, const FlatEntry& entry);
  std::optional<ShapeRef> place(std::vector<TypeStores>& stores, const FlatLeaf& part);
};

}  // namespace durer::tracer
