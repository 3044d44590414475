// The interpreter of tapes, a template over the kind of number. Included by eval_*.cpp only.
#pragma once

#include <algorithm>
#include <cassert>
#include <limits>

#include "functions/evaluate.h"
#include "functions/internals.h"
#include "functions/simd/tape_lanes.h"
#include "functions/simd/trend_lanes.h"

namespace durer::functions {

// ---- which sides of select() a condition reaches: bit 0 negative, 1 zero, 2 positive
// -------------
enum Side : unsigned { negative_side = 1, zero_side = 2, positive_side = 4 };

[[nodiscard]] inline unsigned sides(double c) {
  return c < 0 ? negative_side : c == 0 ? zero_side : positive_side;
}
[[nodiscard]] inline unsigned sides(const Dual& c) { return sides(c.v); }
[[nodiscard]] inline unsigned sides(const Pack& c) {
  unsigned all = 0;
  for (const double v : c.v) all |= sides(v);
  return all;
}
[[nodiscard]] inline unsigned sides(const Interval& c) {
  return (c.lo < 0 ? negative_side : 0u) | (c.lo <= 0 && c.hi >= 0 ? zero_side : 0u) |
         (c.hi > 0 || c.nan ? positive_side : 0u);
}

[[nodiscard]] inline unsigned sides(const Trend& c) { return sides(c.range()); }

[[nodiscard]] inline FrameStack<double>& frames(Workspace& w, double) { return w.points; }
[[nodiscard]] inline FrameStack<Pack>& frames(Workspace& w, const Pack&) { return w.batches; }
[[nodiscard]] inline FrameStack<Interval>& frames(Workspace& w, const Interval&) { return w.boxes; }
[[nodiscard]] inline FrameStack<Dual>& frames(Workspace& w, const Dual&) { return w.gradients; }
[[nodiscard]] inline FrameStack<Trend>& frames(Workspace& w, const Trend&) { return w.trends; }

// ---- functions from outside
// ----------------------------------------------------------------------
void call_external(const External& e, const Context& c, const double* a, double* out);
void call_external(const External& e, const Context& c, const Pack* a, Pack* out);
void call_external(const External& e, const Context& c, const Interval* a, Interval* out);
void call_external(const External& e, const Context& c, const Dual* a, Dual* out);
void call_external(const External& e, const Context& c, const Trend* a, Trend* out);

template <class T>
[[nodiscard]] bool loop_is_unbounded(const T&, const T&) {
  return false;
}
/// Ranges of counters are followed turn by turn only while that is cheap.
[[nodiscard]] inline bool loop_is_unbounded(const Interval& from, const Interval& to) {
  return !(from.is_point() && to.is_point()) && !(to.hi - from.lo <= 1000);
}

[[nodiscard]] inline bool loop_is_unbounded(const Trend& from, const Trend& to) {
  return loop_is_unbounded(from.range(), to.range());
}

// ---- sine and cosine of a, sine and cosine of b
// ----------------------------------------------------------------------
template <class T>
void sines_and_cosines(const T& a, const T& b, T* out) {
  out[0] = sin(a);
  out[1] = cos(a);
  out[2] = sin(b);
  out[3] = cos(b);
}
inline void sines_and_cosines(const double& a, const double& b, double* out) {
  if (!fits_circle(a) || !fits_circle(b)) return sines_and_cosines<double>(a, b, out);
  const PairOnCircle c = on_circle(DoublePair{a, b});
  out[0] = c.sine[0];
  out[1] = c.cosine[0];
  out[2] = c.sine[1];
  out[3] = c.cosine[1];
}
inline void sines_and_cosines(const Pack& a, const Pack& b, Pack* out) {
  for (int lane = 0; lane < Pack::lanes; ++lane) {
    std::array<double, 4> c{};
    sines_and_cosines(a.v[lane], b.v[lane], c.data());
    for (std::size_t k = 0; k < 4; ++k) out[k].v[lane] = c[k];
  }
}
inline void sine_and_cosine(const Trend& a, Trend* out) {
  const Circle c = circle_of(a.range());
  out[0] = trend_detail::chain(c.sine, c.cosine, a);
  out[1] = trend_detail::chain(c.cosine, -c.sine, a);
}
inline void sines_and_cosines(const Trend& a, const Trend& b, Trend* out) {
  sine_and_cosine(a, out);
  sine_and_cosine(b, out + 2);
}
/// Of one angle: what it gives in company, too.
template <class T>
void sine_and_cosine(const T& a, T* out) {
  T both[4];
  sines_and_cosines(a, a, both);
  std::copy_n(both, 2, out);
}

// ---- what is moved; packs in whole vectors, because they are read so
// ----------------------------------------------------------------------
template <class T>
void copy_all(const T* from, std::size_t n, T* to) {
  std::copy_n(from, n, to);
}
inline void copy_all(const Pack* from, std::size_t n, Pack* to) {
  simd::best_tape_lanes->copy(from->v.data(), n, to);
}
template <class T>
void spread_all(const double* from, std::size_t n, T* to) {
  std::copy_n(from, n, to);
}
inline void spread_all(const double* from, std::size_t n, Pack* to) {
  simd::best_tape_lanes->spread(from, n, to);
}

/// Executes one tape on one frame of registers.
template <class T>
class Machine {
 public:
  Machine(const Function& f, T* registers, Workspace& w) : f_(f), r_(registers), w_(w) {}
  void load_constants() {
    spread_all(f_.constants.data(), f_.constants.size(), r_ + f_.parameters);
  }
  void run() { run(0, static_cast<std::uint32_t>(f_.code.size())); }
  /// Instructions `begin` … `end` - 1.
  void run(std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t pc = begin; pc < end; ++pc) {
      if constexpr (std::is_same_v<T, Pack>) {
        pc = simd::best_tape_lanes->run(f_, r_, pc, end);
        if (pc == end) return;
      }
      if constexpr (std::is_same_v<T, Trend>) {
        pc = simd::best_trend_lanes(f_, r_, pc, end);
        if (pc == end) return;
      }
      const Instruction& in = f_.code[pc];
      switch (in.op) {
#define DURER_OP(name, arity, expression, doc)           \
  case Op::name: {                                       \
    [[maybe_unused]] const T& a = operand<arity, 0>(in); \
    [[maybe_unused]] const T& b = operand<arity, 1>(in); \
    [[maybe_unused]] const T& c = operand<arity, 2>(in); \
    [[maybe_unused]] const T& d = operand<arity, 3>(in); \
    r_[in.dst] = expression;                             \
    break;                                               \
  }
#include "functions/ops.def"
#undef DURER_OP
        case Op::internal: internal(in); break;
        case Op::call: call(in); break;
        case Op::external: external(in); break;
        case Op::select: pc = select(in) - 1; break;
        case Op::loop: pc = loop(in) - 1; break;
        case Op::waves: waves(in); break;
      }
    }
  }

