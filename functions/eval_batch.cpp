#include <algorithm>

#include "functions/machine.h"

namespace durer::functions {

void call_external(const External& e, const Context& c, const Pack* a, Pack* out) {
  if (e.batch != nullptr) return e.batch(e.self.get(), c, a, out);
  std::array<double, max_internal_arguments> point{};
  std::array<double, max_components> result{};
  for (int lane = 0; lane < Pack::lanes; ++lane) {
    for (int i = 0; i < e.arity; ++i) point[i] = a[i].v[lane];
    e.point(e.self.get(), c, point.data(), result.data());
    for (int i = 0; i < e.components; ++i) out[i].v[lane] = result[i];
  }
}

template class Evaluator<Pack>;

void evaluate_batch(const Function& f, std::span<const double* const> arguments, std::size_t n,
                    double* out, Workspace& w) {
  const auto mark = w.batches.mark();
  const std::span packs(w.batches.push(arguments.size()), arguments.size());
  Evaluator<Pack> evaluator(f, w);
  for (std::size_t first = 0; first < n; first += Pack::lanes) {
    const std::size_t lanes = std::min<std::size_t>(Pack::lanes, n - first);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      const double* from = arguments[i] + first;
      if (lanes == Pack::lanes) {
        simd::best_tape_lanes->copy(from, 1, &packs[i]);
      } else {  // idle lanes repeat the last
        std::fill(std::copy_n(from, lanes, packs[i].v.begin()), packs[i].v.end(), from[lanes - 1]);
      }
    }
    std::copy_n(evaluator.in_place(packs).v.begin(), lanes, out + first);
  }
  w.batches.pop_to(mark);
}

}  // namespace durer::functions
