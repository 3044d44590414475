// A lens with an aperture: where on it samples are taken, and when there are enough (shading §2.7).
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "scene/scene.h"
#include "tracer/film/antialias.h"

namespace durer::tracer {

class LensSampling {
 public:
  explicit LensSampling(const scene::Scene& scene);

  /// False: a pinhole.
  [[nodiscard]] bool blurs() const { return !points_.empty(); }

  /// Samples that `moved` and `on_lens` tell apart.
  [[nodiscard]] int points() const { return static_cast<int>(points_.size()); }

  /// Where a sample of the picture at (x, y), in pixels, is looked at instead …
  [[nodiscard]] dvec2 moved(double x, double y, int sample) const;
  /// … and through which part of the lens, from its centre, in world units. `at`: what `moved` said.
  [[nodiscard]] dvec2 on_lens(dvec2 at, int sample) const;

  /// The mean of as many samples as are needed. `take(n)`: sample n.
  template <typename Take>
  [[nodiscard]] Pixel blur(const Take& take) const {
    Pixel sum(0.0F);
    Pixel squares(0.0F);
    const int most = static_cast<int>(points_.size());
    int n = 0;
    for (std::size_t batch = 0; n < most; ++batch) {
      const int end = std::min(most, n + batch_size(batch));
      for (; n < end; ++n) {
        const Pixel p = take(n);
        sum += p;
        squares += p * p;
      }
      if (n >= least_ && settled(sum, squares, n)) break;
    }
    return sum / static_cast<float>(n);
  }

 private:
  [[nodiscard]] int batch_size(std::size_t batch) const {
    return batch < batches_.size() ? batches_[batch] : 4;
  }
  /// True if the mean of n samples is known well enough.
  [[nodiscard]] bool settled(const Pixel& sum, const Pixel& squares, int n) const;

  double aperture_ = 0;
  int least_ = 0;
  double jitter_ = 0;
  std::vector<dvec2> points_;   // in a disc of radius 1/2, or a square
  std::span<const int> batches_;  // sizes of the first ones
  std::vector<double> thresholds_;  // variance of the mean of n samples, at n - 1
};

}  // namespace durer::tracer
