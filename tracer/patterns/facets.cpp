#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "tracer/patterns/crackle.h"
#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {
namespace {

// Flat faces: normals, or places, that are near one random point all get the same bend
// (textures §13.6).
struct Facets {
  float coords = 0;  // not 0: faces in space, bent by so much; 0: faces in directions
  float size = 0.1F;
  dvec3 metric{2, 2, 2};  // its x

  static constexpr std::array operands{
      keyword<&Facets::coords>("coords", "how much faces in space are bent"),
      keyword<&Facets::size>("size", "size of the faces"),
      keyword<&Facets::metric>("metric", "exponent of the distances"),
  };
  static constexpr std::array samples{Sample{{1, 2, 3}, 0}};

  double operator()(dvec3) const { return 0; }

  dvec3 perturb(dvec3 p, dvec3 n, double) const {
    n = glm::normalize(n);
    const double scale = size < 1e-6F ? 1e6 : 1 / static_cast<double>(size);
    const dvec3 f = nearest(scale * (coords != 0 ? p : n));
    if (coords == 0) return f;
    const dvec3 bend = functions::vnoise(f);
    return n + static_cast<double>(coords) * (bend - n * glm::dot(n, bend));
  }

 private:
  double distance(dvec3 d) const {
    const double m = metric.x;
    if (m == 2) return glm::dot(d, d);
    if (m == 1) return d.x + d.y + d.z;  // no absolute values, as the oracle has it
    return std::pow(std::abs(d.x), m) + std::pow(std::abs(d.y), m) + std::pow(std::abs(d.z), m);
  }

  dvec3 nearest(dvec3 t) const {
    dvec3 found(0.0);
    double least = std::numeric_limits<double>::infinity();
    const auto look = [&](const auto& points) {
      for (std::size_t i = 0; i < points.count; ++i) {
        const double d = distance(points[i] - t);
        if (d < least) {
          least = d;
          found = points[i];
        }
      }
    };
    CrackleCell& cell = crackle_cell(CrackleCube::around(t));
    look(cell.near);
    look(far_points(cell));
    return found;
  }
};

}  // namespace

extern constinit const PatternType facets_pattern = describe_pattern<Facets>(
    "facets", "Flat faces; only as a normal.", {.default_map = {}, .only_normal = true});

}  // namespace durer::tracer::patterns
