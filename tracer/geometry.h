// All geometry of a scene, flattened into world space, behind the few questions that light
// transport asks. Everything above this line is shading; everything below is shapes, CSG and
// hierarchy.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/bounds.h"
#include "base/diagnostic.h"
#include "base/ray.h"
#include "scene/scene.h"
#include "tracer/accel/casters.h"
#include "tracer/photon_traits.h"
#include "tracer/query.h"
#include "tracer/sharing.h"

namespace durer::tracer {

struct Placement;

/// One primitive as placed in the world.
struct Leaf {
  std::uint32_t surface = 0;  // index into Geometry::surfaces()
  /// The interior *instance*, as its space numbers them: Hit::interior is what to compare.
  std::uint32_t inner_interior = 0;
  scene::OriginId origin = 0;
  float importance = 1;  // to rays that gather indirect light, 0…1
};

/// What shared contents receive from outside: see Placement::surface.
inline constexpr scene::TextureId texture_of_placement = scene::none - 1;

/// What a leaf looks like. Transforms are resolved: texture space → world.
struct Surface {
  /// Never none: inheritance and defaults are resolved. Of shared contents this may be
  /// `texture_of_placement`, and others lie in the space of the contents.
  scene::TextureUse texture;
  scene::TextureUse interior_texture;  // none: same as `texture`
  bool double_illuminate = false;
  bool uv_mapping = false;  // textures are looked up at (u, v, 0), and have no place of their own
  /// Textures of single faces (scene::Mesh::textures), and where they lie. Null: the object has
  /// none.
  const std::vector<scene::TextureId>* part_textures = nullptr;
  SharedTransform part_transform;
  std::uint32_t lamps = 0;  // who lights it: index into Geometry::lamp_sets()
  PhotonTraits photons;
  std::uint32_t cutaway = scene::none;  // not none: it looks like what it lies in
};

/// A lamp that shines through an object, which is not seen otherwise.
struct Projection {
  std::uint32_t light = 0;  // index into Geometry::lights()
  scene::ObjectId object = scene::none;
  Transform to_world;
};

/// One body of matter. Objects that share an instance toggle it (objects §8.6).
struct InteriorInstance {
  scene::InteriorId interior = scene::none;  // none: ior 1, no fading
  bool hollow = false;
  SharedTransform to_world = {};           // from the space of its media
  scene::TextureId texture = scene::none;  // of the last leaf around it; none: there is no leaf
};

struct Hit {
  double t = no_hit_depth;  // along the ray, world units
  std::uint32_t leaf = 0;
  std::uint32_t interior = 0;  // index into Geometry::interiors()
  dvec3 p{0.0};                // world point
  dvec3 n{0.0, 1.0, 0.0};  // world unit normal, outward; negated for inverted and subtracted leaves
  // What of the scene was hit, for those who want to know more of that place.
  const Store* store = nullptr;
  std::uint32_t shape = 0;
  std::uint32_t part = 0;
  /// The way down to what was hit, outermost placement first, and the point in their spaces.
  std::uint32_t depth = 0;
  std::array<std::uint32_t, max_placement_depth> path;
  std::array<dvec3, max_placement_depth> inner;

  /// The point in the space of the outermost `levels` placements.
  [[nodiscard]] dvec3 at(std::uint32_t levels) const { return levels == 0 ? p : inner[levels - 1]; }
};

/// What a ray may see (shading §5.5).
enum class RayKind : std::uint8_t {
  image,         // camera rays
  transmission,  // what they see through something
  reflection,    // rays that were reflected at least once
  shadow,
  gathering,  // rays that gather indirect light, and all that follow from them
};

/// Rays by number, a bit for each of a packet.
using RaySet = std::uint32_t;

/// A ray that asks what it meets in t_from <= t < t_to, and the answer: `hit`, if `met`.
struct MeetingRay {
  const Ray* ray = nullptr;  // |d| = 1
  double t_from = 0;
  double t_to = 0;
  bool met = false;
  Hit hit{};
};
/// What rays of a packet meet that all ask one object.
struct PacketMeeting {
  RaySet met = 0;
  // Of those that met it: one after the other, with unit normals as in Hit.
  PacketPoints points;
  PacketVectors normals;
  PerRay<double> t;
  // What it is.
  std::uint32_t leaf = 0;
  std::uint32_t interior = 0;
  std::uint32_t shape = 0;
  const Store* store = nullptr;

  /// All of a hit, by number among these.
  void fill_in(std::size_t number, Hit& hit) const;
};
/// A ray that asks if an opaque, shadow-casting surface lies in t_from < t < t_to, and the answer.
struct ShadowRay {
  Ray ray;
  double t_from = 0;
  double t_to = 0;
  bool blocked = false;
};

/// Buffers of one thread; geometry queries allocate nothing once these have grown.
struct GeometryScratch;
struct DeleteGeometryScratch {
  void operator()(GeometryScratch* s) const;
};
using GeometryScratchPtr = std::unique_ptr<GeometryScratch, DeleteGeometryScratch>;

/// Which hierarchy to build; `linear` asks every object and is there for tests.
enum class Hierarchy : std::uint8_t { embree, linear };

class Geometry {
 public:
  Geometry(Geometry&&) noexcept;
  Geometry& operator=(Geometry&&) noexcept;
  ~Geometry();