 private:
  /// Operand `i` of a plain operation; operands beyond the arity alias the first.
  template <int arity, int i>
  const T& operand(const Instruction& in) const {
    if constexpr (arity <= 2) {
      return r_[i == 1 && arity == 2 ? in.b : in.a];
    } else {
      return r_[f_.operands[in.a + (i < arity ? i : 0)]];
    }
  }

  void gather(std::uint32_t first, std::uint32_t n, T* to) const {
    for (std::uint32_t i = 0; i < n; ++i) to[i] = r_[f_.operands[first + i]];
  }

  void internal(const Instruction& in) {
    T arguments[max_internal_arguments];
    gather(in.a, 3 + static_cast<std::uint32_t>(internal_functions[in.count].extra), arguments);
    r_[in.dst] = internal_value(in.count, arguments, w_.context);
  }

  void call(const Instruction& in) {
    const Function& g = *f_.callees[in.b];
    FrameStack<T>& stack = frames(w_, T());
    const auto mark = stack.mark();
    T* frame = stack.push(g.registers);
    gather(in.a, g.parameters, frame);
    Machine callee(g, frame, w_);
    callee.load_constants();
    callee.run();
    for (std::uint32_t i = 0; i < in.count; ++i) r_[in.dst + i] = frame[g.results[i]];
    stack.pop_to(mark);
  }

  void external(const Instruction& in) {
    const External& e = f_.externals[in.b];
    FrameStack<T>& stack = frames(w_, T());
    const auto mark = stack.mark();
    const auto arity = static_cast<std::uint32_t>(e.arity);
    T* arguments = stack.push(arity);
    gather(in.a, arity, arguments);
    call_external(e, w_.context, arguments, r_ + in.dst);
    stack.pop_to(mark);
  }

