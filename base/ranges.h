// Four ranges side by side, for formulas that treat them alike.
#pragma once

#include <cstddef>
#include <limits>

#include "base/interval.h"

namespace durer {

/// Two doubles that one instruction treats alike.
using DoublePair = double __attribute__((vector_size(16)));

/// Ends of four ranges. What operations give is what those of Interval give, bit for bit, as long
/// as all ends are finite.
struct Ranges {
  DoublePair lo[2]{};
  DoublePair hi[2]{};

  [[nodiscard]] Interval at(std::size_t i) const { return {lo[i / 2][i % 2], hi[i / 2][i % 2]}; }
  /// The first range replaced. In registers: what is stored in halves is slow to load as a whole.
  [[nodiscard]] Ranges with_first(const Interval& r) const {
    return {{DoublePair{r.lo, lo[0][1]}, lo[1]}, {DoublePair{r.hi, hi[0][1]}, hi[1]}};
  }
  [[nodiscard]] bool is_bounded() const {
    constexpr double inf = std::numeric_limits<double>::infinity();
    const auto narrow = (hi[0] - lo[0] < inf) & (hi[1] - lo[1] < inf);
    return (narrow[0] & narrow[1]) != 0;
  }
};

namespace ranges_detail {
[[nodiscard]] inline DoublePair least(DoublePair a, DoublePair b) { return a < b ? a : b; }
[[nodiscard]] inline DoublePair greatest(DoublePair a, DoublePair b) { return a > b ? a : b; }
}  // namespace ranges_detail

[[nodiscard]] inline Ranges operator+(const Ranges& a, const Ranges& b) {
  return {{a.lo[0] + b.lo[0], a.lo[1] + b.lo[1]}, {a.hi[0] + b.hi[0], a.hi[1] + b.hi[1]}};
}
[[nodiscard]] inline Ranges operator-(const Ranges& a, const Ranges& b) {
  return {{a.lo[0] - b.hi[0], a.lo[1] - b.hi[1]}, {a.hi[0] - b.lo[0], a.hi[1] - b.lo[1]}};
}
[[nodiscard]] inline Ranges operator-(const Ranges& a) {
  return {{-a.hi[0], -a.hi[1]}, {-a.lo[0], -a.lo[1]}};
}
/// Each times the same range.
[[nodiscard]] inline Ranges operator*(const Ranges& a, const Interval& s) {
  using namespace ranges_detail;
  const DoublePair from{s.lo, s.lo};
  const DoublePair to{s.hi, s.hi};
  Ranges r;
  for (int i = 0; i < 2; ++i) {
    const DoublePair p = a.lo[i] * from;
    const DoublePair q = a.lo[i] * to;
    const DoublePair u = a.hi[i] * from;
    const DoublePair v = a.hi[i] * to;
    r.lo[i] = least(least(p, q), least(u, v));
    r.hi[i] = greatest(greatest(p, q), greatest(u, v));
  }
  return r;
}
/// Each times the same number.
[[nodiscard]] inline Ranges operator*(const Ranges& a, double s) {
  using namespace ranges_detail;
  const DoublePair by{s, s};
  Ranges r;
  for (int i = 0; i < 2; ++i) {
    const DoublePair p = a.lo[i] * by;
    const DoublePair q = a.hi[i] * by;
    r.lo[i] = least(p, q);
    r.hi[i] = greatest(p, q);
  }
  return r;
}
[[nodiscard]] inline Ranges hull(const Ranges& a, const Ranges& b) {
  using namespace ranges_detail;
  return {{least(a.lo[0], b.lo[0]), least(a.lo[1], b.lo[1])},
          {greatest(a.hi[0], b.hi[0]), greatest(a.hi[1], b.hi[1])}};
}

}  // namespace durer
