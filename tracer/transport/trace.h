// Light transport: from a ray to the light that comes back along it (shading §8).
#pragma once

#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "tracer/compiled_scene.h"
#include "tracer/primitives/store.h"
#include "tracer/transport/media_parts.h"
#include "tracer/transport/path.h"
#include "tracer/transport/photons.h"
#include "tracer/transport/radiosity.h"

namespace durer::tracer {

/// One reflection that waits until the layers of its surface are summed.
struct Reflection {
  const Finish* finish = nullptr;
  dvec3 n{0.0};
  vec3 rho{0.0F};
  float weight = 0;
};

/// One lamp at the point being lit; all layers share it.
struct LampAtPoint {
  Incidence in;
  vec3 shadowed{0.0F};
  bool shadow_known = false;
};

/// One sample of a lamp of some extent.
enum class AreaSample : std::uint8_t { unknown, lit, dark, dimmed };

struct FoundSurface;
struct FoundLayer;
struct PlainLanes;
struct PlainPoints;

/// What one thread may change. Buffers grow once; tracing allocates nothing after that.
struct Scratch {
  explicit Scratch(const CompiledScene& scene);
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  GeometryScratchPtr geometry;
  std::uint64_t rays = 0;
  std::uint32_t noise = 0;         // state of random numbers, set anew for every sample
  std::vector<LampAtPoint> lamps;  // parallel to the scene's lights
  std::vector<AreaSample> area;    // of the lamp that is being asked
  std::vector<vec3> area_light;    // what is left of those that are dimmed
  std::vector<Caster> casters;     // that may stand before it
  std::vector<std::uint32_t> lit;  // lamps that reach the point being lit
  std::vector<GeometryScratchPtr> projectors;
  std::vector<Reflection> reflections;  // a stack
  std::vector<std::uint32_t> containing;
  RadiosityState radiosity;
  std::vector<std::uint32_t> media;               // a stack: those that are being integrated
  std::vector<LampSpan> lamp_spans;               // of the ray whose media are being integrated
  std::vector<std::vector<Caster>> lamp_casters;  // parallel to lamp_spans, as far as needed
  std::vector<LitPart> lit_parts;
  std::array<MediaSamples, 2> media_samples;  // of rays, and of shadow rays that they send out
  const PhotonMaps* photons = nullptr;        // if there are any
  int below = 0;                              // how many looks below surfaces are going on
  FoundPhotons near_photons;                  // around the point being lit
  FoundPhotons media_photons;                 // likewise, in media
  dvec3 left_normal{0.0};  // as patterns saw it last, in the part of a mixed texture shown last
  std::vector<FoundSurface> found;  // by rays that are followed side by side
  std::vector<FoundLayer> found_layers;
  std::vector<MeetingRay> meeting;  // likewise
};

/// Traces rays of one thread.
class Tracer {
 public:
  /// `alpha`: see RenderOptions.
  Tracer(const CompiledScene& scene, Scratch& scratch, bool alpha);

  [[nodiscard]] Radiance trace(const Path& path) {
    Path own = path;
    return follow(own, false);
  }
  /// The same for a path that nobody needs any more.
  [[nodiscard]] Radiance trace(Path&& path) { return follow(path, false); }

  /// The same for up to `most_together` rays of the picture, neighbours if possible, side by side.
  /// Uses their paths up.
  static constexpr std::size_t most_together = most_in_packet;
  void trace(std::span<Sample> samples);
  /// The same for samples whose paths are not made yet: all are `start`, but for their rays, one
  /// for each sample, which see what is between nearest_seen and the reach of `start`.
  void trace(const Path& start, const PacketRays& rays, std::span<Sample> samples);
  /// How near the surface may be that a ray of the picture sees.
  static constexpr double nearest_seen = t_min;

