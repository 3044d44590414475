#include "tracer/film/pretrace.h"

#include <algorithm>
#include <cmath>

namespace durer::tracer {
namespace {

// Reproducible, -1…1.
double jitter(std::uint32_t seed, int i) {
  std::uint32_t h = seed * 0x9E3779B9U + static_cast<std::uint32_t>(i) * 0x85EBCA6BU;
  h = (h ^ (h >> 16)) * 0x7FEB352DU;
  h = (h ^ (h >> 15)) * 0x846CA68BU;
  h ^= h >> 16;
  return h / 2147483647.5 - 1;
}

}  // namespace

double pretrace_spacing(const scene::Radiosity& r, int longer_side, int pass) {
  const double last = std::max(1.0, r.pretrace_end * longer_side);
  return std::max(r.pretrace_start * longer_side * std::ldexp(1.0, -pass), last);
}

int pretrace_passes(const scene::Radiosity& r, int longer_side) {
  const double first = r.pretrace_start * longer_side;
  const double last = std::max(1.0, r.pretrace_end * longer_side);
  const double halvings = std::floor(std::log2(first / last) + 1 - 1e-10);
  return std::clamp(static_cast<int>(halvings) + 1, 1, 252);
}

void pretrace_points(const PretraceTile::Patch& patch, double spacing, std::uint32_t seed,
                     const std::function<void(double, double)>& visit) {
  const double centre = (spacing - 1) / 2;
  const double wander = std::min(1.0, spacing / 2);
  int i = static_cast<int>(patch.left) * 31 + static_cast<int>(patch.top) * 1013;
  for (double y = std::ceil(patch.top / spacing) * spacing; y < patch.bottom; y += spacing) {
    for (double x = std::ceil(patch.left / spacing) * spacing; x < patch.right; x += spacing) {
      const double dx = wander * jitter(seed, i++);
      const double dy = wander * jitter(seed, i++);
      visit(x + centre + dx, y + centre + dy);
    }
  }
}

std::vector<PretraceTile::Patch> divided(const PretraceTile::Patch& patch, double spacing) {
  const double side = std::min(patch.right - patch.left, patch.bottom - patch.top);
  if (side / 2 < 4 * spacing) return {patch};
  const double x = (patch.left + patch.right) / 2;
  const double y = (patch.top + patch.bottom) / 2;
  std::vector<PretraceTile::Patch> all;
  for (const PretraceTile::Patch& quarter :
       {PretraceTile::Patch{patch.left, patch.top, x, y}, {x, patch.top, patch.right, y},
        {patch.left, y, x, patch.bottom}, {x, y, patch.right, patch.bottom}}) {
    for (const PretraceTile::Patch& part : divided(quarter, spacing)) all.push_back(part);
  }
  return all;
}

}  // namespace durer::tracer
