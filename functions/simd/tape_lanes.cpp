#include "functions/simd/tape_lanes.h"

#include <concepts>

#include "base/circle.h"
#include "functions/simd/lanes.h"
#include "functions/simd/processor.h"

namespace durer::functions::simd {
namespace {

/// Executes instructions on vectors of type V, of which several make up a Pack. Nothing but the
/// registers of the tape lies in memory.
template <class V>
class Runner {
 public:
  DURER_INLINE Runner(const Function& f, Pack* registers)
      : operands_(f.operands.data()), r_(registers) {}

  DURER_INLINE std::uint32_t run(const Instruction* code, std::uint32_t pc, std::uint32_t end) {
    for (; pc < end; ++pc) {
      const Instruction& in = code[pc];
      switch (in.op) {
#define DURER_OP(name, arity, expression, doc)                                        \
  case Op::name:                                                                      \
    if constexpr (requires(const T& a, const T& b, const T& c, const T& d) {          \
                    { expression } -> std::same_as<T>;                                \
                  }) {                                                                \
      each<arity>(in, []([[maybe_unused]] const T& a, [[maybe_unused]] const T& b,    \
                         [[maybe_unused]] const T& c, [[maybe_unused]] const T& d)    \
                          DURER_LAMBDA_INLINE { return expression; });                \
      break;                                                                          \
    } else {                                                                          \
      return pc;                                                                      \
    }
#include "functions/ops.def"
#undef DURER_OP
        case Op::waves:
          if (!waves(in)) return pc;
          break;
        case Op::internal:
        case Op::call:
        case Op::external:
        case Op::select:
        case Op::loop: return pc;
      }
    }
    return pc;
  }

 private:
  using T = Lanes<V>;
  static constexpr int parts = Pack::lanes / T::count;

  DURER_INLINE T load(Register r, int part) const {
    return T::load(r_[r].v.data() + part * T::count);
  }
  DURER_INLINE void store(Register r, int part, T value) {
    value.store(r_[r].v.data() + part * T::count);
  }

  /// Operand `i` of a plain operation; operands beyond the arity alias the first.
  template <int arity, int i>
  DURER_INLINE Register operand(const Instruction& in) const {
    if constexpr (arity <= 2) {
      return i == 1 && arity == 2 ? in.b : in.a;
    } else {
      return operands_[in.a + (i < arity ? i : 0)];
    }
  }
  template <int arity, class F>
  DURER_INLINE void each(const Instruction& in, F f) {
    const Register a = operand<arity, 0>(in);
    const Register b = operand<arity, 1>(in);
    const Register c = operand<arity, 2>(in);
    const Register d = operand<arity, 3>(in);
    for (int i = 0; i < parts; ++i) {
      store(in.dst, i, f(load(a, i), load(b, i), load(c, i), load(d, i)));
    }
  }

  /// False if some angle has to go to the C library; then what was written is nothing.
  DURER_INLINE bool waves(const Instruction& in) {
    LaneMask<V> fit = lt(T(0), T(1));
    const Register* const angles = operands_ + in.a;
    for (std::uint32_t i = 0; i < in.count / 2U; ++i) {
      for (int part = 0; part < parts; ++part) {
        const T angle = load(angles[i], part);
        fit = both(fit, lt(abs(angle), T(circle_detail::farthest)));
        const auto circle = durer::on_circle(angle.v);
        store(in.dst + 2 * i, part, T(circle.sine));
        store(in.dst + 2 * i + 1, part, T(circle.cosine));
      }
    }
    return fit.all();
  }

  const Register* operands_;
  Pack* r_;
};

template <class V>
DURER_INLINE void copy_numbers(const double* from, std::size_t n, Pack* to) {
  for (std::size_t i = 0; i < n; ++i) {
    for (int k = 0; k < Pack::lanes; k += Lanes<V>::count, from += Lanes<V>::count) {
      Lanes<V>::load(from).store(to[i].v.data() + k);
    }
  }
}
template <class V>
DURER_INLINE void spread_numbers(const double* from, std::size_t n, Pack* to) {
  for (std::size_t i = 0; i < n; ++i) {
    for (int k = 0; k < Pack::lanes; k += Lanes<V>::count) {
      Lanes<V>(from[i]).store(to[i].v.data() + k);
    }
  }
}

// One set of entry points: `target` is the attribute of each, `V` a register.
#define DURER_TAPE_LANES(name, V, target)                                                      \
  namespace name {                                                                             \
  target std::uint32_t run(const Function& f, Pack* registers, std::uint32_t pc,               \
                           std::uint32_t end) {                                                \
    return Runner<V>(f, registers).run(f.code.data(), pc, end);                                \
  }                                                                                            \
  target void copy(const double* from, std::size_t n, Pack* to) {                              \
    copy_numbers<V>(from, n, to);                                                              \
  }                                                                                            \
  target void spread(const double* from, std::size_t n, Pack* to) {                            \
    spread_numbers<V>(from, n, to);                                                            \
  }                                                                                            \
  constexpr TapeLanes table{run, copy, spread};                                                \
  }
DURER_TAPE_LANES(baseline, Double2, )
#ifdef __x86_64__
DURER_TAPE_LANES(avx2, Double4, DURER_AVX2)
DURER_TAPE_LANES(avx512, Double8, DURER_AVX512)
#endif
#undef DURER_TAPE_LANES

}  // namespace

std::vector<const TapeLanes*> all_tape_lanes() {
  std::vector<const TapeLanes*> all{&baseline::table};
#ifdef __x86_64__
  if (durer::simd::has_avx2()) all.push_back(&avx2::table);
  if (durer::simd::has_avx512()) all.push_back(&avx512::table);
#endif
  return all;
}

// Not a function-local static, whose guard would be asked at every call. Whoever asks before the
// second line has run gets the baseline, which gives the same bits.
constinit const TapeLanes* best_tape_lanes = &baseline::table;

namespace {

[[maybe_unused]] const bool chosen = [] {
  best_tape_lanes = all_tape_lanes().back();
  return true;
}();

}  // namespace
}  // namespace durer::functions::simd
