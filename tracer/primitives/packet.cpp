#include "tracer/primitives/packet.h"

#include <algorithm>

#include "tracer/accel/vector_lanes.h"

namespace durer::tracer {
namespace {

using Doubles = wide::LanesOf<16>::Doubles;
constexpr std::size_t group = Doubles::size;

/// As glm::dot has it.
DURER_INLINE Doubles dots(const PacketVectors& a, const PacketVectors& b, std::size_t first) {
  const auto product = [&](std::size_t k) DURER_LAMBDA_INLINE {
    return Doubles::load(&a.of[k][first]) * Doubles::load(&b.of[k][first]);
  };
  return product(0) + product(1) + product(2);
}

/// Behind the first `count`.
void repeat_last(PerRay<double>& x, std::size_t count) {
  std::fill(x.begin() + static_cast<std::ptrdiff_t>(count), x.end(), x[count - 1]);
}
void repeat_last(PacketVectors& v, std::size_t count) {
  for (PerRay<double>& x : v.of) repeat_last(x, count);
}

}  // namespace

void PacketRays::repeat_last() {
  tracer::repeat_last(o, count);
  tracer::repeat_last(d, count);
  tracer::repeat_last(t_from, count);
  tracer::repeat_last(t_to, count);
}
void PacketPoints::repeat_last() { tracer::repeat_last(p, count); }

void normalize(PacketVectors& vectors, std::size_t count) {
  for (std::size_t first = 0; first < count; first += group) {
    const Doubles scale = Doubles::all(1) / root(dots(vectors, vectors, first));
    for (PerRay<double>& x : vectors.of) (Doubles::load(&x[first]) * scale).store(&x[first]);
  }
}

std::uint32_t along(const PacketVectors& a, const PacketVectors& b, std::size_t count) {
  std::uint32_t bits = 0;
  for (std::size_t first = 0; first < count; first += group) {
    bits |= above(dots(a, b, first), Doubles::all(0)) << first;
  }
  return bits & ((2U << (count - 1)) - 1);
}

std::uint32_t above_zero(const PacketVectors& vectors, std::size_t count) {
  return along(vectors, vectors, count);
}

}  // namespace durer::tracer
