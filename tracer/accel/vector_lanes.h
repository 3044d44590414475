// Sixteen floats, or eight doubles, in as many registers as the processor needs for them. Code that
// is written over these types gives the same bits on every processor.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "functions/simd/inline.h"
#include "functions/simd/processor.h"

#if defined(__x86_64__)
#include <immintrin.h>  // declares the built-in functions
#endif

namespace durer::tracer::wide {

using Float2 = float __attribute__((vector_size(8)));
using Float4 = float __attribute__((vector_size(16)));
using Float8 = float __attribute__((vector_size(32)));
using Float16 = float __attribute__((vector_size(64)));
using Double2 = double __attribute__((vector_size(16)));
using Double4 = double __attribute__((vector_size(32)));
using Double8 = double __attribute__((vector_size(64)));

/// As many floats as there are doubles in a register.
template <class Register>
struct NarrowOf {
  using Floats = Float2;
};
template <>
struct NarrowOf<Double4> {
  using Floats = Float4;
};
template <>
struct NarrowOf<Double8> {
  using Floats = Float8;
};

/// One register; see the general form below.
template <class Number_, class Register, int registers>
struct Lanes;

template <class Number_, class Register>
struct Lanes<Number_, Register, 1> {
  using Number = Number_;
  static constexpr int size = sizeof(Register) / sizeof(Number);
  Register v;

  static DURER_INLINE Lanes all(Number x) { return {all_of(x)}; }
  static DURER_INLINE Lanes load(const Number* p) {
    Lanes r;
    std::memcpy(&r.v, p, sizeof r.v);
    return r;
  }
  /// Of floats, for lanes of doubles.
  static DURER_INLINE Lanes widened(const float* p) {
    typename NarrowOf<Register>::Floats narrow;
    std::memcpy(&narrow, p, sizeof narrow);
    return {__builtin_convertvector(narrow, Register)};
  }
  DURER_INLINE void store(Number* p) const { std::memcpy(p, &v, sizeof v); }
  /// Doubles as floats.
  DURER_INLINE void narrowed(float* p) const {
    const auto narrow = __builtin_convertvector(v, typename NarrowOf<Register>::Floats);
    std::memcpy(p, &narrow, sizeof narrow);
  }

  DURER_INLINE Lanes operator+(Lanes o) const { return {v + o.v}; }
  DURER_INLINE Lanes operator-(Lanes o) const { return {v - o.v}; }
  DURER_INLINE Lanes operator*(Lanes o) const { return {v * o.v}; }
  DURER_INLINE Lanes operator/(Lanes o) const { return {v / o.v}; }
  /// a < b ? a : b, and a > b ? a : b.
  friend DURER_INLINE Lanes least(Lanes a, Lanes b) { return {min_of(a.v, b.v)}; }
  friend DURER_INLINE Lanes most(Lanes a, Lanes b) { return {max_of(a.v, b.v)}; }
  friend DURER_INLINE Lanes abs(Lanes a) { return {max_of(a.v, -a.v)}; }
  /// Of doubles.
  friend DURER_INLINE Lanes root(Lanes a) { return {root_of(a.v)}; }
  /// Of floats: the one or the other.
  friend DURER_INLINE Lanes chosen(bool first, Lanes a, Lanes b) {
    return {chosen_of(first, a.v, b.v)};
  }
  /// A bit for every lane where a > b.
  friend DURER_INLINE unsigned above(Lanes a, Lanes b) { return bits_above(a.v, b.v); }

 private:
  static constexpr bool is_float = sizeof(Number) == 4;

