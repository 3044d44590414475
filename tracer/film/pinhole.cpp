#include "tracer/film/pinhole.h"

#include <vector>

#include "tracer/accel/vector_lanes.h"
#include "tracer/film/sample_seed.h"

namespace durer::tracer {
namespace {

template <class Doubles>
DURER_INLINE void look_through(const Pinhole& hole, PinholeRays& rays, std::size_t first) {
  const auto all = [](double v) DURER_LAMBDA_INLINE { return Doubles::all(v); };
  const Doubles half = all(0.5);
  const Doubles u = (Doubles::load(&rays.x[first]) + half) / all(hole.width) - half;
  // Rows are counted from below, so that the last bits are the oracle's.
  const Doubles from_below = all(hole.height - 1) - Doubles::load(&rays.y[first]);
  const Doubles v = (from_below + half) / all(hole.height) - half;
  const scene::Camera& c = *hole.camera;
  const auto along = [&](double ahead, double across, double upwards) DURER_LAMBDA_INLINE {
    return all(ahead) + u * all(across) + v * all(upwards);
  };
  const Doubles x = along(c.direction.x, c.right.x, c.up.x);
  const Doubles y = along(c.direction.y, c.right.y, c.up.y);
  const Doubles z = along(c.direction.z, c.right.z, c.up.z);
  const Doubles scale = all(1) / root(x * x + y * y + z * z);
  (x * scale).store(&rays.rays.d.of[0][first]);
  (y * scale).store(&rays.rays.d.of[1][first]);
  (z * scale).store(&rays.rays.d.of[2][first]);
}

template <class Instructions>
DURER_INLINE void look_through(const Pinhole& hole, PinholeRays& rays) {
  using Doubles = typename Instructions::Doubles;
  for (std::size_t i = 0; i < most_in_packet; i += Doubles::size) {
    look_through<Doubles>(hole, rays, i);
  }
  for (std::size_t i = 0; i < most_in_packet; ++i) {
    rays.key[i] = sample_seed(rays.x[i], rays.y[i], rays.key[i]);
  }
}

void look_128(const Pinhole& hole, PinholeRays& rays) {
  look_through<wide::LanesOf<16>>(hole, rays);
}
#if defined(__x86_64__)
DURER_AVX2 void look_256(const Pinhole& hole, PinholeRays& rays) {
  look_through<wide::LanesOf<32>>(hole, rays);
}
DURER_AVX512 void look_512(const Pinhole& hole, PinholeRays& rays) {
  look_through<wide::LanesOf<64>>(hole, rays);
}
#endif

}  // namespace

std::span<const PinholeVersion> pinhole_versions() {
  static const std::vector<PinholeVersion> versions = [] {
    std::vector<PinholeVersion> all{look_128};
#if defined(__x86_64__)
    if (simd::has_avx2()) all.push_back(look_256);
    if (simd::has_avx512()) {
      all.push_back(look_512);
    }
#endif
    return all;
  }();
  return versions;
}

}  // namespace durer::tracer
