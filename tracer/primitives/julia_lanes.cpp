#include "tracer/primitives/julia_lanes.h"

#include <cstdint>
#include <cstring>
#include <type_traits>

#include "functions/simd/processor.h"
#include "tracer/primitives/julia_orbit.h"

namespace durer::tracer {
namespace {

// All of this becomes part of the entry points at the end, and so is compiled for their processors.

/// Eight doubles in registers of type V.
template <class V>
struct Eight {
  static constexpr int count = sizeof(double) * julia_lanes / sizeof(V);
  V part[count];

  Eight() = default;
  explicit DURER_INLINE Eight(double v) {
    for (V& p : part) p = v - V{};
  }
  static DURER_INLINE Eight load(const JuliaOrbits::Lanes& from) {
    Eight r;
    std::memcpy(r.part, from.data(), sizeof r.part);
    return r;
  }
  DURER_INLINE void store(JuliaOrbits::Lanes& to) const {
    std::memcpy(to.data(), part, sizeof part);
  }
};
#define DURER_LANES_OP(op)                                                        \
  template <class V>                                                              \
  DURER_INLINE Eight<V> operator op(const Eight<V>& a, const Eight<V>& b) {       \
    Eight<V> r;                                                                   \
    for (int i = 0; i < Eight<V>::count; ++i) r.part[i] = a.part[i] op b.part[i]; \
    return r;                                                                     \
  }                                                                               \
  template <class V>                                                              \
  DURER_INLINE Eight<V> operator op(const Eight<V>& a, double b) {                \
    return a op Eight<V>(b);                                                      \
  }
DURER_LANES_OP(+)
DURER_LANES_OP(-)
DURER_LANES_OP(*)
#undef DURER_LANES_OP

/// Which lanes.
template <class V>
struct Mask {
  using Bits = decltype(V() < V());
  static constexpr int per_part = sizeof(Bits) / sizeof(std::int64_t);
  Bits part[Eight<V>::count];