  // GCC does not see these in the plain form, and its intrinsics would not fit into code for
  // several instruction sets.
  static DURER_INLINE Register all_of(Number x) {
#if defined(__x86_64__) && !defined(__clang__)
    if constexpr (is_float && sizeof(Register) == 64) {
      return __builtin_ia32_broadcastss512(Float4{x}, Register{}, static_cast<std::uint16_t>(-1));
    } else if constexpr (sizeof(Register) == 64) {
      return __builtin_ia32_broadcastsd512(Double2{x}, Register{}, static_cast<std::uint8_t>(-1));
    } else if constexpr (is_float && sizeof(Register) == 32) {
      return __builtin_ia32_vbroadcastss_ps256(Float4{x});
    } else if constexpr (sizeof(Register) == 32) {
      return __builtin_ia32_vbroadcastsd_pd256(Double2{x});
    }
#endif
    return x - Register{};  // not +, which would be carried out
  }
  static DURER_INLINE Register min_of(Register a, Register b) {
#if defined(__x86_64__) && !defined(__clang__)
    if constexpr (is_float && sizeof(Register) == 64) {
      return __builtin_ia32_minps512_mask(a, b, a, static_cast<std::uint16_t>(-1), 4);
    } else if constexpr (sizeof(Register) == 64) {
      return __builtin_ia32_minpd512_mask(a, b, a, static_cast<std::uint8_t>(-1), 4);
    } else if constexpr (is_float && sizeof(Register) == 32) {
      return __builtin_ia32_minps256(a, b);
    } else if constexpr (sizeof(Register) == 32) {
      return __builtin_ia32_minpd256(a, b);
    } else if constexpr (is_float) {
      return __builtin_ia32_minps(a, b);
    } else {
      return __builtin_ia32_minpd(a, b);
    }
#else
    return a < b ? a : b;
#endif
  }
  static DURER_INLINE Register max_of(Register a, Register b) {
#if defined(__x86_64__) && !defined(__clang__)
    if constexpr (is_float && sizeof(Register) == 64) {
      return __builtin_ia32_maxps512_mask(a, b, a, static_cast<std::uint16_t>(-1), 4);
    } else if constexpr (sizeof(Register) == 64) {
      return __builtin_ia32_maxpd512_mask(a, b, a, static_cast<std::uint8_t>(-1), 4);
    } else if constexpr (is_float && sizeof(Register) == 32) {
      return __builtin_ia32_maxps256(a, b);
    } else if constexpr (sizeof(Register) == 32) {
      return __builtin_ia32_maxpd256(a, b);
    } else if constexpr (is_float) {
      return __builtin_ia32_maxps(a, b);
    } else {
      return __builtin_ia32_maxpd(a, b);
    }
#else
    return a > b ? a : b;
#endif
  }
  static DURER_INLINE Register root_of(Register a) {
#if defined(__x86_64__) && !defined(__clang__)
    if constexpr (sizeof(Register) == 64) {
      return __builtin_ia32_sqrtpd512_mask(a, a, static_cast<std::uint8_t>(-1), 4);
    } else if constexpr (sizeof(Register) == 32) {
      return __builtin_ia32_sqrtpd256(a);
    } else {
      return __builtin_ia32_sqrtpd(a);
    }
#else
    for (int i = 0; i < size; ++i) a[i] = std::sqrt(a[i]);
    return a;
#endif
  }
  static DURER_INLINE Register chosen_of(bool first, Register a, Register b) {
#if defined(__x86_64__) && !defined(__clang__)
    if constexpr (sizeof(Register) == 64) {
      const auto mask = static_cast<std::uint16_t>(first ? -1 : 0);
      return __builtin_ia32_blendmps_512_mask(b, a, mask);
    }
#endif
    return first ? a : b;
  }
  static DURER_INLINE unsigned bits_above(Register a, Register b) {
#if defined(__x86_64__) && !defined(__clang__)
    constexpr int greater = 0x1e;  // false where one is not a number
    if constexpr (is_float && sizeof(Register) == 64) {
      return static_cast<std::uint16_t>(
          __builtin_ia32_cmpps512_mask(a, b, greater, static_cast<std::uint16_t>(-1), 4));
    } else if constexpr (sizeof(Register) == 64) {
      return static_cast<std::uint8_t>(
          __builtin_ia32_cmppd512_mask(a, b, greater, static_cast<std::uint8_t>(-1), 4));
    } else if constexpr (is_float && sizeof(Register) == 32) {
      return static_cast<unsigned>(__builtin_ia32_movmskps256(std::bit_cast<Register>(a > b)));
    } else if constexpr (sizeof(Register) == 32) {
      return static_cast<unsigned>(__builtin_ia32_movmskpd256(std::bit_cast<Register>(a > b)));
    } else if constexpr (is_float) {
      return static_cast<unsigned>(__builtin_ia32_movmskps(std::bit_cast<Register>(a > b)));
    } else {
      return static_cast<unsigned>(__builtin_ia32_movmskpd(std::bit_cast<Register>(a > b)));
    }
#else
    const auto mask = a > b;
    unsigned bits = 0;
    for (int i = 0; i < size; ++i) bits |= (mask[i] != 0 ? 1U : 0U) << i;
    return bits;
#endif
  }
};

template <class Number_, class Register, int registers>
struct Lanes {
  using Number = Number_;
  using Half = Lanes<Number, Register, registers / 2>;
  static constexpr int size = 2 * Half::size;
  Half lo, hi;

