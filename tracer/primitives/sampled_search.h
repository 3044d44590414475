// Where a line meets an isosurface whose function cannot be bounded over boxes, because patterns,
// pigments or splines take part. It is sampled as densely as `max_gradient` asks for, which is all
// that the oracle does for any function: if that is too small, parts of the surface are lost.
#pragma once

#include "tracer/primitives/container.h"
#include "tracer/primitives/isosurface_shape.h"

namespace durer::tracer {

class SampledSearch {
 public:
  SampledSearch(const IsosurfaceData& data, const Ray& ray, double t_from, double t_to);
  ~SampledSearch() { data_.note_slope(steepest_ / length_); }
  SampledSearch(const SampledSearch&) = delete;
  SampledSearch& operator=(const SampledSearch&) = delete;

  /// As FieldSearch::run.
  template <typename Take>
  int run(const Stretch& stretch, Take take) {
    const double from = std::max(stretch.from, t_from_);
    const double to = std::min(stretch.to, t_to_);
    Sample a = sample(from);
    if (from == stretch.from && take(from, a.sign())) return 0;
    const Sample end = sample(to);
    while (const auto t = first_change(a, end)) {
      a = {*t, a.g > 0 ? -0.0 : std::numeric_limits<double>::min()};  // just behind it
      if (take(*t, a.sign())) return 0;
    }
    return to == stretch.to ? end.sign() : 0;
  }

 private:
  struct Sample {
    double t;
    double g;  // function - threshold
    [[nodiscard]] int sign() const { return g <= 0 ? -1 : 1; }
  };
  [[nodiscard]] Sample sample(double t);
  [[nodiscard]] std::optional<double> first_change(const Sample& a, const Sample& b);
  [[nodiscard]] double refined(Sample a, Sample b);

  const IsosurfaceData& data_;
  Ray ray_;
  double length_;
  double t_from_;
  double t_to_;
  double accuracy_;  // along the line, in units of |d|
  double gradient_;  // of g along the line, at most
  double steepest_ = 0;
  functions::Evaluator<double> evaluator_;
};

}  // namespace durer::tracer
