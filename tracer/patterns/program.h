// Patterns as flat programs: from a point to the value that selects in a map (textures §3, §4).
#pragma once

#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "base/floor.h"
#include "scene/pattern.h"
#include "scene/scene.h"
#include "tracer/patterns/pattern_type.h"
#include "tracer/patterns/remainder.h"

namespace durer::tracer {

/// The wave form that shapes a pattern's value, 0…1 (textures §3, step 5).
[[nodiscard]] double shape_wave(scene::Wave wave, float exponent, double value);

/// One compiled pattern. The warps it names belong to the PatternStore that made it.
struct PatternProgram {
  const PatternType* type = nullptr;  // null: no pattern
  bool moved = false;
  scene::Wave wave = scene::Wave::ramp;
  float frequency = 1;
  float phase = 0;
  float wave_exponent = 1;
  std::uint32_t first_step = 0;
  std::uint32_t end_step = 0;
  Affine to_pattern;
  PatternState state;
};

/// Compiles patterns, and owns what they share.
class PatternStore {
 public:
  /// Takes the noise generator and the number of waves from `settings`.
  explicit PatternStore(const scene::Settings& settings = {});

  /// `to_world` leads from the space around the pattern to the world.
  [[nodiscard]] PatternProgram compile(const scene::Pattern& pattern, const Transform& to_world);

  /// A point as the pattern sees it, after transformations and warps.
  [[nodiscard]] dvec3 warp(const PatternProgram& program, const dvec3& p) const {
    if (program.first_step == program.end_step) {
      return representable(program.moved ? program.to_pattern.point(p) : p);
    }
    dvec3 q = program.moved ? program.to_pattern.point(p) : p;
    for (std::uint32_t i = program.first_step; i < program.end_step; ++i) {
      q = steps_[i].apply(steps_[i].state, q);
    }
    return representable(q);
  }

  /// The same for several points, in place.
  void warp(const PatternProgram& program, std::span<dvec3> points) const;

  /// The value at a warped point. `view`: what a ray sees there, or null.
  [[nodiscard]] static double value(const PatternProgram& program, const dvec3& warped,
                                    const SurfaceView* view = nullptr) {
    return shaped(program, program.type->evaluate(program.state, warped, view));
  }
  /// The values at several warped points away from surfaces.
  static void values(const PatternProgram& program, std::span<const dvec3> warped, double* out);

 private:
  struct Step {
    dvec3 (*apply)(const PatternState& state, const dvec3& p) = nullptr;
    void (*apply_all)(const PatternState& state, std::span<dvec3> points) = nullptr;
    PatternState state;
  };

  [[nodiscard]] static double shaped(const PatternProgram& program, double v) {
    // The modulus is a little above 1 so that the value 1 stays 1 and finds the last entry.
    if (program.frequency != 0) v = remainder(v * program.frequency + program.phase, 1.00001);
    if (v < 0) v -= floored(v);
    return program.wave == scene::Wave::ramp ? v
                                             : shape_wave(program.wave, program.wave_exponent, v);
  }
  // Keeps points representable for the patterns' whole-number arithmetic; NaN becomes a bound.
  [[nodiscard]] static dvec3 representable(const dvec3& p) {
    return {representable(p.x), representable(p.y), representable(p.z)};
  }
  [[nodiscard]] static double representable(double x) {
    constexpr double limit = 1e17;
    const double lower = x > -limit ? x : -limit;
    return lower < limit ? lower : limit;
  }
  void add_step(const scene::Warp& warp);
  [[nodiscard]] const ImageSampler* sampler(const std::shared_ptr<const scene::Image>& image);

  scene::Settings settings_;
  // Behind a pointer, so that programs may point to it wherever the store goes.
  std::shared_ptr<const std::vector<functions::WaveSource>> waves_;
  std::vector<Step> steps_;
  // What programs point to.
  std::vector<functions::FunctionRef> functions_;
  std::vector<std::shared_ptr<const InnerPigment>> pigments_;
  std::vector<std::shared_ptr<const scene::Voxels>> voxels_;
  // Copies of a texture in other places show the same picture.
  std::unordered_map<std::shared_ptr<const scene::Image>, std::shared_ptr<const ImageSampler>>
      images_;
};

}  // namespace durer::tracer