  static DURER_INLINE Lanes all(Number x) {
    const Half half = Half::all(x);
    return {half, half};
  }
  static DURER_INLINE Lanes load(const Number* p) {
    return {Half::load(p), Half::load(p + Half::size)};
  }
  static DURER_INLINE Lanes widened(const float* p) {
    return {Half::widened(p), Half::widened(p + Half::size)};
  }
  DURER_INLINE void store(Number* p) const {
    lo.store(p);
    hi.store(p + Half::size);
  }
  DURER_INLINE void narrowed(float* p) const {
    lo.narrowed(p);
    hi.narrowed(p + Half::size);
  }
  DURER_INLINE Lanes operator+(Lanes o) const { return {lo + o.lo, hi + o.hi}; }
  DURER_INLINE Lanes operator-(Lanes o) const { return {lo - o.lo, hi - o.hi}; }
  DURER_INLINE Lanes operator*(Lanes o) const { return {lo * o.lo, hi * o.hi}; }
  DURER_INLINE Lanes operator/(Lanes o) const { return {lo / o.lo, hi / o.hi}; }
  friend DURER_INLINE Lanes least(Lanes a, Lanes b) {
    return {least(a.lo, b.lo), least(a.hi, b.hi)};
  }
  friend DURER_INLINE Lanes most(Lanes a, Lanes b) { return {most(a.lo, b.lo), most(a.hi, b.hi)}; }
  friend DURER_INLINE Lanes abs(Lanes a) { return {abs(a.lo), abs(a.hi)}; }
  friend DURER_INLINE Lanes root(Lanes a) { return {root(a.lo), root(a.hi)}; }
  friend DURER_INLINE Lanes chosen(bool first, Lanes a, Lanes b) {
    return {chosen(first, a.lo, b.lo), chosen(first, a.hi, b.hi)};
  }
  friend DURER_INLINE unsigned above(Lanes a, Lanes b) {
    return above(a.lo, b.lo) | above(a.hi, b.hi) << Half::size;
  }
};

/// 64 bytes of numbers in registers of 16, 32 or 64 bytes.
template <int bytes>
struct LanesOf;
template <>
struct LanesOf<16> {
  using Floats = Lanes<float, Float4, 4>;
  using Doubles = Lanes<double, Double2, 4>;
};
template <>
struct LanesOf<32> {
  using Floats = Lanes<float, Float8, 2>;
  using Doubles = Lanes<double, Double4, 2>;
};
template <>
struct LanesOf<64> {
  using Floats = Lanes<float, Float16, 1>;
  using Doubles = Lanes<double, Double8, 1>;
};

}  // namespace durer::tracer::wide
