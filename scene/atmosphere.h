// What lies in the air between the eye and everything else (shading §7.3, §7.4).
#pragma once

#include <cstdint>
#include <vector>

#include "base/colour.h"
#include "base/vec.h"
#include "scene/origin.h"
#include "scene/texture.h"

namespace durer::scene {

/// World units. A `distance` of 0 is no fog at all.
struct Fog {
  enum class Kind : std::uint8_t { constant, ground };
  Kind kind = Kind::constant;
  double distance = 0;  // in which light falls to 1/e
  Colour colour;        // filter tints what is seen; transmit always shines through
  double offset = 0;    // ground: height below which the fog is constant …
  double alt = 0;       // … and over which it falls to half
  dvec3 up{0, 1, 0};    // unit
  bool turbulent = false;
  dvec3 turbulence{0.0};
  double turb_depth = 0.5;
  int octaves = 6;
  double omega = 0.5;
  double lambda = 2;
  OriginId origin = 0;
};

/// A band of colours around a direction, before everything that is far away.
struct Rainbow {
  dvec3 direction{0.0};
  dvec3 up{0, 1, 0};
  double angle_deg = 0;       // from `direction` to the middle of the band
  double width_deg = 0;       // 0: none
  double arc_angle_deg = 360;      // of the arc that is seen at all
  double falloff_angle_deg = 360;  // where it begins to fade
  double distance = 1e7;
  double jitter = 0;
  std::vector<PigmentEntry> colours;  // from the inner to the outer edge; empty: none
  OriginId origin = 0;
};

}  // namespace durer::scene