 private:
  friend class MediaIntegrator;
  friend class PathTracer;
  friend class PhotonTracer;
  friend struct FoundSurface;
  // A layer at a point: its normal, and what it looks like.
  struct LayerLook {
    const dvec3* n = nullptr;
    const Colour* colour = nullptr;
  };
  // A surface that is being looked at. What look() always sets is not cleared before: there is one
  // of these for every hit.
  struct View {
    dvec3 p;
    dvec3 q;        // where textures are looked up: p, or (u, v, 0)
    dvec3 uv{0.0};  // (u, v, 0) if a layer asks for it
    dvec3 d;
    dvec3 g;     // unit geometric normal, towards the viewer
    dvec3 seen;  // the same as patterns see it: bent, if an entry of the same map came before
    const TextureProgram* texture = nullptr;
    std::uint32_t interior = 0;
    std::uint32_t lamps = 0;           // index into Geometry::lamp_sets()
    double depth = 0;                  // from the ray's origin
    std::span<const LayerLook> known;  // the first layers, if they were looked up before
    bool double_illuminate = false;
    bool gathering = false;  // seen by a ray that gathers indirect light
    bool collects = true;    // shows photons
    /// Spaces of the patterned textures around `texture`, outermost first.
    std::uint32_t frame_count = 0;
    /// Spaces of the placements around the texture, outermost first; `q` lies in the last one.
    std::uint32_t places = 0;
    std::array<const NormalFrame*, max_texture_depth> frames;
    std::array<const Transform*, max_placement_depth> spaces;
  };
  // What the layers of a surface send out, and let through.
  struct LayerSum {
    dvec3 top{0.0};  // normal of the outermost layer
    vec3 colour{0.0F};
    vec3 through{1.0F};
    float sigma = 1;  // scalar transparency
  };
  // One layer at a point.
  struct LayerPoint {
    const Finish* finish = nullptr;
    float opacity = 1;
    dvec3 n{0.0};
    vec3 pigment{0.0F};
  };
  // Light from one surface; when `continues`, the path has been turned into the transmitted ray.
  struct Step {
    vec3 colour{0.0F};
    vec3 through{0.0F};
    float transmittance = 0;
    bool continues = false;
    bool straight = false;
    bool tir = false;  // totally reflected inside
    dvec3 left{0.0};   // the normal as patterns of a mixed texture saw it last
  };

  // A point that a lamp of some extent may light, and a part of that lamp's grid.
  struct AreaShadow {
    const Light& light;
    const Incidence& centre;
    AreaGrid grid;
    dvec3 p;
    const Containment& inside;
    bool collects = false;  // photons bring the light that targets bend
    bool few = false;       // Scratch::casters has all that can be in between
  };
  // How somebody sees a lamp.
  struct Receiver {
    bool as_point = false;  // areas are points
    bool collects = false;  // photons bring the light that targets bend
  };
  struct AreaPart {
    int u1, v1, u2, v2;
  };

  // A surface whose texture is still to be chosen: `view.texture` is that of the whole object.
  struct Look {
    View view;
    TextureBlend blend;  // of CompiledScene::part_textures; empty: view.texture it is
    const SurfaceProgram* surface = nullptr;
  };

  // What a path has gathered so far, and what it can still add to that.
  struct Along {
    vec3 sum{0.0F};
    vec3 through{1.0F};
    float transmittance = 1;

    void add(const Step& step) {
      sum += through * step.colour;
      transmittance *= step.transmittance;
    }
    [[nodiscard]] Radiance ends_with(const Radiance& r) const {
      return {sum + through * r.colour, transmittance * r.transmittance};
    }
  };

