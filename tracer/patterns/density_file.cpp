#include <cmath>
#include <cstdint>

#include "scene/image.h"
#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// Samples in the unit cube (textures §8.6). Without a file it is 0 everywhere.
struct DensityFile {
  double interpolate = 0;
  const scene::Voxels* voxels = nullptr;

  static constexpr std::array operands{
      keyword<&DensityFile::interpolate>("interpolate", "0: none, 1: linear, 2: cubic"),
  };
  static constexpr std::array samples{Sample{{0.1, 0.2, 0.3}, 0}};

  void prepare(const PatternContext& context) { voxels = context.voxels; }

  double operator()(dvec3 p) const {
    const auto outside = [](double x) { return !(x >= 0 && x < 1); };
    if (voxels == nullptr || outside(p.x) || outside(p.y) || outside(p.z)) return 0;
    const Axis x(p.x, voxels->size[0]);
    const Axis y(p.y, voxels->size[1]);
    const Axis z(p.z, voxels->size[2]);
    const int kind = static_cast<int>(interpolate);
    return kind == 0 ? voxels->at(x.i, y.i, z.i) : kind == 1 ? linear(x, y, z) : cubic(x, y, z);
  }

 private:
  /// Where a coordinate lies among the samples of an axis. They wrap around.
  struct Axis {
    std::uint32_t size;
    std::uint32_t i;
    double t;  // from sample i to the next

    Axis(double x, std::uint32_t n)
        : size(n), i(static_cast<std::uint32_t>(x * n)), t(x * n - std::floor(x * n)) {}
    [[nodiscard]] std::uint32_t next(std::uint32_t step = 1) const { return (i + step) % size; }
    /// The oracle takes one from an unsigned 64-bit 0: that is the last sample only where the size
    /// is a power of two.
    [[nodiscard]] std::uint32_t before() const {
      return static_cast<std::uint32_t>((std::uint64_t{i} - 1) % size);
    }
  };

  [[nodiscard]] double linear(const Axis& x, const Axis& y, const Axis& z) const {
    const auto row = [&](std::uint32_t iy, std::uint32_t iz) {
      return (1 - x.t) * voxels->at(x.i, iy, iz) + x.t * voxels->at(x.next(), iy, iz);
    };
    const auto plane = [&](std::uint32_t iz) {
      return (1 - y.t) * row(y.i, iz) + y.t * row(y.next(), iz);
    };
    return (1 - z.t) * plane(z.i) + z.t * plane(z.next());
  }

  /// Four samples in a row, at -1, 0, 1 and 2; in single precision as the oracle has it.
  static float spline(float t, float fa, float fb, float fc, float fd) {
    const float b = (fc - fa) * 0.5F;
    const float d = (fd - fb) * 0.5F;
    const float e = 2 * (fb - fc) + b + d;
    const float f = -3 * (fb - fc) - 2 * b - d;
    return ((e * t + f) * t + b) * t + fb;
  }
  template <typename At>
  static float along(const Axis& a, At at) {
    return spline(static_cast<float>(a.t), at(a.before()), at(a.i), at(a.next()), at(a.next(2)));
  }
  [[nodiscard]] double cubic(const Axis& x, const Axis& y, const Axis& z) const {
    const float v = along(x, [&](std::uint32_t ix) {
      return along(y, [&](std::uint32_t iy) {
        return along(z, [&](std::uint32_t iz) {
          return static_cast<float>(voxels->at(ix, iy, iz));
        });
      });
    });
    return v < 0 ? 0 : v;
  }
};

}  // namespace

extern constinit const PatternType density_file_pattern =
    describe_pattern<DensityFile>("density_file", "The samples of a density file.",
                                  {.default_map = black_to_white, .takes_voxels = true});

}  // namespace durer::tracer::patterns
