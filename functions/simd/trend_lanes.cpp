#include "functions/simd/trend_lanes.h"

#include "base/circle.h"
#include "base/trend.h"
#include "functions/simd/processor.h"
#include "functions/simd/quad.h"

namespace durer::functions::simd {
namespace {

/// True if the ends are finite, like Ranges::is_bounded().
DURER_INLINE bool narrow(const WideQuad& lo, const WideQuad& hi) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const auto m = hi.v - lo.v < inf;
#if defined(__x86_64__) && !defined(__clang__)
  return __builtin_ia32_movmskpd256(Double4(m)) == 15;
#else
  return (m[0] & m[1] & m[2] & m[3]) != 0;
#endif
}
DURER_INLINE bool narrow(const PairQuad& lo, const PairQuad& hi) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const auto m = (hi.lo - lo.lo < inf) & (hi.hi - lo.hi < inf);
  return (m[0] & m[1]) != 0;
}
DURER_INLINE WideQuad least(const WideQuad& a, const WideQuad& b) { return {smaller(a.v, b.v)}; }
DURER_INLINE WideQuad greatest(const WideQuad& a, const WideQuad& b) { return {larger(b.v, a.v)}; }
DURER_INLINE PairQuad least(const PairQuad& a, const PairQuad& b) {
  return {smaller(a.lo, b.lo), smaller(a.hi, b.hi)};
}
DURER_INLINE PairQuad greatest(const PairQuad& a, const PairQuad& b) {
  return {larger(b.lo, a.lo), larger(b.hi, a.hi)};
}
DURER_INLINE WideQuad negated(const WideQuad& a) { return {-a.v}; }
DURER_INLINE PairQuad negated(const PairQuad& a) { return {-a.lo, -a.hi}; }
/// The first lane replaced.
DURER_INLINE WideQuad with_first(const WideQuad& a, double first) {
  return {__builtin_shufflevector(a.v, Double4{first, first, first, first}, 4, 1, 2, 3)};
}
DURER_INLINE PairQuad with_first(const PairQuad& a, double first) {
  return {Double2{first, a.lo[1]}, a.hi};
}

/// Ends of the value and of the slopes, in registers.
template <class Quad>
struct Ends {
  Quad lo, hi;

  DURER_INLINE explicit Ends(const Trend& t)
      : lo(Quad::load(reinterpret_cast<const double*>(t.all().lo))),
        hi(Quad::load(reinterpret_cast<const double*>(t.all().hi))) {}
  DURER_INLINE Ends(Quad l, Quad h) : lo(l), hi(h) {}

  /// Each times the same range.
  DURER_INLINE Ends times(double from, double to) const {
    const Quad first = Quad::all(&from);
    const Quad last = Quad::all(&to);
    const Quad p = lo * first;
    const Quad q = lo * last;
    const Quad u = hi * first;
    const Quad v = hi * last;
    return {least(least(p, q), least(u, v)), greatest(greatest(p, q), greatest(u, v))};
  }
  DURER_INLINE Ends first(double from, double to) const {
    return {with_first(lo, from), with_first(hi, to)};
  }
  /// False, and nothing stored, if some end is not finite.
  DURER_INLINE bool store(Trend& to, bool nan) const {
    if (!narrow(lo, hi)) return false;
    to.assign(lo, hi, nan, true);
    return true;
  }
};

/// The operations of base/trend.h on bounded trends. False if they have to do it.
template <class Quad>
class Runner {
 public:
  DURER_INLINE Runner(const Function& f, Trend* registers)
      : operands_(f.operands.data()), r_(registers) {}

  DURER_INLINE std::uint32_t run(const Instruction* code, std::uint32_t pc, std::uint32_t end) {
    for (; pc < end; ++pc) {
      if (!done(code[pc])) return pc;
    }
    return pc;
  }

 private:
  using All = Ends<Quad>;

