// Eight points of a Julia set at a time: the same bits as one by one.
#pragma once

#include <array>
#include <cstddef>

#include "tracer/primitives/julia_set.h"

namespace durer::tracer {

inline constexpr std::size_t julia_lanes = 8;

/// Where the orbits of eight points stand when they escape.
struct alignas(64) JuliaOrbits {
  using Lanes = std::array<double, julia_lanes>;
  Lanes escape;  // after how many steps; -1 if they do not
  /// Quaternions: the product of the squared norms before, and the squared norm, each alone.
  /// Hypercomplex: the product of the factors before, and the number, each a complex pair.
  std::array<Lanes, 4> product;
  std::array<Lanes, 4> q;
};

/// Bit i: whether point o + s[i] · d is in the set. Only for sets that are `is_polynomial`.
[[nodiscard]] unsigned julia_contains(const JuliaSet& set, dvec3 o, dvec3 d,
                                      const JuliaOrbits::Lanes& s);
/// The orbits of the points o + s[i] · d, as far as JuliaSet::look follows them. Likewise.
void julia_orbits(const JuliaSet& set, dvec3 o, dvec3 d, const JuliaOrbits::Lanes& s,
                  JuliaOrbits& out);

}  // namespace durer::tracer
