// Random numbers that depend on a state alone, which begins as a hash of pixel and sample.
#pragma once

#include <cstdint>

namespace durer::tracer {

/// The next number, 0…1: the oracle's generator of `crand` (shading §9).
[[nodiscard]] inline float random_unit(std::uint32_t& state) {
  state = state * 1812433253U + 12345U;
  return static_cast<float>(state / 4294967295.0);
}

/// A random number, 0 included, 1 excluded; all bits of it are good.
[[nodiscard]] inline double next_random(std::uint32_t& state) {
  // O'Neill, "PCG", 2014: RXS-M-XS 32.
  state = state * 747796405U + 2891336453U;
  const std::uint32_t x = ((state >> ((state >> 28) + 4)) ^ state) * 277803737U;
  return ((x >> 22) ^ x) / 4294967296.0;
}

}  // namespace durer::tracer
