#include "tracer/primitives/sampled_search.h"

#include <algorithm>
#include <cmath>

namespace durer::tracer {

SampledSearch::SampledSearch(const IsosurfaceData& data, const Ray& ray, double t_from, double t_to)
    : data_(data),
      ray_(ray),
      length_(glm::length(ray.d)),
      t_from_(t_from),
      t_to_(t_to),
      accuracy_(data.surface->accuracy / length_),
      gradient_(data.surface->max_gradient * length_),
      evaluator_(*data.surface->function, function_workspace(data.field.generator())) {
  // `evaluate P0, P1, P2`: what is given is lowered if it exceeds P0.
  const dvec3& p = data.surface->evaluate;
  if (p.x > 0 && data.surface->max_gradient > p.x) gradient_ *= p.z;
}

SampledSearch::Sample SampledSearch::sample(double t) {
  const dvec3 p = ray_.at(t);
  return {t, evaluator_(std::array{p.x, p.y, p.z}) - data_.surface->threshold};
}

/// The first change of sign between two samples that the gradient does not rule out.
std::optional<double> SampledSearch::first_change(const Sample& a, const Sample& b) {
  const double length = b.t - a.t;
  if (!(length > 0)) return std::nullopt;
  const double slope = std::abs(b.g - a.g) / length;
  if (slope == slope) {
    steepest_ = std::max(steepest_, slope);
    // Grown for this line only, so that lines do not depend on their order.
    const dvec3& p = data_.surface->evaluate;
    if (p.x > 0 && gradient_ < slope * p.y) gradient_ = slope * p.y * p.y;
  }
  const bool changes = a.sign() != b.sign();
  if (!changes && !(std::abs(a.g) + std::abs(b.g) < gradient_ * length)) return std::nullopt;
  if (length < accuracy_) {
    if (changes) return refined(a, b);
    return std::nullopt;
  }
  const Sample middle = sample(a.t + length / 2);
  if (const auto t = first_change(a, middle)) return t;
  return first_change(middle, b);
}

/// A change of sign within the accuracy, to full precision: else rays that begin on the surface
/// would meet it again.
double SampledSearch::refined(Sample a, Sample b) {
  for (int i = 0; i < 40; ++i) {
    const Sample middle = sample(a.t + (b.t - a.t) / 2);
    if (!(middle.t > a.t && middle.t < b.t)) break;
    (middle.sign() == a.sign() ? a : b) = middle;
  }
  return b.t;
}

}  // namespace durer::tracer
