// Patterns as plain data: functions from points to values, which pigments, normals and textures
// select with (textures §3-§10).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/transform.h"
#include "functions/tape.h"
#include "scene/origin.h"
#include "scene/type_info.h"

namespace durer::scene {

inline constexpr std::uint32_t none = 0xFFFFFFFF;

/// One step of a chain that moves points about before a pattern sees them (textures §4).
struct Warp {
  std::uint32_t type = none;  // index into Registry::warps; none: `transform`
  std::vector<double> args;   // laid out by its Params
  SharedTransform transform;
  /// `turbulence` outside of any `warp`: always the last step, and some patterns do it themselves.
  bool classic = false;
};

struct Pigment;
struct Image;
struct Voxels;

/// What makes a value of a point.
struct Pattern {
  std::uint32_t type = none;  // index into Registry::patterns
  std::vector<double> args;   // the pattern's operands, laid out by its Params
  functions::FunctionRef function;  // of x, y, z; for the patterns `function` and `object`
  std::shared_ptr<const Pigment> pigment;  // what the pattern `pigment_pattern` looks at
  std::shared_ptr<const Image> image;      // what `image_map` and its like show
  std::shared_ptr<const Voxels> voxels;    // what `density_file` looks up
  std::vector<Warp> warps;    // in written order: the last one acts first
  SharedTransform transform;  // after all warps: pattern space → the space around
  float frequency = 1;
  float phase = 0;
  Wave wave = Wave::ramp;
  float wave_exponent = 1;
  int noise_generator = 0;  // 1, 2 or 3; 0: the scene's

  [[nodiscard]] bool exists() const { return type != none; }
};

}  // namespace durer::scene
