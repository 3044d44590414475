// Media, compiled: what fills bodies and the space between them (participating-and-global §1).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/media.h"
#include "tracer/shading/pigment.h"

namespace durer::tracer {

/// One medium, in world space. Coefficients are those where its density is 1, per unit of length.
struct MediaProgram {
  vec3 emission{0.0F};
  vec3 scattering{0.0F};
  vec3 extinction{0.0F};  // by absorption and scattering together
  scene::Phase phase = scene::Phase::isotropic;
  double eccentricity = 0;
  bool collects = true;  // takes part in photon mapping
  bool scatters = false;
  bool dims = false;         // absorbs or scatters
  bool has_density = false;  // density statements; `constant` may hold all the same
  /// Its last density, which speaks for all of them, is a plain colour; or it has none.
  bool constant = true;
  bool varies = false;  // some density is a pattern
  vec3 density{1.0F};   // product of the densities that are plain colours
  std::uint32_t first_density = 0;  // the others, cheap ones first
  std::uint32_t end_density = 0;

  int method = 3;
  int intervals = 1;
  int min_samples = 10;
  int max_samples = 10;
  double ratio = 0.9;
  double jitter = 0;
  double aa_threshold = 0.1;
  int aa_level = 3;
  /// Methods 1 and 2 go on after n samples while their variance is at least thresholds[n - 1].
  std::vector<double> thresholds;
};

/// Some of the media of a MediaStore.
struct MediaRange {
  std::uint32_t first = 0;
  std::uint32_t end = 0;
  [[nodiscard]] bool empty() const { return first == end; }
};

/// All media of a compiled scene.
class MediaStore {
 public:
  explicit MediaStore(const scene::Settings& settings = {}) : pigments_(settings) {}

  /// `to_world` leads from the space around the media to the world.
  MediaRange add(std::span<const scene::Media> media, const Transform& to_world);

  [[nodiscard]] const MediaProgram& operator[](std::uint32_t i) const { return media_[i]; }
  [[nodiscard]] bool empty() const { return media_.empty(); }

  /// Density of one of its media at a world point, by colour.
  [[nodiscard]] vec3 density(const MediaProgram& media, dvec3 p) const;
  /// The same at several points, at most `most_points`.
  static constexpr std::size_t most_points = PigmentStore::most_points;
  void densities(const MediaProgram& media, std::span<const dvec3> points, vec3* out) const;

 private:
  PigmentStore pigments_;
  std::vector<MediaProgram> media_;
  std::vector<PigmentId> densities_;
};

/// How much of the light that arrives from a lamp is scattered along a ray, relative to scattering
/// in all directions alike. `cosine`: of the angle between ray and the way to the lamp, -1…1.
[[nodiscard]] double phase_factor(const MediaProgram& media, double cosine);
/// The mean of that over all directions: near 1.
[[nodiscard]] double mean_phase_factor(const MediaProgram& media);
/// A random cosine, as dense in directions as `phase_factor` is large. `u`: random, 0…1.
[[nodiscard]] double phase_cosine(const MediaProgram& media, dvec2 u);

}  // namespace durer::tracer
