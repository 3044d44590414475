#include "tracer/film/lens.h"

#include <cmath>

#include "tracer/chi_square.h"
#include "tracer/film/jitter.h"
#include "tracer/film/lens_points.h"

namespace durer::tracer {

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
