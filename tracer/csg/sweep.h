// One walk along a line through a solid: all crossings of its leaves in order, one bit per leaf,
// and a surface shows where the rest of the program lets it
// [Roth, "Ray Casting for Modeling Solids", 1982].
#pragma once

#include <algorithm>
#include <cmath>

#include "tracer/csg/solid.h"

namespace durer::tracer {

/// True if the solid holds the point.
[[nodiscard]] bool solid_contains(const Solid& solid, dvec3 p, SweepState& state);

/// The working parts of sweep(), which is a template only over its last step.
class Sweep {
 public:
  Sweep(const Solid& solid, SweepState& state, SweepBuffers& buffers)
      : solid_(solid),
        counts_(state.counts.data() + solid.first_node),
        inside_(state.inside.data() + solid.first_leaf),
        b_(buffers) {}
  ~Sweep() {  // back to the resting state
    for (auto leaf = b_.flipped.rbegin(); leaf != b_.flipped.rend(); ++leaf) flip(*leaf);
    b_.flipped.clear();
  }
  Sweep(const Sweep&) = delete;
  Sweep& operator=(const Sweep&) = delete;

  /// Collects and sorts the crossings that matter in t_from…t_to to rays of this Visibility; 0: to
  /// all. Leaves whose boxes the line does not meet there cannot change in between. False if nothing
  /// can be seen there.
  bool begin(const Ray& ray, double t_from, double t_to, std::uint8_t who);

  /// Sets the bits of leaves that hold `p`, one by one.
  void place(dvec3 p);
  [[nodiscard]] bool root() const { return solid_.nodes[0].value(counts_[0]); }

  /// Calls emit(leaf, crossing) for every visible surface in t_from <= t < t_to, in order, until it
  /// returns true; then the result is true.
  template <typename Emit>
  bool walk(double t_from, double t_to, Emit&& emit) {
    const Crossings& all = b_.crossings;
    for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
      if (all[begin].t >= t_to) return false;
      end = group_end(begin);
      if (all[end - 1].t < t_from) {
        for (std::size_t i = begin; i < end; ++i) cross(all[i]);
        continue;
      }
      judge(begin, end);
      for (std::size_t i = begin; i < end; ++i) {
        const Crossing& c = all[i];
        if (b_.shown[i - begin] == 0 || c.t < t_from || c.t >= t_to) continue;
        if (emit(solid_.leaves[c.leaf], c)) return true;
      }
    }
    return false;
  }

 private:
  void ask(std::uint32_t leaf, std::uint8_t who) {
    const SolidLeaf& l = solid_.leaves[leaf];
    if ((l.absent_for & who) != 0) return;
    b_.asked[l.slot].push_back({leaf, l.shape});
  }
  [[nodiscard]] bool leaf_value(std::uint32_t leaf) const {
    return (inside_[leaf] != 0) != solid_.leaves[leaf].inverted;
  }
  void flip(std::uint32_t leaf);
  void cross(const Crossing& c) {
    if (c.side == Side::sheet) return;
    flip(c.leaf);
    b_.flipped.push_back(c.leaf);
  }
  /// Crossings this close are one event: coincident faces leave no slivers.
  [[nodiscard]] std::size_t group_end(std::size_t i) const {
    const Crossings& all = b_.crossings;
    const double limit = all[i].t + 1e-11 * std::max(1.0, std::abs(all[i].t));
    std::size_t end = i + 1;
    while (end < all.size() && all[end].t <= limit) ++end;
    return end;
  }
  /// Decides which of the crossings begin…end are seen (`shown`), and crosses them.
  void judge(std::size_t begin, std::size_t end);
  void judge_one(const Crossing& c);
  void judge_group(std::size_t begin, std::size_t end);
  template <typename F>
  bool climb(std::uint32_t leaf, F&& f) const;

  const Solid& solid_;
  std::uint32_t* counts_;
  std::uint8_t* inside_;
  SweepBuffers& b_;
};

}  // namespace durer::tracer