  [[nodiscard]] Radiance follow(Path& path, bool straight) {
    Along along;
    return follow(path, straight, along);
  }
  [[nodiscard]] Radiance follow(Path& path, bool straight, Along& along);
  void pass_air(const Path& path, const Hit* hit, Along& along);
  [[nodiscard]] bool is_mixed(Look& look) const {
    return look.blend.count > 1 || (look.view.texture->patterned() && is_patterned(look.view));
  }
  [[nodiscard]] bool is_patterned(View& view) const;
  [[nodiscard]] Radiance mixed(const Look& look, const Hit& hit, const Path& path);
  [[nodiscard]] Radiance blend(const Look& look, const Hit& hit, const Path& path);
  [[nodiscard]] Look look(const Hit& hit, const dvec3& d) const;
  inline void look(const Hit& hit, const dvec3& d, Look& found) const;
  void look_closer(const Hit& hit, bool from_inside, Look& found) const;
  [[nodiscard]] ProgramId texture_at(const Hit& hit, const SurfaceProgram& surface,
                                     bool from_inside, std::uint32_t& places) const;
  void dress(View& view, const Look& look, const Hit& hit, std::uint32_t texture) const;
  [[nodiscard]] Radiance shown(const View& view, const Path& path);
  // together.cpp
  [[nodiscard]] bool sees_plainly() const {
    return together_ && plain_ && opaque_shadows_ && !in_air_;
  }
  [[nodiscard]] std::uint32_t meet_one(const Path& start, const PacketRays& rays,
                                       std::span<Sample> samples);
  [[nodiscard]] std::uint32_t meet_any(const Path& start, const PacketRays& rays,
                                       std::span<Sample> samples);
  void light_found(std::span<Sample> samples, std::span<FoundSurface*> waiting, bool plainly);
  [[nodiscard]] bool meet(std::span<Sample> samples);
  [[nodiscard]] bool find(Sample& sample, FoundSurface& found);
  [[nodiscard]] bool find_met(Sample& sample, const MeetingRay& ray, FoundSurface& found);
  [[nodiscard]] inline bool see(Sample& sample, bool met, const Hit& hit, FoundSurface& found);
  inline void see_sky(const dvec3& d, Sample& sample) const;
  void look_up(std::span<FoundSurface* const> found, std::size_t place);
  void look_up_layer(const LayerProgram& layer, std::span<FoundSurface* const> found,
                     dvec3* normals, Colour* colours) const;
  void narrow(View& view) const;
  template <typename Visit>
  void for_parts(const View& view, Visit visit) const;
  [[nodiscard]] double choose(View& view, const TextureChoice& choice) const;
  [[nodiscard]] inline LayerLook look_at(const View& view, std::uint32_t number, SurfaceView& seen,
                                         dvec3& n, Colour& colour) const;
  [[nodiscard]] dvec3 bend(const View& view, const LayerProgram& layer, SurfaceView& seen) const;
  [[nodiscard]] Step surface(const View& view, Path& path);
  [[nodiscard]] Finish without_diffuse(const Finish& finish) const;
  [[nodiscard]] LayerSum sum_layers(const View& view, const Path& path);
  template <typename Visit>
  [[nodiscard]] LayerSum walk_layers(const View& view, float least, const Visit& visit) const;
  [[nodiscard]] float opacity(const Colour& c) const;
  // Indirect light.
  struct Gathered {
    dvec3 light{0.0};
    double quality = 0;
  };
  // That of one surface; its layers share it.
  struct Indirect {
    vec3 front{0.0F};
    vec3 back{0.0F};
    bool front_known = false;
    bool back_known = false;
  };
  // What the layers of a surface know of each other's light.
  struct LayersLight {
    Indirect around;
    bool gathers = false;
    bool photons = false;
    bool first_lit = true;  // layers may ignore the lights that others need
  };
  [[nodiscard]] inline vec3 light_of(const View& view, const Path& path, const LayerPoint& layer,
                                     const vec3& through, vec3 light, LayersLight& so_far);
  [[nodiscard]] vec3 light_of_translucent(const View& view, const Path& path,
                                          const LayerPoint& layer, const vec3& through, vec3 glow,
                                          LayersLight& so_far);
  [[nodiscard]] vec3 indirect_part(const View& view, const Path& path, const LayerPoint& layer,
                                   vec3 through, Indirect& known);
  [[nodiscard]] vec3 indirect(const View& view, dvec3 layer_normal, float weight,
                              std::uint32_t depth);
  [[nodiscard]] Gathered gather(dvec3 p, dvec3 raw, dvec3 n, std::uint32_t depth);
  [[nodiscard]] Reflectivity reflectivity_of(const View& view, const Containment& inside,
                                             const LayerPoint& layer) const;
  [[nodiscard]] static bool same_direction(dvec3 a, dvec3 b);
  vec3 remember_reflection(const View& view, const Path& path, const LayerPoint& layer,
                           float sigma);
  void transmit(const View& view, const LayerSum& layers, Path& path, Step& step);
  // A path on its way through a surface.
  struct Crossing {
    Path next;
    IndexRatio ratio;
    bool disperses = false;
    bool straight = false;  // as if nothing were there
    /// n before over n behind, at a wavelength in nm.
    [[nodiscard]] double eta(double wavelength) const;
  };
  [[nodiscard]] Crossing cross(const View& view, const LayerSum& layers, const Path& path) const;
  [[nodiscard]] std::optional<vec3> bend_path(const View& view, const LayerSum& layers,
                                              const Path& path, double eta, Path& next) const;
  [[nodiscard]] int bands(const View& view, const Crossing& crossing) const;
  [[nodiscard]] vec3 film_tint(const View& view, dvec3 n, dvec3 r) const;
  [[nodiscard]] static Path inward(const View& view, const Path& path, dvec3 n, float weight);
  [[nodiscard]] Radiance disperse(const View& view, const LayerSum& layers, const Path& path,
                                  const Crossing& crossing);
  [[nodiscard]] vec3 reflect(const View& view, const LayerSum& layers, Path& arrived,
                             std::size_t first, bool tir);
  [[nodiscard]] vec3 attenuation(const View& view, const Path& path) const;

