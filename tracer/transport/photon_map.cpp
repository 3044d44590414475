#include "tracer/transport/photon_map.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <numeric>

namespace durer::tracer {

PhotonMap::PhotonMap(std::vector<Photon> from) {
  std::vector<std::uint32_t> order(from.size());
  std::iota(order.begin(), order.end(), 0U);
  const std::size_t count = (from.size() + lanes - 1) / lanes;
  blocks_.resize(count);
  cuts_.resize(count);
  if (count > 0) build(order, from, 0);
  photons_.reserve(from.size());
  for (const std::uint32_t i : order) photons_.push_back(from[i]);
  constexpr float nowhere = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < count * lanes; ++i) {
    Block& block = blocks_[i / lanes];
    const vec3 p = i < photons_.size() ? photons_[i].p : vec3(nowhere);
    block.x[i % lanes] = p.x;
    block.y[i % lanes] = p.y;
    block.z[i % lanes] = p.z;
  }
}

// Cuts at the edge of a block, so that all but the last are full; across the longest side.
void PhotonMap::build(std::span<std::uint32_t> order, const std::vector<Photon>& from,
                      std::size_t first) {
  const std::size_t count = (order.size() + lanes - 1) / lanes;
  if (count < 2) return;
  vec3 lo(std::numeric_limits<float>::infinity());
  vec3 hi = -lo;
  for (const std::uint32_t i : order) {
    lo = glm::min(lo, from[i].p);
    hi = glm::max(hi, from[i].p);
  }
  const vec3 side = hi - lo;
  const int axis = side.x >= side.y ? (side.x >= side.z ? 0 : 2) : (side.y >= side.z ? 1 : 2);
  const std::size_t half = count / 2;
  const auto middle = order.begin() + static_cast<std::ptrdiff_t>(half * lanes);
  std::nth_element(order.begin(), middle, order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const float u = from[a].p[axis];
    const float v = from[b].p[axis];
    return u != v ? u < v : a < b;
  });
  cuts_[first + half] = {from[*middle].p[axis], static_cast<std::uint32_t>(axis)};
  build(order.first(half * lanes), from, first);
  build(order.subspan(half * lanes), from, first + half);
}

// One walk over the tree, nearer halves first. Whoever is found is kept until there are twice as
// many as wanted; then the farther half goes, and the search narrows.
class PhotonMap::Search {
 public:
  Search(const PhotonMap& map, const PhotonQuery& query, std::vector<NearPhoton>& found)
      : map_(map),
        found_(found),
        p_(query.p),
        n_(query.n),
        most_(query.most),
        bound_(static_cast<float>(query.radius * query.radius)) {}

  void run() {
    std::array<Branch, 64> stack;
    std::size_t depth = 0;
    stack[depth++] = {0, static_cast<std::uint32_t>(map_.blocks_.size()), 0, vec3(0.0F)};
    while (depth > 0) {
      Branch b = stack[--depth];
      if (!(b.distance2 < bound_)) continue;
      while (b.end - b.first > 1) {
        const std::uint32_t middle = b.first + (b.end - b.first) / 2;
        const Cut cut = map_.cuts_[middle];
        const auto axis = static_cast<int>(cut.axis);
        const float off = p_[axis] - cut.at;
        Branch far = b;
        (off < 0 ? far.first : far.end) = middle;
        (off < 0 ? b.end : b.first) = middle;
        far.distance2 += off * off - far.off[axis] * far.off[axis];
        far.off[axis] = off;
        if (far.distance2 < bound_) stack[depth++] = far;
      }
      look_into(b.first);
    }
  }

  /// True if there were more than wanted.
  bool settle() {
    if (found_.size() > most_) narrow();
    return narrowed_;
  }
  [[nodiscard]] float bound() const { return bound_; }

 private:
  struct Branch {
    std::uint32_t first;
    std::uint32_t end;
    float distance2;  // to the nearest place in it
    vec3 off;         // that, by axis
  };

  void look_into(std::uint32_t index) {
    // How much more a photon off the plane counts than one in it.
    constexpr float off_plane = 16;
    const Block& block = map_.blocks_[index];
    std::array<float, lanes> d2;
    for (std::size_t i = 0; i < lanes; ++i) {
      const float x = block.x[i] - p_.x;
      const float y = block.y[i] - p_.y;
      const float z = block.z[i] - p_.z;
      const float off = std::abs(n_.x * x + n_.y * y + n_.z * z);
      d2[i] = (x * x + y * y + z * z) * (1 + off_plane * off);
    }
    for (std::size_t i = 0; i < lanes; ++i) {
      if (d2[i] < bound_) {
        found_.emplace_back(d2[i], index * static_cast<std::uint32_t>(lanes) +
                                       static_cast<std::uint32_t>(i));
      }
    }
    if (found_.size() >= 2 * most_ + lanes) narrow();
  }

  // Keeps the nearest `most_`. Photons are spread evenly over areas, so the squares of their
  // distances are even, too: counting them in equal steps leaves only those of one step to compare.
  void narrow() {
    auto first = found_.begin();
    std::size_t wanted = most_;
    if (bound_ < std::numeric_limits<float>::max()) {
      constexpr int steps = 64;
      const float scale = steps / bound_;
      const auto step_of = [&](NearPhoton f) {
        return std::min(static_cast<int>(f.distance2() * scale), steps - 1);
      };
      std::array<std::uint32_t, steps> count{};
      for (const NearPhoton f : found_) ++count[static_cast<std::size_t>(step_of(f))];
      int last_step = 0;
      while (count[static_cast<std::size_t>(last_step)] < wanted) {
        wanted -= count[static_cast<std::size_t>(last_step++)];
      }
      auto end = first;
      for (const NearPhoton f : found_) {
        *end = f;
        end += step_of(f) <= last_step ? 1 : 0;
      }
      found_.erase(end, found_.end());
      first = std::partition(first, found_.end(),
                             [&](NearPhoton f) { return step_of(f) < last_step; });
    }
    const auto last = first + static_cast<std::ptrdiff_t>(wanted) - 1;
    std::nth_element(first, last, found_.end());
    bound_ = last->distance2();
    found_.resize(most_);
    narrowed_ = true;
  }

  const PhotonMap& map_;
  std::vector<NearPhoton>& found_;
  const vec3 p_;
  const vec3 n_;
  const std::size_t most_;
  float bound_;
  bool narrowed_ = false;
};

double PhotonMap::nearest(const PhotonQuery& query, std::vector<NearPhoton>& found) const {
  found.clear();
  if (empty() || query.most == 0) return query.radius;
  Search search(*this, query, found);
  search.run();
  return search.settle() ? std::sqrt(search.bound()) : query.radius;
}

}  // namespace durer::tracer
