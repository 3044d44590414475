// Rays with what they went through, and what they see.
#pragma once

#include <cstdint>
#include <limits>

#include "base/ray.h"
#include "base/vec.h"
#include "tracer/geometry.h"
#include "tracer/shading/interior.h"

namespace durer::tracer {

/// What a ray that gathers indirect light tells of the first surface that it meets.
struct FirstHit {
  double distance = std::numeric_limits<double>::infinity();
  float least_importance = 0;  // surfaces of less are not looked at
  float importance = 1;        // that of the surface
};

/// The history of a ray, but for the bodies around it: small, and copied as one block.
struct PathHistory {
  double reach = no_hit_depth;  // what is farther away is not seen
  float weight = 1;             // share of the pixel it can still change
  int level = 0;                // bends so far
  double wavelength = 0;        // nm; 0: white light
  std::uint32_t bounce = 0;     // of indirect light; above 0: the ray gathers some
  bool reflected = false;
  bool transmitted = false;   // it came through a surface
  FirstHit* first = nullptr;  // who wants to know of the next surface, if somebody does
};

/// A ray with its history.
struct Path : PathHistory {
  Ray ray;
  Containment inside;  // bodies that the ray is inside of; large, so it stands last

  [[nodiscard]] RayKind kind() const {
    return bounce > 0    ? RayKind::gathering
           : reflected   ? RayKind::reflection
           : transmitted ? RayKind::transmission
                         : RayKind::image;
  }
};

/// Premultiplied colour, and the share of what lies behind that shines through.
struct Radiance {
  vec3 colour{0.0F};
  float transmittance = 0;
};

/// A ray of the picture, and what it sees. Its path may be left out until somebody needs it.
struct Sample {
  std::uint32_t noise = 0;  // state of its random numbers
  Radiance seen;
  Path path;
};

}  // namespace durer::tracer
