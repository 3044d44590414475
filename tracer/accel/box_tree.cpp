#include "tracer/accel/box_tree.h"

#include <algorithm>
#include <cmath>

namespace durer::tracer {

Bounds3 BoxTree::grown(Bounds3 b) {
  // What has no end on one side has one on the other, and that is to stay.
  const auto size = [](double v) { return std::abs(v) < unbounded ? std::abs(v) : 0.0; };
  for (int i = 0; i < 3; ++i) {
    const double pad = 1e-9 * std::max({1e-3, size(b.lo[i]), size(b.hi[i])});
    b.lo[i] -= pad;
    b.hi[i] += pad;
  }
  return b;
}

BoxTree::BoxTree(std::span<const Bounds3> boxes) {
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    if (!boxes[i].empty()) order_.push_back({grown(boxes[i]), i});
  }
  if (order_.empty()) return;
  nodes_.reserve(order_.size());
  nodes_.emplace_back();
  split(0, 0, static_cast<std::uint32_t>(order_.size()));
}

// Halves at the median of the centres along their widest axis: always balanced, good enough for
// the even distributions found inside solids.
void BoxTree::split(std::uint32_t node, std::uint32_t begin, std::uint32_t end) {
  constexpr std::uint32_t leaf_size = 2;
  Bounds3 box;
  Bounds3 centres;
  for (std::uint32_t i = begin; i < end; ++i) {
    box.add(order_[i].box);
    centres.add(order_[i].box.lo + order_[i].box.hi);
  }
  nodes_[node].box = box;
  if (end - begin <= leaf_size) {
    nodes_[node].first = begin;
    nodes_[node].count = end - begin;
    return;
  }
  const dvec3 extent = centres.hi - centres.lo;
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [axis](const Entry& a, const Entry& b) {
                     return a.box.lo[axis] + a.box.hi[axis] < b.box.lo[axis] + b.box.hi[axis];
                   });
  const auto left = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node].first = left;
  nodes_.resize(nodes_.size() + 2);
  split(left, begin, middle);
  split(left + 1, middle, end);
}

}  // namespace durer::tracer
