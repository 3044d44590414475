#include "tracer/film/lens.h"

#include <cmath>

#include "tracer/film/jitter.h"
#include "tracer/film/lens_points.h"

namespace durer::tracer {
namespace {

/// The lower incomplete gamma function over the complete one, by its series or, for large x, by the
/// continued fraction of its complement [Press et al., Numerical Recipes, 6.2].
double lower_gamma(double a, double x) {
  if (x <= 0) return 0;
  constexpr double tiny = 1e-300;
  constexpr double enough = 1e-15;
  constexpr int most = 10000;
  const double scale = std::exp(a * std::log(x) - x - std::lgamma(a));
  if (x < a + 1) {
    double term = 1 / a;
    double sum = term;
    for (int k = 1; k < most && term > sum * enough; ++k) sum += term *= x / (a + k);
    return sum * scale;
  }
  double b = x + 1 - a;
  double c = 1 / tiny;
  double d = 1 / b;
  double fraction = d;
  for (int k = 1; k < most; ++k) {
    const double numerator = -k * (k - a);
    b += 2;
    d = numerator * d + b;
    if (std::abs(d) < tiny) d = tiny;
    c = b + numerator / c;
    if (std::abs(c) < tiny) c = tiny;
    d = 1 / d;
    fraction *= d * c;
    if (std::abs(d * c - 1) < enough) break;
  }
  return 1 - scale * fraction;
}

}  // namespace

double chi_square_exceeded(double confidence, int freedom) {
  const double a = freedom / 2.0;
  const double below = 1 - confidence;
  double low = 0;
  double high = freedom + 1.0;
  while (lower_gamma(a, high / 2) < below) high *= 2;
  for (int i = 0; i < 200 && high - low > 1e-12 * high; ++i) {
    const double middle = (low + high) / 2;
    (lower_gamma(a, middle / 2) < below ? low : high) = middle;
  }
  return (low + high) / 2;
}

LensSampling::LensSampling(const scene::Scene& scene) {
  const scene::Lens& lens = *scene.camera.lens;
  if (lens.aperture == 0 || lens.most_samples <= 0) return;
  aperture_ = lens.aperture;
  least_ = lens.least_samples;
  const int n = lens.most_samples;
  LensPoints made = lens.has_bokeh ? bokeh_lens(n, lens.bokeh, scene.settings) : round_lens(n);
  points_ = std::move(made.points);
  jitter_ = made.jitter;
  batches_ = made.batches;
  thresholds_.assign(points_.size(), 0);
  if (n < 2 || lens.variance == 0) return;
  const double scale = lens.variance / chi_square_exceeded(lens.confidence, n - 1);
  for (int k = 0; k < n; ++k) {
    thresholds_[static_cast<std::size_t>(k)] = scale * chi_square_exceeded(lens.confidence, k + 1);
  }
}

// Offsets are multiples of 1/32 of a pixel, then a hash of these that leans to the upper left, as
// the oracle's does.
dvec2 LensSampling::moved(double x, double y, int sample) const {
  const int seed = static_cast<int>(313 * x + 11) + static_cast<int>(311 * y + 17) + sample;
  const auto offset = [](int hash) { return (2 * (hash % 16) + 1) / 32.0 - 0.5; };
  const dvec2 d(offset(shuffled(seed)), offset(shuffled(seed + 1)));
  return dvec2(x, y) + d + (jitter(d.x, d.y) - 0.5) / 16.0;
}

dvec2 LensSampling::on_lens(dvec2 at, int sample) const {
  const dvec2 p = points_[static_cast<std::size_t>(sample)];
  return aperture_ / 2 * (p + jitter(at.x + 0.5, at.y - 0.5) * (2 * jitter_));
}

bool LensSampling::settled(const Pixel& sum, const Pixel& squares, int n) const {
  const double limit = thresholds_[static_cast<std::size_t>(n - 1)];
  for (int i = 0; i < 4; ++i) {
    const double mean = sum[i] / static_cast<double>(n);
    if (!((squares[i] / static_cast<double>(n) - mean * mean) / n < limit)) return false;
  }
  return true;
}

}  // namespace durer::tracer
