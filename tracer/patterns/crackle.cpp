#include "tracer/patterns/crackle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

using functions::simd::Smallest3;

// Distances to the nearest random points, weighted, or noise at the nearest one (textures §5.1).
struct Crackle {
  bool solid = false;
  float offset = 0;
  dvec3 form{-1, 1, 0};
  dvec3 metric{2, 2, 2};  // its x; a vector because it may be written as one
  functions::NoiseGenerator generator = 2;
  std::int32_t whole_metric = 2;  // the same if it is a small whole number, else 0
  std::uint32_t asked = 3;        // so many of the smallest distances matter
  double added = 0;               // to the power of the metric

  static constexpr std::array operands{
      keyword<&Crackle::solid>("solid", "one value in each cell"),
      keyword<&Crackle::form>("form", "weights of the three smallest distances"),
      keyword<&Crackle::metric>("metric", "exponent of the distances"),
      keyword<&Crackle::offset>("offset", "added to the distances"),
  };
  static constexpr std::array samples{
      Sample{{0.1, 0.2, 0.3}, 0.102799521802},
      Sample{{-1.5, 2.25, 7.75}, 0.244286441802},
      Sample{{123.4, -56.7, 8.9}, 0.275341406851},
  };
  void prepare(const PatternContext& context) {
    generator = context.noise_generator;
    const double m = metric.x;
    whole_metric = m >= 1 && m <= 8 && m == std::floor(m) ? static_cast<std::int32_t>(m) : 0;
    asked = form.z != 0 ? 3 : form.y != 0 ? 2 : 1;
    if (offset != 0) added = std::pow(static_cast<double>(offset), m);
  }

  double operator()(dvec3 p) const {
    CrackleCell& cell = crackle_cell(CrackleCube::around(p));
    if (solid) return functions::noise(nearest(cell, p), generator);
    Smallest3 powers = functions::simd::nothing_near;
    add(cell.near, p, powers);
    add_far(cell, p, powers);
    return weighed(powers);
  }
  // Points beside each other, as bumps ask for them, are mostly in the same cube.
  void evaluate(std::span<const dvec3> points, double* values) const {
    while (!points.empty()) {
      const CrackleCube cube = CrackleCube::around(points[0]);
      const std::size_t most =
          solid || whole_metric == 0 ? 1 : std::min<std::size_t>(4, points.size());
      std::size_t count = 1;
      while (count < most && CrackleCube::around(points[count]) == cube) ++count;
      if (count == 1) {
        *values = (*this)(points[0]);
      } else {
        evaluate_near(crackle_cell(cube), points.first(count), values);
      }
      points = points.subspan(count);
      values += count;
    }
  }

 private:
  // Two to four points in the same cube.
  void evaluate_near(CrackleCell& cell, std::span<const dvec3> points, double* values) const {
    functions::simd::FourPoints four;
    for (std::size_t i = 0; i < four.size(); ++i) four[i] = points[std::min(i, points.size() - 1)];
    auto powers = functions::simd::smallest_distances(cell.near.list(), four, whole_metric);
    for (std::size_t i = 0; i < points.size(); ++i) {
      add_far(cell, points[i], powers[i]);
      values[i] = weighed(powers[i]);
    }
  }
  double weighed(const Smallest3& powers) const {
    double sum = 0;
    for (std::uint32_t i = 0; i < asked; ++i) sum += form[static_cast<int>(i)] * length(powers[i]);
    return std::clamp(sum, 0.0, 1.0);
  }
  double power(double x) const {
    x = std::abs(x);
    if (whole_metric == 0) return std::pow(x, metric.x);
    double product = x;
    for (int i = 1; i < whole_metric; ++i) product *= x;
    return product;
  }
  double distance(dvec3 d) const { return power(d.x) + power(d.y) + power(d.z); }
  double length(double d) const {
    d += added;
    return metric.x == 2 ? std::sqrt(d) : metric.x == 1 ? d : std::pow(d, 1 / metric.x);
  }
  /// True if no point of the farther cubes can be within `least`, a power of a distance.
  bool near_is_enough(const CrackleCell& cell, dvec3 p, double least) const {
    return metric.x > 0 && least <= power(cell.distance_to_far(p));
  }

  void add_far(CrackleCell& cell, dvec3 p, Smallest3& found) const {
    if (!near_is_enough(cell, p, found[asked - 1])) add(far_points(cell), p, found);
  }
  template <std::size_t n>
  void add(const CracklePoints<n>& points, dvec3 p, Smallest3& found) const {
    if (whole_metric != 0) {
      found = functions::simd::smallest_distances(points.list(), p, whole_metric, found);
      return;
    }
    for (std::size_t i = 0; i < n; ++i) {
      double d = distance(points[i] - p);
      for (double& f : found) {
        if (d < f) std::swap(d, f);
      }
    }
  }

  dvec3 nearest(CrackleCell& cell, dvec3 p) const {
    double least = std::numeric_limits<double>::infinity();
    dvec3 found = p;
    look(cell.near, p, least, found);
    if (!near_is_enough(cell, p, least)) look(far_points(cell), p, least, found);
    return found;
  }
  template <std::size_t n>
  void look(const CracklePoints<n>& points, dvec3 p, double& least, dvec3& found) const {
    for (std::size_t i = 0; i < n; ++i) {
      const double d = distance(points[i] - p);
      if (d < least) {
        least = d;
        found = points[i];
      }
    }
  }
};

}  // namespace

extern constinit const PatternType crackle_pattern = describe_pattern<Crackle>(
    "crackle", "Cracks between random cells.", {.default_map = black_to_white});

}  // namespace durer::tracer::patterns
