// Random numbers that depend on a state alone, which begins as a hash of pixel and sample.
#pragma once

#include <cstdint>

namespace durer::tracer {

/// All bits of `h`, well mixed.
[[nodiscard]] inline std::uint32_t mixed(std::uint32_t h) {
  h = (h ^ (h >> 16)) * 0x7FEB352DU;
  h = (h ^ (h >> 15)) * 0x846CA68BU;
  return h ^ (h >> 16);
}

/// Digits of `i` in a base, mirrored at the point: 0…1. What follows each other is spread evenly
/// (Halton's sequence).
[[nodiscard]] inline double radical_inverse(std::uint32_t i, std::uint32_t base) {
  double value = 0;
  double digit = 1.0 / base;
  for (; i > 0; i /= base, digit /= base) value += digit * (i % base);
  return value;
}

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
