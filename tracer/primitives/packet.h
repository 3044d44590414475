// Several rays that are asked together.
#pragma once

#include <cstddef>

#include "base/ray.h"

namespace durer::tracer {

/// One of them, in the space of the shape that is asked: hits with t_from <= t < t_to count.
struct PacketRay {
  Ray ray;
  double t_from;
  double t_to;
};
inline constexpr std::size_t packet_size = 16;

}  // namespace durer::tracer
