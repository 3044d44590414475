#include <algorithm>

#include "functions/machine.h"

namespace durer::functions {
namespace {

/// Step of differences: small against what a picture shows, large against rounding.
constexpr double step = 1e-5;

}  // namespace

void call_external(const External& e, const Context& c, const Dual* a, Dual* out) {
  if (e.gradient != nullptr) return e.gradient(e.self.get(), c, a, out);
  std::array<double, max_internal_arguments> point{};
  std::array<double, max_components> lower{};
  std::array<double, max_components> upper{};
  for (int i = 0; i < e.arity; ++i) point[i] = a[i].v;
  e.point(e.self.get(), c, point.data(), lower.data());
  for (int k = 0; k < e.components; ++k) out[k] = lower[k];
  for (int i = 0; i < e.arity; ++i) {
    point[i] = a[i].v - step;
    e.point(e.self.get(), c, point.data(), lower.data());
    point[i] = a[i].v + step;
    e.point(e.self.get(), c, point.data(), upper.data());
    point[i] = a[i].v;
    for (int k = 0; k < e.components; ++k) out[k].d += (upper[k] - lower[k]) / (2 * step) * a[i].d;
  }
}

template class Evaluator<Dual>;

Dual evaluate_gradient(const Function& f, std::span<const Dual> arguments, Workspace& w) {
  return Evaluator<Dual>(f, w)(arguments);
}

Dual evaluate_gradient(const Function& f, dvec3 p, Workspace& w) {
  const std::array<Dual, 3> arguments{Dual(p.x, {1, 0, 0}), Dual(p.y, {0, 1, 0}),
                                      Dual(p.z, {0, 0, 1})};
  return evaluate_gradient(f, std::span(arguments).first(std::min<std::size_t>(f.parameters, 3)), w);
}

}  // namespace durer::functions
