#include "functions/box_trends.h"

#include <atomic>

#include "functions/dependence.h"
#include "functions/machine.h"

namespace durer::functions {

BoxTrends::BoxTrends(FunctionRef function) : function_(std::move(function)) {
  static std::atomic<std::uint64_t> last{0};
  number_ = ++last;
  for (unsigned changed = 1; changed < parts_.size(); ++changed) {
    parts_[changed] = depending_on(*function_, changed);
  }
}

Trend BoxTrends::operator()(const Box& box, Workspace& w, Memory& memory) const {
  const Function& f = *function_;
  const bool known = memory.owner_ == number_;
  unsigned changed = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Interval& last = memory.box_[i];
    if (known && last.lo == box[i].lo && last.hi == box[i].hi) continue;
    changed |= 1U << i;
  }
  if (!known) memory.registers_.resize(f.registers);
  Trend* const registers = memory.registers_.data();
  for (std::size_t i = 0; i < 3; ++i) {
    if ((changed >> i & 1U) != 0) registers[i] = Trend::coordinate(box[i], i);
  }
  Machine<Trend> machine(known ? parts_[changed] : f, registers, w);
  if (!known) machine.load_constants();
  if (changed != 0) machine.run();
  memory.owner_ = number_;
  memory.box_ = box;
  return registers[f.results[0]];
}

}  // namespace durer::functions