  DURER_INLINE bool done(const Instruction& in) {
    switch (in.op) {
      case Op::waves: return waves(in);
      case Op::negate:
      case Op::square:
      case Op::absolute: return r_[in.a].is_bounded() && unary(in.op, r_[in.a], r_[in.dst]);
      case Op::add:
      case Op::subtract:
      case Op::multiply:
      case Op::minimum:
      case Op::maximum:
        return r_[in.a].is_bounded() && r_[in.b].is_bounded() &&
               binary(in.op, r_[in.a], r_[in.b], r_[in.dst]);
      default: return false;
    }
  }
  DURER_INLINE bool unary(Op op, const Trend& a, Trend& to) {
    const All x(a);
    if (op == Op::negate) return All(negated(x.hi), negated(x.lo)).store(to, a.nan());
    const Interval r = a.range();
    if (op == Op::absolute) {
      const Interval v = abs(r);
      return x.times(r.lo >= 0 ? 1 : -1, r.hi <= 0 ? -1 : 1).first(v.lo, v.hi).store(to, v.nan);
    }
    if (a.nan()) return false;
    const Interval v = sqr(r);
    return x.times(2 * r.lo, 2 * r.hi).first(v.lo, v.hi).store(to, v.nan);
  }
  DURER_INLINE bool binary(Op op, const Trend& a, const Trend& b, Trend& to) {
    const All x(a);
    const All y(b);
    const bool nan = a.nan() || b.nan();
    if (op == Op::add) return All(x.lo + y.lo, x.hi + y.hi).store(to, nan);
    if (op == Op::subtract) return All(x.lo - y.hi, x.hi - y.lo).store(to, nan);
    const Interval p = a.range();
    const Interval q = b.range();
    if (op == Op::multiply) {
      const All u = x.times(q.lo, q.hi);
      const All v = y.first(0, 0).times(p.lo, p.hi);
      return All(u.lo + v.lo, u.hi + v.hi).store(to, nan);
    }
    return !nan && extreme(op == Op::minimum, a, b, to);
  }
  DURER_INLINE bool extreme(bool lower, const Trend& a, const Trend& b, Trend& to) {
    const Interval p = a.range();
    const Interval q = b.range();
    if (p.hi < q.lo) return to = lower ? a : b, true;
    if (q.hi <= p.lo) return to = lower ? b : a, true;
    const Interval v = lower ? min(p, q) : max(p, q);
    const All x(a);
    const All y(b);
    return All(least(x.lo, y.lo), greatest(x.hi, y.hi)).first(v.lo, v.hi).store(to, v.nan);
  }
  DURER_INLINE bool waves(const Instruction& in) {
    const std::uint32_t n = in.count / 2U;
    Trend* to = r_ + in.dst;
    std::uint32_t i = 0;
    for (; i + 1 < n; i += 2, to += 4) {
      const Trend& a = r_[operands_[in.a + i]];
      const Trend& b = r_[operands_[in.a + i + 1]];
      const auto circles = circles_of<Double4>(a.range(), b.range());
      if (!wave(a, circles[0], to) || !wave(b, circles[1], to + 2)) return false;
    }
    if (i == n) return true;
    const Trend& a = r_[operands_[in.a + i]];
    return wave(a, circle_of(a.range()), to);
  }
  DURER_INLINE bool wave(const Trend& angle, const Circle& circle, Trend* to) {
    if (!angle.is_bounded() || angle.nan()) return false;
    const All x(angle);
    const auto& [s, c] = circle;
    return x.times(c.lo, c.hi).first(s.lo, s.hi).store(to[0], false) &&
           x.times(-s.hi, -s.lo).first(c.lo, c.hi).store(to[1], false);
  }

  const Register* operands_;
  Trend* r_;
};

std::uint32_t baseline(const Function& f, Trend* registers, std::uint32_t pc, std::uint32_t end) {
  return Runner<PairQuad>(f, registers).run(f.code.data(), pc, end);
}
#ifdef __x86_64__
DURER_AVX2 std::uint32_t avx2(const Function& f, Trend* registers, std::uint32_t pc,
                              std::uint32_t end) {
  return Runner<WideQuad>(f, registers).run(f.code.data(), pc, end);
}
#endif

}  // namespace

std::vector<TrendLanes> all_trend_lanes() {
  std::vector<TrendLanes> all{baseline};
#ifdef __x86_64__
  if (durer::simd::has_avx2()) all.push_back(avx2);
#endif
  return all;
}

// Whoever asks before the second line has run gets the baseline, which gives the same bits.
constinit TrendLanes best_trend_lanes = baseline;

namespace {

[[maybe_unused]] const bool chosen = [] {
  best_trend_lanes = all_trend_lanes().back();
  return true;
}();

}  // namespace
}  // namespace durer::functions::simd
