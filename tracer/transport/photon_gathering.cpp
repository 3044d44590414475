// How far around a point photons are looked for (participating-and-global §3.8, §3.9).
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tracer/random.h"
#include "tracer/transport/photon_map.h"

namespace durer::tracer {
namespace {

constexpr double pi = std::numbers::pi;

double density(std::size_t count, double radius, bool flat) {
  const auto n = static_cast<double>(count);
  return flat ? n / (pi * radius * radius) : 3 * n / (4 * pi * radius * radius * radius);
}

// Returns the radius that the photons stand for.
double look_around(const PhotonMap& map, const PhotonGathering& how, dvec3 p, dvec3 n,
                   std::vector<NearPhoton>& found) {
  constexpr double wider = 3;
  const double radius = map.nearest({p, n, how.most, how.radius}, found);
  if (found.size() >= how.least) return radius;
  // Per area, with the radius of the one search and of the other.
  const double before = static_cast<double>(found.size()) / (radius * radius);
  const std::size_t few = found.size();
  const double larger = map.nearest({p, n, how.most, wider * how.radius}, found);
  const double after = static_cast<double>(found.size()) / (larger * larger);
  const bool alike = before > 0 && (after - before) / before < how.expand_increase;
  if (alike || (!found.empty() && found.size() < how.expand_min)) return larger;
  if (few == 0) {
    found.clear();
    return radius;
  }
  return map.nearest({p, n, how.most, how.radius}, found);
}

}  // namespace

void gather(const PhotonMap& map, const PhotonGathering& how, dvec3 p, dvec3 n,
            FoundPhotons& found) {
  found.radius = look_around(map, how, p, n, found.photons);
}

double usual_radius(const PhotonMap& map, std::size_t most, bool flat) {
  if (map.empty() || most == 0) return 0;
  const std::size_t tries = std::clamp<std::size_t>(map.size() / 20, 100, 1000);
  std::vector<NearPhoton> found;
  // Calls visit(density) with those around some photons.
  const auto each = [&](double within, auto&& visit) {
    std::uint32_t random = 1;
    for (std::size_t i = 0; i < tries; ++i) {
      const auto at = static_cast<std::uint32_t>(next_random(random) * double(map.size()));
      const vec3 p = map[at].p;
      // Seen from all sides: what a surface there looks like is not known here.
      const double radius = map.nearest({dvec3(p), dvec3(0.0), most, within}, found);
      double farthest = 0;
      for (const NearPhoton& f : found) farthest = std::max(farthest, double{f.distance2()});
      const double r = std::isinf(radius) ? std::sqrt(farthest) : radius;
      if (r > 0) visit(density(found.size(), r, flat));
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
