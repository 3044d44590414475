#include "tracer/transport/photon_map.h"

#include <algorithm>
#include <glm/common.hpp>
#include <limits>
#include <numeric>
#include <utility>

namespace durer::tracer {
namespace {

constexpr float nowhere = std::numeric_limits<float>::infinity();

// A part of the blocks.
struct Range {
  std::size_t first;
  std::size_t count;
};

// Cuts `all` where the tree was cut, until no piece has more than `most` blocks.
void cut_up(Range all, std::size_t most, std::vector<Range>& pieces) {
  if (all.count <= most) {
    pieces.push_back(all);
    return;
  }
  const std::size_t half = all.count / 2;
  cut_up({all.first, half}, most, pieces);
  cut_up({all.first + half, all.count - half}, most, pieces);
}

struct Box {
  vec3 lo{nowhere};
  vec3 hi{-nowhere};

  void add(vec3 p) {
    lo = glm::min(lo, p);
    hi = glm::max(hi, p);
  }
};

}  // namespace

PhotonMap::PhotonMap(std::vector<Photon> from) {
  if (from.empty()) return;
  std::vector<std::uint32_t> order(from.size());
  std::iota(order.begin(), order.end(), 0U);
  order_blocks(order, from);
  photons_.reserve(from.size());
  for (const std::uint32_t i : order) photons_.push_back(from[i]);
  const std::size_t count = (from.size() + lanes - 1) / lanes;
  blocks_.resize(count);
  for (std::size_t i = 0; i < count * lanes; ++i) {
    Block& block = blocks_[i / lanes];
    const vec3 p = i < photons_.size() ? photons_[i].p : vec3(nowhere);
    block.x[i % lanes] = p.x;
    block.y[i % lanes] = p.y;
    block.z[i % lanes] = p.z;
  }
  add_nodes();
}

// Cuts at the edge of a block, so that all but the last are full; across the longest side.
void PhotonMap::order_blocks(std::span<std::uint32_t> order, const std::vector<Photon>& from) {
  const std::size_t count = (order.size() + lanes - 1) / lanes;
  if (count < 2) return;
  Box box;
  for (const std::uint32_t i : order) box.add(from[i].p);
  const vec3 side = box.hi - box.lo;
  const int axis = side.x >= side.y ? (side.x >= side.z ? 0 : 2) : (side.y >= side.z ? 1 : 2);
  const std::size_t half = count / 2 * lanes;
  const auto middle = order.begin() + static_cast<std::ptrdiff_t>(half);
  std::nth_element(order.begin(), middle, order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const float u = from[a].p[axis];
    const float v = from[b].p[axis];
    return u != v ? u < v : a < b;
  });
  order_blocks(order.first(half), from);
  order_blocks(order.subspan(half), from);
}

// From the one node of all blocks down, a level at a time, to know where children begin; then up
// again for the boxes. All blocks are equally deep.
void PhotonMap::add_nodes() {
  std::size_t share = 1;  // most blocks of a child
  std::size_t height = 1;
  for (; share * lanes < blocks_.size(); share *= lanes) ++height;
  levels_.resize(height);
  std::vector<Range> ranges{{0, blocks_.size()}};
  std::vector<std::vector<std::size_t>> children(height);  // how many every node has
  for (std::size_t level = height; level-- > 0; share /= lanes) {
    std::vector<Range> below;
    for (const Range& range : ranges) {
      const std::size_t first = below.size();
      cut_up(range, share, below);
      levels_[level].push_back({{}, {}, static_cast<std::uint32_t>(first)});
      children[level].push_back(below.size() - first);
    }
    ranges = std::move(below);
  }
  for (std::size_t level = 0; level < height; ++level) {
    for (std::size_t i = 0; i < levels_[level].size(); ++i) {
      set_boxes(level, levels_[level][i], children[level][i]);
    }
  }
}

void PhotonMap::set_boxes(std::size_t level, Node& node, std::size_t children) const {
  const auto corner = [&](const auto& planes, std::size_t lane) {
    return vec3(planes[0][lane], planes[1][lane], planes[2][lane]);
  };
  for (std::size_t i = 0; i < lanes; ++i) {
    Box box;
    const std::size_t child = node.first + i;
    for (std::size_t k = 0; i < children && k < lanes; ++k) {
      if (level > 0) {
        const Node& below = levels_[level - 1][child];
        if (below.lo[0][k] == nowhere) break;
        box.add(corner(below.lo, k));
        box.add(corner(below.hi, k));
      } else if (child * lanes + k < photons_.size()) {
        box.add(photons_[child * lanes + k].p);
      }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      node.lo[axis][i] = box.lo[static_cast<int>(axis)];
      node.hi[axis][i] = box.hi[static_cast<int>(axis)];
    }
  }
}

}  // namespace durer::tracer
