// Eight numbers evaluated side by side: loops over lanes that the compiler turns into vector code.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace durer::functions {

/// Eight lanes of a batch. Every operation gives in each lane the bits that `double` would give.
struct Pack {
  static constexpr int lanes = 8;
  alignas(64) std::array<double, lanes> v;

  Pack() = default;
  Pack(double all) { v.fill(all); }  // NOLINT: a number is the same in every lane
};

/// Outcome of a comparison per lane: all bits set or none.
struct PackMask {
  alignas(64) std::array<std::int64_t, Pack::lanes> m;
};

namespace pack_detail {
template <class F>
[[nodiscard]] inline Pack map(const Pack& a, F f) {
  Pack r;
  for (int i = 0; i < Pack::lanes; ++i) r.v[i] = f(a.v[i]);
  return r;
}
template <class F>
[[nodiscard]] inline Pack map(const Pack& a, const Pack& b, F f) {
  Pack r;
  for (int i = 0; i < Pack::lanes; ++i) r.v[i] = f(a.v[i], b.v[i]);
  return r;
}
template <class F>
[[nodiscard]] inline PackMask compare(const Pack& a, const Pack& b, F f) {
  PackMask r;
  for (int i = 0; i < Pack::lanes; ++i) r.m[i] = f(a.v[i], b.v[i]) ? -1 : 0;
  return r;
}
}  // namespace pack_detail

// clang-format off
[[nodiscard]] inline Pack operator-(const Pack& a) { return pack_detail::map(a, [](double x) { return -x; }); }
[[nodiscard]] inline Pack operator+(const Pack& a, const Pack& b) { return pack_detail::map(a, b, [](double x, double y) { return x + y; }); }
[[nodiscard]] inline Pack operator-(const Pack& a, const Pack& b) { return pack_detail::map(a, b, [](double x, double y) { return x - y; }); }
[[nodiscard]] inline Pack operator*(const Pack& a, const Pack& b) { return pack_detail::map(a, b, [](double x, double y) { return x * y; }); }
[[nodiscard]] inline Pack operator/(const Pack& a, const Pack& b) { return pack_detail::map(a, b, [](double x, double y) { return x / y; }); }
inline Pack& operator+=(Pack& a, const Pack& b) { return a = a + b; }
inline Pack& operator-=(Pack& a, const Pack& b) { return a = a - b; }
inline Pack& operator*=(Pack& a, const Pack& b) { return a = a * b; }

[[nodiscard]] inline Pack sqr(const Pack& a) { return a * a; }
[[nodiscard]] inline Pack abs(const Pack& a) { return pack_detail::map(a, [](double x) { return std::abs(x); }); }
[[nodiscard]] inline Pack min(const Pack& a, const Pack& b) { return pack_detail::map(a, b, [](double x, double y) { return x <= y ? x : y; }); }
[[nodiscard]] inline Pack max(const Pack& a, const Pack& b) { return pack_detail::map(a, b, [](double x, double y) { return x < y ? y : x; }); }

#define DURER_PACK_LIBRARY(name) \
  [[nodiscard]] inline Pack name(const Pack& a) { return pack_detail::map(a, [](double x) { return std::name(x); }); }
DURER_PACK_LIBRARY(sqrt)  DURER_PACK_LIBRARY(exp)   DURER_PACK_LIBRARY(log)   DURER_PACK_LIBRARY(log10)
DURER_PACK_LIBRARY(sin)   DURER_PACK_LIBRARY(cos)   DURER_PACK_LIBRARY(tan)
DURER_PACK_LIBRARY(asin)  DURER_PACK_LIBRARY(acos)  DURER_PACK_LIBRARY(atan)
DURER_PACK_LIBRARY(sinh)  DURER_PACK_LIBRARY(cosh)  DURER_PACK_LIBRARY(tanh)
DURER_PACK_LIBRARY(asinh) DURER_PACK_LIBRARY(acosh) DURER_PACK_LIBRARY(atanh)
DURER_PACK_LIBRARY(floor) DURER_PACK_LIBRARY(ceil)  DURER_PACK_LIBRARY(trunc)
#undef DURER_PACK_LIBRARY
[[nodiscard]] inline Pack atan2(const Pack& a, const Pack& b) { return pack_detail::map(a, b, [](double x, double y) { return std::atan2(x, y); }); }
[[nodiscard]] inline Pack fmod(const Pack& a, const Pack& b) { return pack_detail::map(a, b, [](double x, double y) { return std::fmod(x, y); }); }
[[nodiscard]] inline Pack pow(const Pack& a, const Pack& b) { return pack_detail::map(a, b, [](double x, double y) { return std::pow(x, y); }); }

[[nodiscard]] inline PackMask lt(const Pack& a, const Pack& b) { return pack_detail::compare(a, b, [](double x, double y) { return x < y; }); }
[[nodiscard]] inline PackMask le(const Pack& a, const Pack& b) { return pack_detail::compare(a, b, [](double x, double y) { return x <= y; }); }
[[nodiscard]] inline PackMask eq(const Pack& a, const Pack& b) { return pack_detail::compare(a, b, [](double x, double y) { return x == y; }); }
// clang-format on

[[nodiscard]] inline PackMask operator!(const PackMask& a) {
  PackMask r;
  for (int i = 0; i < Pack::lanes; ++i) r.m[i] = ~a.m[i];
  return r;
}
[[nodiscard]] inline PackMask operator&(const PackMask& a, const PackMask& b) {
  PackMask r;
  for (int i = 0; i < Pack::lanes; ++i) r.m[i] = a.m[i] & b.m[i];
  return r;
}
[[nodiscard]] inline PackMask operator|(const PackMask& a, const PackMask& b) {
  PackMask r;
  for (int i = 0; i < Pack::lanes; ++i) r.m[i] = a.m[i] | b.m[i];
  return r;
}
[[nodiscard]] inline Pack where(const PackMask& m, const Pack& a, const Pack& b) {
  Pack r;
  for (int i = 0; i < Pack::lanes; ++i) r.v[i] = m.m[i] != 0 ? a.v[i] : b.v[i];
  return r;
}
[[nodiscard]] inline bool all(const PackMask& m) {
  std::int64_t bits = -1;
  for (const std::int64_t b : m.m) bits &= b;
  return bits != 0;
}
[[nodiscard]] inline bool none(const PackMask& m) {
  std::int64_t bits = 0;
  for (const std::int64_t b : m.m) bits |= b;
  return bits == 0;
}

}  // namespace durer::functions
