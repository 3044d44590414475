// How far around a point photons are looked for (participating-and-global §3.8, §3.9).
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "tracer/random.h"
#include "tracer/transport/photon_map.h"

namespace durer::tracer {
namespace {

constexpr double pi = std::numbers::pi;

double density(std::size_t count, double radius, bool flat) {
  const auto n = static_cast<double>(count);
  return flat ? n / (pi * radius * radius) : 3 * n / (4 * pi * radius * radius * radius);
}

// Leaves what a search within a smaller radius would have found.
void keep_within(double radius, FoundPhotons& found) {
  const auto limit2 = static_cast<float>(radius * radius);
  std::size_t to = 0;
  for (std::size_t i = 0; i < found.count; ++i) {
    found.indices[to] = found.indices[i];
    found.distances2[to] = found.distances2[i];
    to += found.distances2[i] < limit2 ? 1 : 0;
  }
  found.count = to;
}

}  // namespace

void gather(const PhotonMap& map, const PhotonGathering& how, dvec3 p, dvec3 n,
            FoundPhotons& found) {
  constexpr double wider = 3;
  map.nearest({p, n, how.most, how.radius}, found);
  if (found.count >= how.least) return;
  // Per area, with the radius of the one search and of the other.
  const double radius = found.radius;
  const double before = static_cast<double>(found.count) / (radius * radius);
  const bool none = found.count == 0;
  map.nearest({p, n, how.most, wider * how.radius}, found);
  const double after = static_cast<double>(found.count) / (found.radius * found.radius);
  const bool alike = before > 0 && (after - before) / before < how.expand_increase;
  if (alike || (found.count > 0 && found.count < how.expand_min)) return;
  if (none) {
    found.count = 0;
  } else {
    keep_within(how.radius, found);
  }
  found.radius = radius;
}

double usual_radius(const PhotonMap& map, std::size_t most, bool flat) {
  if (map.empty() || most == 0) return 0;
  const std::size_t tries = std::clamp<std::size_t>(map.size() / 20, 100, 1000);
  FoundPhotons found;
  // Calls visit(density) with those around some photons.
  const auto each = [&](double within, auto&& visit) {
    std::uint32_t random = 1;
    for (std::size_t i = 0; i < tries; ++i) {
      const auto at = static_cast<std::uint32_t>(next_random(random) * double(map.size()));
      const vec3 p = map[at].p;
      // Seen from all sides: what a surface there looks like is not known here.
      map.nearest({dvec3(p), dvec3(0.0), most, within}, found);
      double r = found.radius;
      if (std::isinf(r)) {
        const auto all = std::span(found.distances2).first(found.count);
        r = std::sqrt(double{all.empty() ? 0.0F : *std::max_element(all.begin(), all.end())});
      }
      if (r > 0) visit(density(found.count, r, flat));
    }
  };
  double sum = 0;
  each(std::numeric_limits<double>::infinity(), [&](double d) { sum += d; });
  if (!(sum > 0)) return 0;
  const double mean = sum / static_cast<double>(tries);
  const double n = static_cast<double>(most);
  double radius = flat ? std::sqrt(n / (mean * pi)) : std::cbrt(3 * n / (4 * pi * mean));
  std::size_t sparse = 0;
  each(radius, [&](double d) {
    if (d < 0.7 * mean && d > 0.05 * mean) ++sparse;
  });
  return radius * (1 + 20 * static_cast<double>(sparse) / static_cast<double>(tries));
}

}  // namespace durer::tracer
