// Turbulence as a warp, and as patterns see it that use it themselves.
#pragma once

#include <algorithm>

#include "functions/noise.h"
#include "tracer/warps/warp_type.h"

namespace durer::tracer::warps {

struct Turbulence {
  dvec3 amount{0.0};
  double count = 6;
  float omega = 0.5F;
  float lambda = 2;

  static constexpr std::array operands{
      positional<&Turbulence::amount>("amount", "how far points are moved"),
      keyword<&Turbulence::count>("octaves", "number of octaves, 1 to 10"),
      keyword<&Turbulence::omega>("omega", "size of an octave relative to the one before"),
      keyword<&Turbulence::lambda>("lambda", "frequency of an octave relative to the one before"),
  };
  [[nodiscard]] functions::Octaves octaves() const {
    return {static_cast<int>(std::clamp(count, 1.0, 10.0)), omega, lambda};
  }
  dvec3 operator()(dvec3 p) const { return p + amount * functions::vturbulence(p, octaves()); }
  void move(std::span<dvec3> points) const {
    constexpr std::size_t most = 16;
    std::array<dvec3, most> way;
    for (; !points.empty(); points = points.subspan(std::min(most, points.size()))) {
      const std::span some = points.first(std::min(most, points.size()));
      functions::vturbulence(some, octaves(), std::span(way).first(some.size()));
      for (std::size_t i = 0; i < some.size(); ++i) some[i] += amount * way[i];
    }
  }
};

}  // namespace durer::tracer::warps
