// Random numbers that depend on a state alone, which begins as a hash of pixel and sample.
#pragma once

#include <cstdint>

namespace durer::tracer {

/// The next number, 0…1: the oracle's generator of `crand` (shading §9).
[[nodiscard]] inline float random_unit(std::uint32_t& state) {
  state = state * 1812433253U + 12345U;
  return static_cast<float>(state / 4294967295.0);
}

}  // namespace durer::tracer