  /// Flattens the scene's objects (transforms, inheritance of textures and interiors, objects §8
  /// and §9.3), fills the stores and builds the hierarchies. Reports what cannot be rendered.
  [[nodiscard]] static std::optional<Geometry> build(const scene::Scene& scene,
                                                     Diagnostics& diagnostics,
                                                     Hierarchy hierarchy = Hierarchy::embree,
                                                     const SharingLimits& limits = {});

  /// One object of the scene alone, visible to every kind of ray.
  [[nodiscard]] static std::optional<Geometry> build_object(const scene::Scene& scene,
                                                            scene::ObjectId object,
                                                            Diagnostics& diagnostics,
                                                            const Transform& to_world = {});

  [[nodiscard]] std::span<const Leaf> leaves() const;
  [[nodiscard]] std::span<const Surface> surfaces() const;
  [[nodiscard]] std::span<const InteriorInstance> interiors() const;
  [[nodiscard]] std::span<const Placement> placements() const;
  /// Lights of the scene and of its objects, in world space, in order of declaration.
  [[nodiscard]] std::span<const scene::Light> lights() const;
  /// Who lights surfaces: lists of indices into lights(), the scene's own before those of light
  /// groups. Set 0 is for all that is in no group.
  [[nodiscard]] std::span<const std::vector<std::uint32_t>> lamp_sets() const;
  [[nodiscard]] std::span<const Projection> projections() const;
  /// Objects that photons are sent to by lamps in no light group; none if photons are off.
  [[nodiscard]] std::span<const PhotonTarget> photon_targets() const;

  /// Tells of every part of the surfaces that stand in the world itself, not in shared contents,
  /// and the box around it.
  void for_surfaces(const std::function<void(const Leaf&, const Bounds3&)>& visit) const;

  /// What came to light about primitives while rays asked them: see Store::doubt. Each message once
  /// per object of the scene.
  struct Doubt {
    scene::OriginId origin;
    std::string message, remedy;
  };
  [[nodiscard]] std::vector<Doubt> doubts() const;

  /// Tells which surfaces stop all light, so that `occluded` can end at the first of them.
  void set_opaque(std::vector<bool> by_surface);

  [[nodiscard]] GeometryScratchPtr make_scratch() const;

  /// Nearest hit with t_from <= t < t_to visible to `kind`. `ray.d` has unit length.
  bool closest(const Ray& ray, double t_from, double t_to, RayKind kind, Hit& hit,
               GeometryScratch& scratch) const;

  /// True if some objects answer several rays faster together than one by one.
  [[nodiscard]] bool answers_together() const;
  /// `closest` for up to most_in_packet rays, neighbours if possible: the same hits, bit for bit,
  /// as long as surfaces do not coincide and bounds do not cut what they bound.
  void closest(std::span<MeetingRay> rays, RayKind kind, GeometryScratch& scratch) const;
  /// True if all rays ask one object, and nobody else: then those of a packet (at least one) meet
  /// the same hits here.
  [[nodiscard]] bool is_one_object() const;
  void closest(const PacketRays& rays, RayKind kind, PacketMeeting& out) const;

  /// Surface coordinates at a hit (objects §14).
  [[nodiscard]] static dvec2 uv(const Hit& hit);
  /// Which of the surface's part_textures are seen at a hit.
  [[nodiscard]] static TextureBlend part_textures(const Hit& hit);
  /// Of a hit on a surface with Surface::cutaway: the surfaces that lend it their textures. Where
  /// there is nobody, two parts of no weight.
  [[nodiscard]] TextureBlend cutaway_textures(const Hit& hit, bool from_inside) const;

  /// True if an opaque, shadow-casting surface lies in t_from < t < t_to.
  bool occluded(const Ray& ray, double t_from, double t_to, GeometryScratch& scratch) const;

  /// The same for up to most_in_packet rays, neighbours if possible.
  void occluded(std::span<ShadowRay> rays, GeometryScratch& scratch) const;
  /// The same for those of a packet that are asked; returns who is blocked. Uses the ranges of all
  /// of them up; others have to be rays as well.
  [[nodiscard]] RaySet occluded(PacketRays& rays, RaySet asked, GeometryScratch& scratch) const;

  /// What may cast shadows into a shaft; false, with some of them, if they are too many to ask one
  /// by one.
  bool casters(const Shaft& shaft, std::vector<Caster>& out) const;
  /// Likewise for a sheet.
  bool casters(const Sheet& sheet, std::vector<Caster>& out) const;
  /// What is in the way of light.
  enum class Way : std::uint8_t { open, blocked, unknown };
  /// Of a ray in t_from < t < t_to, where only `among` can be: `unknown` if it comes near somebody
  /// who may let light through.
  [[nodiscard]] Way way_between(std::span<Caster> among, const Ray& ray, double t_from, double t_to,
                                GeometryScratch& scratch) const;
  /// The same as `occluded`, where only `among` can be in the way. Whoever is, is moved to their
  /// front.
  bool occluded_by(std::span<Caster> among, const Ray& ray, double t_from, double t_to,
                   GeometryScratch& scratch) const;

  /// True if some shadow-casting surface is not opaque: then the shadow rays that `occluded` lets
  /// through must be walked with `closest(RayKind::shadow)`.
  [[nodiscard]] bool has_translucent_shadows() const;

  /// Appends the interior instances of all top-level objects that contain `p`, in order of
  /// declaration (shading §2.8).
  void containing(dvec3 p, std::vector<std::uint32_t>& interiors, GeometryScratch& scratch) const;

 private:
  struct State;
  explicit Geometry(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace durer::tracer
