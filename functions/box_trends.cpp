#include "functions/box_trends.h"

#include <atomic>

#include "functions/dependence.h"
#include "functions/machine.h"

namespace durer::functions {
namespace {

bool same(double a, double b) { return a == b; }
bool same(const Interval& a, const Interval& b) { return a.lo == b.lo && a.hi == b.hi; }
Trend argument(const Interval& edge, std::size_t axis) { return Trend::coordinate(edge, axis); }
double argument(double coordinate, std::size_t /*axis*/) { return coordinate; }

}  // namespace

BoxTrends::BoxTrends(FunctionRef function) : whole_(with_single_waves(*function)) {
  static std::atomic<std::uint64_t> last{0};
  number_ = ++last;
  for (unsigned changed = 1; changed < parts_.size(); ++changed) {
    parts_[changed] = depending_on(*function, changed);
  }
}

template <class T, class Arguments>
const T& BoxTrends::evaluate_anew(const Arguments& arguments, Workspace& w,
                                  Memory::Last<T, Arguments>& last) const {
  const bool known = last.owner == number_;
  if (!known) last.registers.resize(whole_.registers);
  T* const registers = last.registers.data();
  unsigned changed = 0;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (known && same(last.arguments[i], arguments[i])) continue;
    changed |= 1U << i;
    registers[i] = argument(arguments[i], i);
  }
  Machine<T> machine(known ? parts_[changed] : whole_, registers, w);
  if (!known) machine.load_constants();
  if (changed != 0) machine.run();
  last.owner = number_;
  last.arguments = arguments;
  return registers[whole_.results[0]];
}

Trend BoxTrends::operator()(const Box& box, Workspace& w, Memory& memory) const {
  return evaluate_anew(box, w, memory.box_);
}

double BoxTrends::operator()(const Point& p, Workspace& w, Memory& memory) const {
  return evaluate_anew(p, w, memory.point_);
}

}  // namespace durer::functions