  [[nodiscard]] bool in_the_open(const Containment& inside) const;
  [[nodiscard]] bool dims() const;
  [[nodiscard]] Veil veil(const Path& path, double depth, const Hit* hit);

  [[nodiscard]] vec3 illuminate(const View& view, const Path& path, const LayerPoint& layer,
                                bool first_lit);
  void find_lamps(const View& view);
  // Its whole area shines, not only its centre.
  [[nodiscard]] static bool spreads(const Light& light, const View& view) {
    return light.has_area && light.area.illumination && !view.gathering;
  }
  [[nodiscard]] static bool is_behind(const View& view, const LayerPoint& layer, const dvec3& l) {
    return glm::dot(layer.n, l) < epsilon && !view.double_illuminate;
  }
  [[nodiscard]] inline vec3 arriving(const View& view, const Containment& inside,
                                     const Light& light, const Incidence& in);
  [[nodiscard]] inline vec3 opaque_shadow(const Incidence& in, const dvec3& p, double way);
  // plain.cpp
  [[nodiscard]] bool is_plain(const View& view) const {
    return view.texture->plain && plain_ && !(view.collects && has_caustics());
  }
  [[nodiscard]] LayerLook look_alone(const View& view, dvec3& n, Colour& colour) const;
  void plain_light(const View& view, const Containment& inside, vec3& light);
  [[nodiscard]] inline const Finish& finish_of_plain(const TextureProgram& texture) const;
  template <typename Visit>
  inline void if_lit(std::uint32_t number, const View& view, const LayerPoint& layer,
                     const Visit& visit);
  inline void add_light(const View& view, const Containment& inside, const LayerPoint& layer,
                        const Light& lamp, const Incidence& in, bool hidden, vec3& lit);
  inline static void add_glow(const Finish& finish, const vec3& pigment, const vec3& lit,
                              vec3& light);
  // plain_together.cpp
  struct PlainKind;
  struct PlainKinds;
  struct PlainGroup;
  [[nodiscard]] std::uint32_t light_met(const Path& start, const PacketRays& rays,
                                        const PacketMeeting& meeting, std::span<Sample> samples);
  [[nodiscard]] std::uint32_t light_met(std::span<Sample> samples, const Path* start);
  void look_up(PlainGroup& group) const;
  [[nodiscard]] PlainKind kind_of(std::uint32_t leaf, bool from_inside) const;
  void light_together(std::span<Sample> samples);
  void light(PlainGroup& group);
  void add_lamp(std::uint32_t number, PlainGroup& group);
  [[nodiscard]] std::uint32_t weaken(std::uint32_t number, const PlainPoints& points,
                                     std::uint32_t open, float* shares) const;
  [[nodiscard]] std::uint32_t unblocked(PlainPoints& points, std::uint32_t open);
  void add_wide_lamp(std::uint32_t number, PlainGroup& group);
  [[nodiscard]] vec3 light_of_area(const View& view, const Containment& inside,
                                   const LayerPoint& layer, const Light& light,
                                   const Incidence& centre);
  [[nodiscard]] vec3 shade_by_area(const View& view, const LayerPoint& layer, const Light& light,
                                   const LampAtPoint& lamp);
  // Light from one direction.
  struct Beam {
    dvec3 l{0.0};
    vec3 light{0.0F};
    bool highlights = true;
  };
  // How a surface lies towards light.
  struct Facing {
    bool backside = false;
    bool highlights = true;
    bool grain = true;  // with `crand`
  };
  [[nodiscard]] inline vec3 shade_from(const View& view, const LayerPoint& layer, const dvec3& l,
                                       const vec3& light, Facing facing) const;
  /// `grain`: with `crand`.
  [[nodiscard]] vec3 shade(const View& view, const LayerPoint& layer, const Beam& beam,
                           bool backside, bool grain = true) const;
  // caustics.cpp
  void find_photons(const View& view, dvec3 n);
  [[nodiscard]] vec3 caustics(const View& view, const LayerPoint& layer);
  [[nodiscard]] vec3 any_caustics(const View& view, const LayerPoint& layer);
  [[nodiscard]] vec3 plain_caustics(const View& view, const LayerPoint& layer);
  [[nodiscard]] bool has_caustics() const {
    return scratch_->photons != nullptr && !scratch_->photons->surfaces.empty();
  }
  [[nodiscard]] bool leaves_to_photons(const Light& light, const Hit& hit) const;
  [[nodiscard]] vec3 shadowed(const Light& light, const Incidence& in, dvec3 p,
                              const Containment& inside, Receiver receiver);
  [[nodiscard]] vec3 point_shadow(const Light& light, const Incidence& in, dvec3 p,
                                  const Containment& inside, bool collects);
  [[nodiscard]] double projected(const Light& light, const Incidence& in, dvec3 p);
  [[nodiscard]] vec3 walk_shadow(const Light& light, const Incidence& in, dvec3 p, double way,
                                 Containment inside, bool collects);
  // area_shadow.cpp
  [[nodiscard]] vec3 area_shadow(const Light& light, const Incidence& in, dvec3 p,
                                 const Containment& inside, bool collects);
  [[nodiscard]] bool few_casters(const AreaShadow& lit);
  [[nodiscard]] dvec2 area_place(const AreaGrid& grid, int u, int v);
  [[nodiscard]] vec3 area_corner(const AreaShadow& lit, int u, int v);
  [[nodiscard]] AreaSample area_sample(const AreaShadow& lit, dvec2 place, std::size_t number);
  [[nodiscard]] vec3 area_part(const AreaShadow& lit, const AreaPart& part, int level);
  [[nodiscard]] vec3 shadow_factor(const Hit& hit, dvec3 l, const Containment& inside) const;
  [[nodiscard]] vec3 shadow_factor(const View& view, const Containment& inside) const;

