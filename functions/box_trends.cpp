#include "functions/box_trends.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "functions/dependence.h"
#include "functions/machine.h"
#include "functions/operands.h"

namespace durer::functions {
namespace {

bool same(double a, double b) { return a == b; }
bool same(const Interval& a, const Interval& b) { return a.lo == b.lo && a.hi == b.hi; }
Trend argument(const Interval& edge, std::size_t axis) { return Trend::coordinate(edge, axis); }
double argument(double coordinate, std::size_t /*axis*/) { return coordinate; }

/// Draws the range of `t` together round its value at the centre of the box, as far as slopes allow.
/// Both are rounded, in calculations that may have gone through larger numbers.
void narrow(Trend& t, double at_centre, const BoxTrends::Box& box, const BoxTrends::Point& centre) {
  if (!t.is_bounded() || t.nan() || !std::isfinite(at_centre)) return;
  double swing = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Interval slope = t.slope(k);
    swing += std::max(std::abs(slope.lo), std::abs(slope.hi)) *
             std::max(box[k].hi - centre[k], centre[k] - box[k].lo);
  }
  const Interval range = t.range();
  swing += 1e-9 * (swing + std::abs(at_centre) + range.hi - range.lo);
  const double lo = std::max(range.lo, at_centre - swing);
  const double hi = std::min(range.hi, at_centre + swing);
  if (lo <= hi) t = Trend(t.all(), Interval{lo, hi});
}

}  // namespace

BoxTrends::BoxTrends(FunctionRef function) : whole_(with_stops(with_single_waves(*function))) {
  static std::atomic<std::uint64_t> last{0};
  number_ = ++last;
  for (unsigned changed = 1; changed < parts_.size(); ++changed) {
    parts_[changed] = with_stops(depending_on(whole_.tape, changed));
  }
}

BoxTrends::Part BoxTrends::with_stops(Function tape) {
  std::vector<Stop> stops;
  const auto branches = [](const Instruction& in) {
    return in.op == Op::select || in.op == Op::loop;
  };
  if (!std::any_of(tape.code.begin(), tape.code.end(), branches)) {
    // Each register once after it has been written, lest results depend on what was last.
    std::vector<bool> wide(tape.registers);
    const auto stop_for = [&](std::uint32_t pc, Register operand) {
      if (wide[operand]) stops.push_back({pc, operand});
      wide[operand] = false;
    };
    for (std::uint32_t pc = 0; pc < tape.code.size(); ++pc) {
      const Instruction& in = tape.code[pc];
      const bool first = in.op == Op::absolute || in.op == Op::minimum || in.op == Op::maximum ||
                         in.op == Op::square_root;
      const bool second = in.op == Op::minimum || in.op == Op::maximum || in.op == Op::divide;
      if (first) stop_for(pc, in.a);
      if (second) stop_for(pc, in.b);
      for (std::uint32_t k = 0; k < results_of(in); ++k) wide[in.dst + k] = true;
    }
  }
  return {std::move(tape), std::move(stops)};
}

template <class T, class Arguments>
const BoxTrends::Part* BoxTrends::prepare(const Arguments& arguments, Workspace& w,
                                          Memory::Last<T, Arguments>& last) const {
  const bool known = last.owner == number_;
  if (!known) last.registers.resize(whole_.tape.registers);
  T* const registers = last.registers.data();
  unsigned changed = 0;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (known && same(last.arguments[i], arguments[i])) continue;
    changed |= 1U << i;
    registers[i] = argument(arguments[i], i);
  }
  if (!known) Machine<T>(whole_.tape, registers, w).load_constants();
  last.owner = number_;
  last.arguments = arguments;
  return known ? &parts_[changed] : &whole_;
}

Trend BoxTrends::operator()(const Box& box, const Point& centre, Workspace& w,
                            Memory& memory) const {
  if (!whole_.stops.empty()) static_cast<void>((*this)(centre, w, memory));
  const Part& part = *prepare(box, w, memory.box_);
  Trend* const registers = memory.box_.registers.data();
  Machine<Trend> machine(part.tape, registers, w);
  std::uint32_t done = 0;
  for (const Stop& stop : part.stops) {
    machine.run(done, stop.pc);
    done = stop.pc;
    narrow(registers[stop.operand], memory.point_.registers[stop.operand], box, centre);
  }
  machine.run(done, static_cast<std::uint32_t>(part.tape.code.size()));
  return registers[whole_.tape.results[0]];
}

double BoxTrends::operator()(const Point& p, Workspace& w, Memory& memory) const {
  const Part& part = *prepare(p, w, memory.point_);
  double* const registers = memory.point_.registers.data();
  Machine<double>(part.tape, registers, w).run();
  return registers[whole_.tape.results[0]];
}

}  // namespace durer::functions
