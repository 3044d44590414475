// Light along random paths: the whole of it, from all surfaces, lamps, the sky and media, without
// bias where docs/path-tracing.md does not say otherwise.
#pragma once

#include <vector>

#include "tracer/render.h"
#include "tracer/sobol.h"
#include "tracer/transport/emitters.h"
#include "tracer/transport/trace.h"

namespace durer::tracer {

/// Follows paths of one thread. A surface is what the ordinary tracer takes it for, with two lobes
/// more: light of all surfaces is scattered as that of lamps is.
class PathTracer {
 public:
  PathTracer(const CompiledScene& scene, Scratch& scratch, bool alpha, const PathRules& rules)
      : scene_(&scene), scratch_(&scratch), tracer_(scene, scratch, alpha), alpha_(alpha), rules_(rules) {}

  /// What one random path finds; the mean over many is the light that comes along the ray.
  [[nodiscard]] Radiance trace(const Path& path, SobolSampler& random);

 private:
  using View = Tracer::View;
  using LayerPoint = Tracer::LayerPoint;

  // A path, and what has become of its light.
  struct Walk {
    Path path;
    vec3 light{0.0F};
    vec3 throughput{1.0F};
    float clear = 1;  // of the picture's alpha channel
    int bounces = 0;
    std::uint32_t steps = 0;  // surfaces met
    // Where its direction was chosen, and how dense such directions were; 0: there was no choice.
    dvec3 from{0.0};
    double density = 0;
  };
  // A layer of the surface, and what those before it let through.
  struct Coat {
    LayerPoint layer;
    vec3 through{1.0F};
    vec3 rho{0.0F};  // mirrored
  };
  enum class LobeKind : std::uint8_t { diffuse, phong, specular, mirror, beyond };
  // A way on from a surface.
  struct Lobe {
    LobeKind kind = LobeKind::diffuse;
    bool back = false;  // of a diffuse one: to the other side of the surface
    std::uint32_t coat = 0;
    double share = 0;  // chance to be chosen
  };
  // One surface on the path.
  struct Vertex {
    const View* view = nullptr;
    Tracer::LayerSum layers;
    vec3 glow{0.0F};
    Path beyond;  // the path behind the surface, if it lets light through
    Tracer::Step step;
    vec3 hue{1.0F};
    bool scatters = false;
  };
  // Media at one place, all together, per unit of length.
  struct Matter {
    vec3 extinction{0.0F};
    vec3 emission{0.0F};
    vec3 scattering{0.0F};
  };
  // How a lamp is seen: where its light comes from for shading, and for shadows.
  struct LampView {
    Incidence shading;
    Incidence shadow;
  };
  // One of several, drawn in proportion to weights that are not known beforehand.
  struct Draw {
    double rest = 0;  // random, 0…1
    double total = 0;
    double own = 0;  // weight of the chosen one; 0: none yet

    bool take(double weight) {
      if (!(weight > 0)) return false;
      total += weight;
      const double chance = weight / total;
      const bool taken = rest < chance;
      rest = taken ? rest / chance : (rest - chance) / (1 - chance);
      if (taken) own = weight;
      return taken;
    }
    [[nodiscard]] float factor() const { return static_cast<float>(total / own); }
  };

  // False when the path ends.
  bool step(Walk& walk);
  bool interact(Walk& walk, const View& view);
  bool leave(Walk& walk, const Vertex& vertex);
  bool survives(Walk& walk);
  [[nodiscard]] float chance_weight(const Walk& walk) const;

  // path_surface.cpp
  [[nodiscard]] View see(const Hit& hit, dvec3 d);
  [[nodiscard]] vec3 glow(const View& view, const Containment& inside) const;
  void survey(Vertex& vertex, const Path& path);
  void find_lobes(Vertex& vertex);
  void look_beyond(Vertex& vertex, const Path& path);
  [[nodiscard]] vec3 scattered(const View& view, dvec3 d) const;
  [[nodiscard]] double density(const View& view, dvec3 d) const;
  [[nodiscard]] dvec3 direction(const View& view, const Lobe& lobe);
  [[nodiscard]] static Containment behind(const View& view, Containment inside, dvec3 d);

  // path_lights.cpp
  [[nodiscard]] vec3 lamp_light(const View& view, const Containment& inside);
  [[nodiscard]] vec3 lit(const View& view, const Light& light, const LampAtPoint& lamp,
                         bool grain) const;
  [[nodiscard]] static LampView view_lamp(const Light& light, const Incidence& in, dvec3 p,
                                          dvec2 place, bool spread);
  [[nodiscard]] vec3 emitter_light(const View& view, const Containment& inside);
  [[nodiscard]] Aim aim_for_light(dvec3 p);
  [[nodiscard]] vec3 light_along(const Ray& ray, const Containment& inside);

  // path_media.cpp
  struct Drift;
  bool cross(Walk& walk, const Hit* hit);
  static void see_through(Walk& walk, const Veil& veil);
  bool drift(Walk& walk, double depth, std::uint32_t lamps);
  void list_media(const Containment& inside, bool met);
  [[nodiscard]] Matter matter_at(dvec3 p) const;
  [[nodiscard]] bool media_vary() const;
  [[nodiscard]] int march_steps() const;
  [[nodiscard]] Drift evenly(const Ray& ray, double depth);
  [[nodiscard]] Drift unevenly(const Ray& ray, double depth);
  [[nodiscard]] vec3 kept(const Ray& ray, double depth, const Containment& inside, bool met);
  [[nodiscard]] vec3 lamp_light_in_media(dvec3 p, dvec3 d, std::uint32_t lamps,
                                         const Containment& inside);
  [[nodiscard]] vec3 emitter_light_in_media(dvec3 p, dvec3 d, const Containment& inside);
  [[nodiscard]] double scattering_size(std::uint32_t media, dvec3 p) const;
  [[nodiscard]] double phase_density(dvec3 p, double cosine) const;
  [[nodiscard]] dvec3 phase_direction(dvec3 p, dvec3 d);

  const CompiledScene* scene_;
  Scratch* scratch_;
  Tracer tracer_;
  bool alpha_;
  PathRules rules_;
  SobolSampler* random_ = nullptr;
  // Of the present surface; they grow once.
  std::vector<Coat> coats_;
  std::vector<Lobe> lobes_;
  std::vector<std::uint32_t> media_;  // of the present piece of the path
};

}  // namespace durer::tracer
