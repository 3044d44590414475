// Cameras as plain data (shading §2).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/boxed.h"
#include "base/transform.h"
#include "functions/tape.h"
#include "scene/mesh.h"
#include "scene/origin.h"
#include "scene/texture.h"

namespace durer::scene {

/// A thick lens: what is not in focus is blurred (shading §2.7).
struct Lens {
  double aperture = 0;     // world units; 0: a pinhole
  int least_samples = 0;   // per sample of the picture
  int most_samples = 0;    // 0: a pinhole
  double focal_distance = 1;
  double confidence = 0.9;
  double variance = 1.0 / 10000;
  bool has_bokeh = false;
  Pigment bokeh;  // over the unit square: how much light comes through that part of the lens
};

/// Rays that start on the faces of meshes (shading §2.5).
struct MeshCamera {
  int rays = 1;          // per pixel
  int distribution = 0;  // 0…3: which face a ray starts on
  double reach = 0;      // what is farther is not seen; 0: no limit
  bool smooth = false;
  std::vector<std::shared_ptr<const Mesh>> meshes;
  std::vector<SharedTransform> transforms;  // of the meshes, to the world
};

/// Final vectors, after `angle`, `look_at` and all transformations (shading §2.2).
struct Camera {
  enum class Kind : std::uint8_t {
#define DURER_ENTRY(name) name,
#include "scene/cameras.def"
#undef DURER_ENTRY
  };
  Kind kind = Kind::perspective;
  dvec3 location{0.0};
  dvec3 direction{0, 0, 1};
  dvec3 right{1.33, 0, 0};
  dvec3 up{0, 1, 0};
  /// Field of view of the kinds that do not take it from the vectors.
  double angle_deg = 90;
  double vertical_angle_deg = 180;  // spherical
  int cylinder_type = 1;            // cylinder: 1…4
  /// user_defined: functions of u and v, each -1/2…1/2 over the picture, to the right and upwards,
  /// in the space of `transform`. None: `location`, or the direction of a perspective camera.
  std::array<functions::FunctionRef, 3> location_functions;
  std::array<functions::FunctionRef, 3> direction_functions;
  SharedTransform transform;
  Boxed<Normal> normal;  // bends rays
  Boxed<Lens> lens;
  Boxed<MeshCamera> mesh;
  OriginId origin = 0;
};

}  // namespace durer::scene
