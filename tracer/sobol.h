// Random numbers that spread evenly: Sobol points, scrambled and shuffled for every pixel and
// dimension by hashes. They depend on pixel, sample and dimension alone.
#pragma once

#include <cstdint>

#include "base/vec.h"
#include "tracer/random.h"

namespace durer::tracer {

[[nodiscard]] constexpr std::uint32_t reversed_bits(std::uint32_t x) {
  x = (x >> 16) | (x << 16);
  x = ((x & 0xFF00FF00U) >> 8) | ((x & 0x00FF00FFU) << 8);
  x = ((x & 0xF0F0F0F0U) >> 4) | ((x & 0x0F0F0F0FU) << 4);
  x = ((x & 0xCCCCCCCCU) >> 2) | ((x & 0x33333333U) << 2);
  return ((x & 0xAAAAAAAAU) >> 1) | ((x & 0x55555555U) << 1);
}

/// Owen's scrambling of the digits of a number 0…1, as 32 bits: whether a bit is flipped depends on
/// `seed` and all bits above it.
/// Source: Burley, "Practical Hash-based Owen Scrambling", JCGT 9 (4), 2020.
[[nodiscard]] constexpr std::uint32_t owen_scrambled(std::uint32_t x, std::uint32_t seed) {
  x = reversed_bits(x) + seed;
  x ^= x * 0x6C50B47CU;
  x ^= x * 0xB82F1E52U;
  x ^= x * 0xC7AFE638U;
  x ^= x * 0x8D22F6E6U;
  return reversed_bits(x);
}

/// The second dimension of Sobol's sequence; the first one is reversed_bits(index). Any 2^k of them
/// in a row from a multiple of 2^k meet every elementary interval of the square once.
[[nodiscard]] constexpr std::uint32_t sobol_second(std::uint32_t index) {
  std::uint32_t x = 0;
  for (std::uint32_t column = 1U << 31; index != 0; index >>= 1, column ^= column >> 1) {
    if ((index & 1) != 0) x ^= column;
  }
  return x;
}

/// The random numbers of one sample of one pixel. Each call is a dimension of its own, in which the
/// samples of the pixel are spread evenly; dimensions do not know of each other.
class SobolSampler {
 public:
  SobolSampler() = default;
  SobolSampler(std::uint32_t pixel, std::uint32_t index) : pixel_(mixed(pixel)), index_(index) {}

  /// The next call is about this dimension, or pair of dimensions.
  void go_to(std::uint32_t dimension) { count_ = dimension; }

  /// 0 included, 1 excluded.
  [[nodiscard]] double next() { return unit(owen_scrambled(reversed_bits(shuffled()), seed(1))); }
  [[nodiscard]] dvec2 next2() {
    const std::uint32_t i = shuffled();
    return {unit(owen_scrambled(reversed_bits(i), seed(1))),
            unit(owen_scrambled(sobol_second(i), seed(2)))};
  }

 private:
  [[nodiscard]] std::uint32_t seed(std::uint32_t part) const {
    return mixed(dimension_ + part * 0xCB1AB31FU);
  }
  // Begins a dimension. Shuffled in the manner of the scrambling, blocks of 2^k stay blocks.
  [[nodiscard]] std::uint32_t shuffled() {
    dimension_ = mixed(pixel_ ^ (++count_ * 0x9E3779B9U));
    return owen_scrambled(index_, dimension_);
  }
  [[nodiscard]] static double unit(std::uint32_t x) { return x / 4294967296.0; }

  std::uint32_t pixel_ = 0;
  std::uint32_t index_ = 0;
  std::uint32_t count_ = 0;
  std::uint32_t dimension_ = 0;
};

}  // namespace durer::tracer
