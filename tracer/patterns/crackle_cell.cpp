#include <algorithm>
#include <cmath>

#include "functions/noise.h"
#include "base/floor.h"
#include "tracer/patterns/crackle.h"

namespace durer::tracer::patterns {
namespace {

constexpr unsigned cells_kept = 16;  // 2 KB each, by hash: a few textures at once fit in

// The random point of a cube.
dvec3 crackle_point(const CrackleCube& c) {
  const auto s = static_cast<unsigned>(functions::hash3(
      static_cast<int>(c.x), static_cast<int>(c.y), static_cast<int>(c.z)));
  return {static_cast<double>(c.x) + functions::uniform_table(s),
          static_cast<double>(c.y) + functions::uniform_table(s + 1),
          static_cast<double>(c.z) + functions::uniform_table(s + 2)};
}

template <std::size_t n>
class Filler {
 public:
  explicit Filler(CracklePoints<n>& points) : points_(points) {}
  ~Filler() {
    constexpr double far = 1e200;  // its square, too, is more than any distance that matters
    for (std::size_t i = count_; i < points_.room; ++i) put(i, dvec3(far));
  }
  Filler(const Filler&) = delete;
  Filler& operator=(const Filler&) = delete;

  void add(const dvec3& p) { put(count_++, p); }

 private:
  void put(std::size_t i, const dvec3& p) {
    points_.x[i] = p.x;
    points_.y[i] = p.y;
    points_.z[i] = p.z;
  }
  CracklePoints<n>& points_;
  std::size_t count_ = 0;
};

void find_near(CrackleCell& cell) {
  Filler filler(cell.near);
  const CrackleCube& c = cell.cube;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) filler.add(crackle_point({c.x + x, c.y + y, c.z + z}));
    }
  }
  cell.near_known = true;
}

void find_far(CrackleCell& cell) {
  Filler filler(cell.far);
  const CrackleCube& c = cell.cube;
  for (int a = -1; a <= 1; ++a) {
    for (int b = -1; b <= 1; ++b) {
      for (const int two : {-2, 2}) {
        filler.add(crackle_point({c.x + two, c.y + a, c.z + b}));
        filler.add(crackle_point({c.x + a, c.y + two, c.z + b}));
        filler.add(crackle_point({c.x + a, c.y + b, c.z + two}));
      }
    }
  }
  cell.far_known = true;
}

}  // namespace

CrackleCube CrackleCube::around(dvec3 p) {
  const auto lower = [](double v) { return static_cast<std::int64_t>(floored(v - epsilon)); };
  return {lower(p.x), lower(p.y), lower(p.z)};
}

double CrackleCell::distance_to_far(dvec3 p) const {
  const auto to_side = [](double v, std::int64_t low) {
    const double f = v - static_cast<double>(low);
    return std::min(f, 1 - f);
  };
  return 1 + std::min({to_side(p.x, cube.x), to_side(p.y, cube.y), to_side(p.z, cube.z)});
}

CrackleCell& crackle_cell(const CrackleCube& cube) {
  thread_local constinit std::array<CrackleCell, cells_kept> kept{};
  const auto hash = static_cast<unsigned>(cube.x + 3 * cube.y + 5 * cube.z);
  CrackleCell& cell = kept[hash % cells_kept];
  if (cell.near_known && cell.cube == cube) return cell;
  cell.cube = cube;
  cell.far_known = false;
  find_near(cell);
  return cell;
}

const CracklePoints<54>& far_points(CrackleCell& cell) {
  if (!cell.far_known) find_far(cell);
  return cell.far;
}

}  // namespace durer::tracer::patterns
