// What the integration of media along a ray is made of.
#pragma once

#include <cstdint>
#include <vector>

#include "base/colour.h"
#include "base/vec.h"

namespace durer::tracer {

/// What media along a ray do to the light from its far end.
struct MediaEffect {
  vec3 added{0.0F};  // light that they send towards the ray's origin
  vec3 depth{0.0F};  // optical depth
  vec3 kept{1.0F};   // share of the light behind that comes through
};

/// Where a lamp shines on a ray, in units of t.
struct LampSpan {
  std::uint32_t light = 0;
  double from = 0;
  double to = 0;
  /// What can stand between that stretch and the lamp; if `few`, Scratch::lamp_casters of the same
  /// number has it.
  enum class Casters : std::uint8_t { unknown, none, few, many };
  Casters casters = Casters::unknown;
};
/// A part of a ray that some lamp shines on, or none.
struct LitPart {
  double from = 0;
  double to = 0;
  bool lit = false;
};

/// A place in a medium: the light it adds and the optical depth, both for a whole interval.
struct MediaSample {
  double u = 0;  // 0…1 along the interval
  vec3 colour{0.0F};
  vec3 depth{0.0F};
};
/// A stretch between two places, and its mean. All are indices into MediaSamples.
struct MediaStretch {
  double from = 0;
  double to = 0;
  std::uint32_t first = 0;
  std::uint32_t middle = 0;
  std::uint32_t last = 0;
  std::uint32_t left = 0;   // its halves, where those are stretches of their own; else 0
  std::uint32_t right = 0;
  vec3 colour{0.0F};
  vec3 depth{0.0F};
};
/// An interval that is being sampled.
struct MediaSamples {
  std::vector<MediaSample> places;
  std::vector<MediaStretch> stretches;
};

}  // namespace durer::tracer