  // media.cpp
  [[nodiscard]] MediaEffect media_along(const Path& path, double depth, const Hit* hit);
  [[nodiscard]] vec3 light_through_bodies(const Ray& ray, double depth, const Containment& inside);
  [[nodiscard]] vec3 light_through_air(const Ray& ray, double depth, const Containment& inside);
  // media_scattering.cpp
  [[nodiscard]] bool few_casters(const Light& light, const Ray& ray, double from, double to,
                                 std::vector<Caster>& out) const;
  [[nodiscard]] vec3 shadowed_by(std::span<Caster> casters, const Light& light, const Incidence& in,
                                 dvec3 p, const Containment& inside, Receiver receiver);

  // subsurface.cpp
  struct Body;
  [[nodiscard]] bool is_translucent(const View& view, const Finish& finish) const;
  [[nodiscard]] vec3 subsurface(const View& view, const Path& path, const LayerPoint& layer);
  [[nodiscard]] bool reach_surface(const Body& body, const Ray& ray, Hit& hit);
  template <typename Visit>
  void each_lamp(const Body& body, dvec3 p, dvec3 n, Visit visit);
  [[nodiscard]] dvec3 diffused(const Body& body);
  [[nodiscard]] dvec3 entering(const Body& body, dvec3 p, dvec3 n);
  // The view as it goes on below the surface, and where it ends.
  struct Below {
    Ray ray;
    Hit end;
  };
  [[nodiscard]] bool look_below(const Body& body, Below& below);
  [[nodiscard]] dvec3 scattered_once(const Body& body, const Below& below);
  [[nodiscard]] dvec3 single_light(const Body& body, dvec3 x, double inner_cosine);
  [[nodiscard]] vec3 unscattered(const Body& body, const Below& below);

