#include <algorithm>

#include "functions/machine.h"

namespace durer::functions {

void call_external(const External& e, const Context& c, const Trend* a, Trend* out) {
  std::array<Interval, max_internal_arguments> box;
  std::array<Interval, max_components> result;
  for (int i = 0; i < e.arity; ++i) box[i] = a[i].range();
  call_external(e, c, box.data(), result.data());
  for (int i = 0; i < e.components; ++i) out[i] = Trend::erratic(result[i]);
}

template class Evaluator<Trend>;

Trend evaluate_trend(const Function& f, std::span<const Interval> box, Workspace& w) {
  const auto mark = w.trends.mark();
  const std::span arguments(w.trends.push(box.size()), box.size());
  for (std::size_t i = 0; i < box.size(); ++i) arguments[i] = Trend::coordinate(box[i], i);
  const Trend result = Evaluator<Trend>(f, w)(arguments);
  w.trends.pop_to(mark);
  return result;
}

Trend evaluate_along(const Function& f, dvec3 origin, dvec3 direction, Interval t, Workspace& w) {
  std::array<Trend, 3> arguments;
  for (int k = 0; k < 3; ++k) {
    const double a = origin[k] + t.lo * direction[k];
    const double b = origin[k] + t.hi * direction[k];
    const double pad = 1e-15 * (std::abs(a) + std::abs(b));
    arguments[static_cast<std::size_t>(k)] = {{std::min(a, b) - pad, std::max(a, b) + pad},
                                              Trend::Slopes{direction[k], 0.0, 0.0}};
  }
  return Evaluator<Trend>(f, w)(arguments);
}

}  // namespace durer::functions