  void waves(const Instruction& in) {
    const Register* const angle = f_.operands.data() + in.a;
    T* const out = r_ + in.dst;
    const std::size_t n = in.count / 2U;
    std::size_t i = 0;
    for (; i + 1 < n; i += 2) {
      sines_and_cosines(r_[angle[i]], r_[angle[i + 1]], out + 2 * i);
    }
    if (i < n) sine_and_cosine(r_[angle[i]], out + 2 * i);
  }

  std::uint32_t select(const Instruction& in) {
    const Select& s = f_.selects[in.b];
    const T condition = r_[s.condition];
    unsigned reached = sides(condition);
    if (s.two_way && (reached & zero_side) != 0)
      reached = (reached & negative_side) | positive_side;
    bool first = true;
    T result{};
    const auto side = [&](unsigned bit, const Branch& branch) {
      if ((reached & bit) == 0) return;
      run(branch.begin, branch.end);
      result =
          first ? r_[branch.result] : merged(condition, bit, s.two_way, r_[branch.result], result);
      first = false;
    };
    side(negative_side, s.negative);
    side(zero_side, s.zero);
    side(positive_side, s.positive);
    r_[in.dst] = result;
    return s.positive.end;
  }
  /// `value` where the condition is on side `bit`, else what the other sides gave.
  static T merged(const T& condition, unsigned bit, bool two_way, const T& value, const T& others) {
    if constexpr (std::is_same_v<T, Interval>) {
      return hull(value, others);
    } else if constexpr (std::is_same_v<T, Trend>) {
      return Trend::erratic(hull(value.range(), others.range()));
    } else if (bit == zero_side) {
      return where(eq(condition, T(0)), value, others);
    } else {  // positive: neither negative nor zero, so that NaN counts as positive
      const auto negative = lt(condition, T(0));
      return two_way ? where(negative, others, value)
                     : where(either(negative, eq(condition, T(0))), others, value);
    }
  }

  std::uint32_t loop(const Instruction& in) {
    const Loop& l = f_.loops[in.b];
    const T to = r_[l.to];
    T counter = r_[l.from];
    T total(l.product ? 1 : 0);
    bool hopeless = loop_is_unbounded(counter, to);
    while (!hopeless) {
      const auto active = le(counter, to);
      if (none(active)) break;
      hopeless = w_.loop_budget == 0;
      if (hopeless) break;
      --w_.loop_budget;
      r_[l.counter] = counter;
      run(l.body.begin, l.body.end);
      const T& term = r_[l.body.result];
      total = where(active, l.product ? T(total * term) : T(total + term), total);
      counter = counter + T(1);
    }
    r_[in.dst] = hopeless ? T(std::numeric_limits<double>::quiet_NaN()) : total;
    return l.body.end;
  }

  const Function& f_;
  T* r_;
  Workspace& w_;
};

template <class T>
Evaluator<T>::Evaluator(const Function& f, Workspace& w)
    : f_(f), w_(w), mark_(frames(w, T()).mark()), frame_(frames(w, T()).push(f.registers)) {
  Machine<T>(f_, frame_, w_).load_constants();
}
template <class T>
Evaluator<T>::~Evaluator() {
  frames(w_, T()).pop_to(mark_);
}
template <class T>
const T& Evaluator<T>::in_place(std::span<const T> arguments) {
  assert(arguments.size() == f_.parameters);
  copy_all(arguments.data(), arguments.size(), frame_);
  return in_place();
}
template <class T>
const T& Evaluator<T>::in_place() {
  Machine<T>(f_, frame_, w_).run();
  return frame_[f_.results[0]];
}
template <class T>
T Evaluator<T>::operator()(std::span<const T> arguments) {
  if constexpr (std::is_same_v<T, Pack>) {
    T result;
    copy_all(&in_place(arguments), 1, &result);
    return result;
  } else {
    return in_place(arguments);
  }
}
template <class T>
const T& Evaluator<T>::component(int i) const {
  return frame_[f_.results[static_cast<std::size_t>(i)]];
}

}  // namespace durer::functions