  // When a path is not worth following.
  struct Limits {
    int max_level = 0;
    float adc = 0;
  };
  [[nodiscard]] const Limits& limits(const Path& path) const { return limits_[path.bounce]; }
  [[nodiscard]] bool is_worth_following(const Path& path) const {
    const Limits& limit = limits(path);
    return path.level < limit.max_level && !(path.weight < limit.adc);
  }

  const CompiledScene* scene_;
  Scratch* scratch_;
  std::span<const Leaf> leaves_;  // of the geometry
  std::span<const std::vector<std::uint32_t>> lamp_sets_;
  std::array<Limits, IrradianceCache::max_depth + 1> limits_;  // by bounce
  std::optional<Radiance> plain_sky_;  // in the picture, if it is the same everywhere
  bool alpha_;
  bool legacy_opacity_;
  bool translucent_shadows_;
  bool air_;                  // there is fog or the like …
  bool in_air_;               // … or there are media …
  bool gathers_air_ = false;  // … and rays that gather indirect light see it
  bool together_;             // rays may be followed side by side
  bool plain_;                // plain textures may be lit the short way
  bool opaque_shadows_;       // any caster of shadows stops all light
  Quality quality_;
  const PlainLanes* plain_lanes_;
};

/// A surface that a ray met, until its turn to be lit comes.
struct FoundSurface {
  static constexpr std::uint32_t most_layers = 4;

  bool waits = false;
  Tracer::Along along;                                // what is before the surface
  vec3 through{1.0F};                                 // what the layers let through
  std::array<Tracer::LayerLook, most_layers> layers;  // as far as `look.view.known` goes
  Tracer::Look look;
};

/// What layers of a texture look like at several points.
struct FoundLayer {
  std::array<dvec3, Tracer::most_together> normals;
  std::array<Colour, Tracer::most_together> colours;
};

/// Snell's law for unit `d`, from either side of `normal`; false beyond the critical angle. `eta`:
/// n before over n behind.
[[nodiscard]] bool refracted(dvec3 d, dvec3 normal, double eta, dvec3& out);

/// The mirror image of `d` about `n`, kept on the side of `g` (shading §4.8).
[[nodiscard]] dvec3 mirror(dvec3 d, dvec3 n, dvec3 g);

}  // namespace durer::tracer
