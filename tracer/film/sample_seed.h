#pragma once

#include <cstdint>

#include "functions/simd/inline.h"
#include "tracer/random.h"

namespace durer::tracer {

/// Well-mixed start of the random numbers of one sample: that of number `index` at (x, y), in
/// pixels. Without a branch or a call, so that it can be had for several samples at once.
[[nodiscard]] DURER_INLINE std::uint32_t sample_seed(double x, double y, std::uint32_t index) {
  // No picture has more columns or rows than an int can count.
  const auto whole = [](double v) DURER_LAMBDA_INLINE {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(v + (v < 0 ? -0.5 : 0.5)));
  };
  return mixed(whole(x) * 0x8DA6B343U ^ whole(y) * 0xD8163841U ^ index * 0xCB1AB31FU);
}

}  // namespace durer::tracer
