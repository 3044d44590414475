#include "tracer/film/lens_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "tracer/shading/pigment.h"

namespace durer::tracer {
namespace {

// The order matters: batches end where the points so far are spread evenly.
constexpr std::array<dvec2, 4> square_of_4{dvec2(-0.25, 0.25), dvec2(0.25, 0.25),
                                           dvec2(-0.25, -0.25), dvec2(0.25, -0.25)};
constexpr std::array<dvec2, 7> hexagon_of_7{
    dvec2(-0.288675, 0), dvec2(0, 0),           dvec2(0.288675, 0),    dvec2(-0.144338, 0.25),
    dvec2(-0.144338, -0.25), dvec2(0.144338, 0.25), dvec2(0.144338, -0.25)};
constexpr std::array<dvec2, 19> hexagon_of_19{
    dvec2(-0.192450, 0.333333),  dvec2(-0.192450, -0.333333), dvec2(0.192450, 0.333333),
    dvec2(0.192450, -0.333333),  dvec2(0.384900, 0),          dvec2(-0.384900, 0),
    dvec2(0, 0),                 dvec2(0, 0.333333),          dvec2(0, -0.333333),
    dvec2(-0.288675, 0.166667),  dvec2(-0.288675, -0.166667), dvec2(0.288675, 0.166667),
    dvec2(0.288675, -0.166667),  dvec2(-0.096225, 0.166667),  dvec2(-0.096225, -0.166667),
    dvec2(0.096225, 0.166667),   dvec2(0.096225, -0.166667),  dvec2(-0.192450, 0),
    dvec2(0.192450, 0)};
constexpr std::array<dvec2, 37> hexagon_of_37{
    dvec2(0, 0),                 dvec2(-0.216506, 0.375),     dvec2(0.216506, -0.375),
    dvec2(-0.216506, -0.375),    dvec2(0.216506, 0.375),      dvec2(-0.433013, 0),
    dvec2(0.433013, 0),          dvec2(-0.144338, 0.25),      dvec2(0.144338, -0.25),
    dvec2(-0.144338, -0.25),     dvec2(0.144338, 0.25),       dvec2(-0.288675, 0),
    dvec2(0.288675, 0),          dvec2(-0.072169, 0.125),     dvec2(0.072169, -0.125),
    dvec2(-0.072169, -0.125),    dvec2(0.072169, 0.125),      dvec2(-0.144338, 0),
    dvec2(0.144338, 0),          dvec2(-0.360844, 0.125),     dvec2(-0.360844, -0.125),
    dvec2(0.360844, 0.125),      dvec2(0.360844, -0.125),     dvec2(-0.288675, 0.25),
    dvec2(-0.288675, -0.25),     dvec2(0.288675, 0.25),       dvec2(0.288675, -0.25),
    dvec2(-0.072169, 0.375),     dvec2(-0.072169, -0.375),    dvec2(0.072169, 0.375),
    dvec2(0.072169, -0.375),     dvec2(-0.216506, 0.125),     dvec2(-0.216506, -0.125),
    dvec2(0.216506, 0.125),      dvec2(0.216506, -0.125),     dvec2(0, 0.25),
    dvec2(0, -0.25)};
constexpr std::array batches_of_7{7};
constexpr std::array batches_of_19{7, 6, 6};
constexpr std::array batches_of_37{7, 6, 6, 4, 4, 4, 4, 2};

struct BaseSet {
  std::span<const dvec2> points;
  std::span<const int> batches;
};

BaseSet base_set(int count) {
  if (count >= 37) return {hexagon_of_37, batches_of_37};
  if (count >= 19) return {hexagon_of_19, batches_of_19};
  if (count >= 7) return {hexagon_of_7, batches_of_7};
  return {std::span(square_of_4).first(static_cast<std::size_t>(std::min(count, 4))), {}};
}

double jitter_of(int count) {
  switch (count) {
    case 7: return 0.144338;
    case 19: return 0.096225;
    case 37: return 0.0721688;
    default: return 0.5 / std::sqrt(count);
  }
}

/// Digits of k to a base, mirrored at the point.
double radical_inverse(int base, int k) {
  double sum = 0;
  for (double place = 1.0 / base; k > 0; k /= base, place /= base) sum += place * (k % base);
  return sum;
}

/// Cells of the square around the lens; a cell takes one point, as long as there are others.
class Cells {
 public:
  explicit Cells(int along) : along_(along), taken_(static_cast<std::size_t>(along * along)) {}
  [[nodiscard]] std::size_t of(dvec2 p) const {
    const auto index = [&](double x) {
      return std::min(along_ - 1, static_cast<int>((x + 0.5) * along_));
    };
    return static_cast<std::size_t>(index(p.y) * along_ + index(p.x));
  }
  [[nodiscard]] bool taken(std::size_t cell) const { return taken_[cell]; }
  void take(std::size_t cell) { taken_[cell] = true; }

 private:
  int along_;
  std::vector<bool> taken_;
};

}  // namespace

LensPoints round_lens(int count) {
  const BaseSet base = base_set(count);
  LensPoints lens{{base.points.begin(), base.points.end()}, jitter_of(count), base.batches};
  const int along = 2 * static_cast<int>(std::ceil(std::sqrt(count / std::numbers::pi))) + 1;
  Cells cells(along);
  for (const dvec2 p : lens.points) cells.take(cells.of(p));
  int budget = 10 * count;
  for (int k = 1; static_cast<int>(lens.points.size()) < count; ++k) {
    const double r = std::sqrt(0.25 * radical_inverse(2, k));
    const double angle = 2 * std::numbers::pi * radical_inverse(3, k);
    const dvec2 p(r * std::cos(angle), r * std::sin(angle));
    const std::size_t cell = cells.of(p);
    const bool must = budget <= count - static_cast<int>(lens.points.size());
    --budget;
    if (!must && (cells.taken(cell) || glm::dot(p, p) > 0.25)) continue;
    cells.take(cell);
    lens.points.push_back(p);
  }
  return lens;
}

LensPoints bokeh_lens(int count, const scene::Pigment& pigment, const scene::Settings& settings) {
  PigmentStore pigments(settings);
  const PigmentId id = pigments.add(pigment, {});
  LensPoints lens{{}, 0.5 / std::sqrt(count), {}};
  std::mt19937 random;
  random.discard(1);
  const double all = static_cast<double>(count) * count;
  for (int k = 1; static_cast<int>(lens.points.size()) < count; ++k) {
    const dvec2 p(radical_inverse(2, k) - 0.5, radical_inverse(3, k) - 0.5);
    const double bright = grey(pigments.at(id, {p.x + 0.5, p.y + 0.5, 0}).rgb);
    // Dark lenses take what comes after many tries.
    const double drawn = static_cast<double>(random()) / 4294967296.0;
    if (drawn <= bright + (k - 1) / all) lens.points.push_back(p);
  }
  return lens;
}

}  // namespace durer::tracer
