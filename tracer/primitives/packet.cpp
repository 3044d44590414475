#include "tracer/primitives/packet.h"

#include "tracer/accel/vector_lanes.h"

namespace durer::tracer {
namespace {

using Doubles = wide::LanesOf<16>::Doubles;
constexpr std::size_t group = Doubles::size;

/// Squares of lengths, with the sum as glm::dot has it.
DURER_INLINE Doubles squares(const PacketVectors& v, std::size_t first) {
  const auto square = [&](std::size_t k) DURER_LAMBDA_INLINE {
    const Doubles x = Doubles::load(&v.of[k][first]);
    return x * x;
  };
  return square(0) + square(1) + square(2);
}

}  // namespace

void normalize(PacketVectors& vectors, std::size_t count) {
  for (std::size_t first = 0; first < count; first += group) {
    const Doubles scale = Doubles::all(1) / root(squares(vectors, first));
    for (PerRay<double>& x : vectors.of) (Doubles::load(&x[first]) * scale).store(&x[first]);
  }
}

std::uint32_t above_zero(const PacketVectors& vectors, std::size_t count) {
  std::uint32_t bits = 0;
  for (std::size_t first = 0; first < count; first += group) {
    bits |= above(squares(vectors, first), Doubles::all(0)) << first;
  }
  return bits;
}

}  // namespace durer::tracer