  DURER_INLINE bool any() const {
    Bits bits = part[0];
    for (int i = 1; i < Eight<V>::count; ++i) bits |= part[i];
    std::int64_t one = 0;
    for (int i = 0; i < per_part; ++i) one |= bits[i];
    return one != 0;
  }
  DURER_INLINE unsigned bits() const {
    unsigned r = 0;
    for (int i = 0; i < static_cast<int>(julia_lanes); ++i) {
      r |= static_cast<unsigned>(part[i / per_part][i % per_part] & 1) << i;
    }
    return r;
  }
};
template <class V>
DURER_INLINE Mask<V> operator>(const Eight<V>& a, const Eight<V>& b) {
  Mask<V> r;
  for (int i = 0; i < Eight<V>::count; ++i) r.part[i] = a.part[i] > b.part[i];
  return r;
}
/// Lanes of `a` that are not in `b`.
template <class V>
DURER_INLINE Mask<V> without(const Mask<V>& a, const Mask<V>& b) {
  Mask<V> r;
  for (int i = 0; i < Eight<V>::count; ++i) r.part[i] = a.part[i] & ~b.part[i];
  return r;
}
template <class V>
DURER_INLINE void assign(const Mask<V>& m, Eight<V>& to, const Eight<V>& from) {
  for (int i = 0; i < Eight<V>::count; ++i) {
    to.part[i] = m.part[i] != 0 ? from.part[i] : to.part[i];
  }
}

/// f(orbit, step) for the points o + s · d.
template <class V, class F>
DURER_INLINE auto with_orbits(const JuliaSet& set, dvec3 o, dvec3 d, const JuliaOrbits::Lanes& at,
                              F f) {
  const auto s = Eight<V>::load(at);
  return with_orbit(set, s * d.x + o.x, s * d.y + o.y, s * d.z + o.z, f);
}

template <class V>
DURER_INLINE unsigned contains(const JuliaSet& set, dvec3 o, dvec3 d, const JuliaOrbits::Lanes& s) {
  using T = Eight<V>;
  return with_orbits<V>(set, o, d, s, [&](auto q, auto step) DURER_LAMBDA_INLINE {
    const T limit(set.escape2);
    Mask<V> inside = T(1) > T(0);
    for (std::uint32_t i = 0; i < set.iterations; ++i) {
      inside = without(inside, q.norm2() > limit);
      if (i % 8 == 7 && !inside.any()) break;
      step(q);
    }
    return inside.bits();
  });
}

/// Keeps those numbers of an orbit, or a product, that are in the lanes.
template <class V>
DURER_INLINE void keep(const Mask<V>& lanes, const Eight<V>& from, Eight<V> (&to)[4]) {
  assign(lanes, to[0], from);
}
template <class V>
DURER_INLINE void keep(const Mask<V>& lanes, const HypercomplexOrbit<Eight<V>>& from,
                       Eight<V> (&to)[4]) {
  assign(lanes, to[0], from.ax);
  assign(lanes, to[1], from.ay);
  assign(lanes, to[2], from.bx);
  assign(lanes, to[3], from.by);
}

template <class V>
DURER_INLINE void follow(const JuliaSet& set, dvec3 o, dvec3 d, const JuliaOrbits::Lanes& s,
                         JuliaOrbits& out) {
  using T = Eight<V>;
  with_orbits<V>(set, o, d, s, [&](auto q, auto step) DURER_LAMBDA_INLINE {
    constexpr bool plain = std::is_same_v<decltype(q), QuaternionOrbit<T>>;
    const T limit(set.escape2);
    Mask<V> inside = T(1) > T(0);
    auto product = q.first_product();
    T escape(-1);
    T product_there[4]{};
    T q_there[4]{};
    for (std::uint32_t i = 0; i < set.iterations && inside.any(); ++i) {
      const T n2 = q.norm2();
      const Mask<V> stays = without(inside, n2 > limit);
      const Mask<V> leaves = without(inside, stays);
      inside = stays;
      assign(leaves, escape, T(i));
      keep(leaves, product, product_there);
      if constexpr (plain) {
        keep(leaves, n2, q_there);
      } else {
        keep(leaves, q, q_there);
      }
      product = q.multiplied(product, n2, i);
      step(q);
    }
    escape.store(out.escape);
    for (std::size_t k = 0; k < (plain ? 1 : 4); ++k) {
      product_there[k].store(out.product[k]);
      q_there[k].store(out.q[k]);
    }
  });
}

using Double2 = double __attribute__((vector_size(16)));

// The same code for processors with 256-bit vectors and for all others; the results are equal.
#if defined(__x86_64__)
using Double4 = double __attribute__((vector_size(32)));
DURER_AVX2 unsigned contains_wide(const JuliaSet& set, dvec3 o, dvec3 d,
                                  const JuliaOrbits::Lanes& s) {
  return contains<Double4>(set, o, d, s);
}
DURER_AVX2 void follow_wide(const JuliaSet& set, dvec3 o, dvec3 d, const JuliaOrbits::Lanes& s,
                            JuliaOrbits& out) {
  follow<Double4>(set, o, d, s, out);
}
const bool has_wide = simd::has_avx2();
#endif

}  // namespace

unsigned julia_contains(const JuliaSet& set, dvec3 o, dvec3 d, const JuliaOrbits::Lanes& s) {
#if defined(__x86_64__)
  if (has_wide) return contains_wide(set, o, d, s);
#endif
  return contains<Double2>(set, o, d, s);
}

void julia_orbits(const JuliaSet& set, dvec3 o, dvec3 d, const JuliaOrbits::Lanes& s,
                  JuliaOrbits& out) {
#if defined(__x86_64__)
  if (has_wide) return follow_wide(set, o, d, s, out);
#endif
  follow<Double2>(set, o, d, s, out);
}

}  // namespace durer::tracer
