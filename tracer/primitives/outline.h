// Closed curves in a plane, made of straight and Bézier arcs: what prisms and glyphs are swept
// from. Arcs that follow each other share an end point to the last bit, so that the number of times
// a line crosses a closed curve is even, whatever rounding does.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>

#include "base/roots/bernstein.h"
#include "base/vec.h"

namespace durer::tracer {

/// A Bézier curve of degree 1, 2 or 3, w from 0 to 1.
struct Arc {
  std::array<dvec2, 4> c;  // the first degree + 1 count
  int degree = 1;
  std::uint32_t number = 0;  // its place in the list it comes from; outlines change the order

  [[nodiscard]] dvec2 begin() const { return c[0]; }
  [[nodiscard]] dvec2 end() const { return c[static_cast<std::size_t>(degree)]; }
  [[nodiscard]] dvec2 at(double w) const;
  /// d/dw.
  [[nodiscard]] dvec2 slope(double w) const;
  /// The w in [0, 1] whose point is nearest to `p`.
  [[nodiscard]] double nearest_to(dvec2 p) const;
  /// d/dw there.
  [[nodiscard]] dvec2 slope_near(dvec2 p) const;

  /// Calls f(w) wherever the sign of `value(control point)`, a linear function, changes.
  template <typename Value, typename F>
  void each_sign_change(Value&& value, F&& f) const {
    switch (degree) {
      case 1: roots<1>(value, f); break;
      case 2: roots<2>(value, f); break;
      default: roots<3>(value, f); break;
    }
  }

 private:
  template <std::size_t N, typename Value, typename F>
  void roots(Value& value, F& f) const {
    Bernstein<N> b{};
    for (std::size_t i = 0; i <= N; ++i) b[i] = value(c[i]);
    for (const double w : sign_changes<N>(b)) f(w);
  }
};

/// Through the inner points of a quadratic or cubic spline of the language, from `q` to `s`: only
/// the slopes depend on the neighbours (objects §10.7).
[[nodiscard]] Arc straight_arc(dvec2 from, dvec2 to);
[[nodiscard]] Arc quadratic_spline_arc(dvec2 before, dvec2 from, dvec2 to);
[[nodiscard]] Arc cubic_spline_arc(dvec2 before, dvec2 from, dvec2 to, dvec2 after);

/// Arcs, and whatever lies inside of them by the even-odd rule.
class Outline {
 public:
  Outline() = default;
  explicit Outline(std::vector<Arc> arcs);

  [[nodiscard]] bool empty() const { return arcs_.empty(); }
  [[nodiscard]] const Arc& arc(std::size_t i) const { return arcs_[i]; }
  [[nodiscard]] dvec2 lo() const { return lo_; }
  [[nodiscard]] dvec2 hi() const { return hi_; }
  /// By the crossings of the ray from `p` towards +x.
  [[nodiscard]] bool contains(dvec2 p) const;

  /// Around the control points of some arcs.
  struct Box {
    dvec2 middle{0.0};
    dvec2 half{0.0};
  };
  /// Calls f(arc index) for every arc near whose box test(box) holds, as for those around it.
  template <typename Test, typename F>
  void each_near(Test&& test, F&& f) const {
    for (std::uint32_t at = 0; at < nodes_.size();) {
      const Node& node = nodes_[at];
      if (!test(node.box)) {
        at = node.skip;
        continue;
      }
      for (std::uint32_t i = 0; i < node.count; ++i) f(node.first + i);
      ++at;
    }
  }

  /// Calls f(arc index, w) for every crossing of the line where line.x · x + line.y · y + line.z
  /// is zero, in no order.
  template <typename F>
  void each_crossing(dvec3 line, F&& f) const {
    const auto value = [&](dvec2 p) { return line.x * p.x + line.y * p.y + line.z; };
    each_near(
        [&](const Box& b) {
          // By how much the value can differ from that in the middle of the box.
          const double reach = std::abs(line.x) * b.half.x + std::abs(line.y) * b.half.y;
          return std::abs(value(b.middle)) <= reach * (1 + 1e-9) + 1e-14 * std::abs(line.z);
        },
        [&](std::uint32_t i) { arcs_[i].each_sign_change(value, [&](double w) { f(i, w); }); });
  }

  /// Calls f(arc index, t) where the line o + t·d crosses an arc, in no order: for the crossings
  /// with t_from <= t <= t_to and a few others. Returns whether the number of those before all of
  /// these is odd. No root is sought for them: signs tell.
  template <typename F>
  bool each_crossing_within(dvec2 o, dvec2 d, double t_from, double t_to, F&& f) const {
    const double unit = 1 / glm::dot(d, d);
    const double slack = 1e-14 * (std::abs(o.x * d.y) + std::abs(o.y * d.x));
    const auto beside = [&](dvec2 p) { return (p.x - o.x) * d.y - (p.y - o.y) * d.x; };
    const auto place = [&](dvec2 p) { return ((p.x - o.x) * d.x + (p.y - o.y) * d.y) * unit; };
    bool odd = false;
    each_near(
        [&](const Box& b) {
          // By how much the values can differ from those in the middle of the box.
          const double reach = std::abs(d.y) * b.half.x + std::abs(d.x) * b.half.y;
          const double long_reach = (std::abs(d.x) * b.half.x + std::abs(d.y) * b.half.y) * unit;
          return std::abs(beside(b.middle)) <= reach * (1 + 1e-9) + slack &&
                 place(b.middle) - long_reach * (1 + 1e-9) <= t_to;
        },
        [&](std::uint32_t i) {
          const Arc& arc = arcs_[i];
          const bool ends_differ = (beside(arc.begin()) < 0) != (beside(arc.end()) < 0);
          if (arc.degree == 1 && !ends_differ) return;
          double last = place(arc.c[0]);
          for (std::size_t k = 1; k <= static_cast<std::size_t>(arc.degree); ++k) {
            last = std::max(last, place(arc.c[k]));
          }
          if (last < t_from) {
            odd ^= ends_differ;
            return;
          }
          arc.each_sign_change(beside, [&](double w) { f(i, place(arc.at(w))); });
        });
    return odd;
  }

 private:
  /// In preorder; who is not interested in a node goes on at `skip`.
  struct Node {
    Box box;
    std::uint32_t skip = 0;
    std::uint32_t first = 0;
    std::uint32_t count = 0;  // 0: inner
  };

  void split(std::uint32_t begin, std::uint32_t end);
  [[nodiscard]] Box box_of(std::uint32_t begin, std::uint32_t end) const;

  std::vector<Arc> arcs_;
  std::vector<Node> nodes_;
  dvec2 lo_{0.0};
  dvec2 hi_{0.0};
};

}  // namespace durer::tracer
