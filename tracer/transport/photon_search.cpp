// The photons around a point. What an answer is does not depend on how it was found: photons are
// met in the order of the map, and those that are kept stay in it.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "tracer/accel/lanes.h"
#include "tracer/transport/photon_map.h"

namespace durer::tracer {
namespace {

using wide::Float8;
using wide::Int8;
using wide::load8;

// Deeper trees would hold more photons than an index can tell apart.
constexpr std::size_t most_levels = 12;

// Both look at whole groups of eight numbers: what follows the last must be infinite.
DURER_INLINE std::size_t count_up_to(float limit, const float* numbers, std::size_t count) {
  Int8 sum{};  // a lane that is set is -1
  for (std::size_t i = 0; i < count; i += 8) sum += load8(numbers + i) <= limit;
  int all = 0;
  for (int lane = 0; lane < 8; ++lane) all -= sum[lane];
  return static_cast<std::size_t>(all);
}
DURER_INLINE float greatest_up_to(float limit, const float* numbers, std::size_t count) {
  Float8 greatest{};
  for (std::size_t i = 0; i < count; i += 8) {
    const Float8 eight = load8(numbers + i);
    greatest = wide::greater_of(greatest, eight <= limit ? eight : Float8{});
  }
  float all = 0;
  for (int lane = 0; lane < 8; ++lane) all = std::max(all, greatest[lane]);
  return all;
}

// Some numbers are not greater than a limit.
struct Split {
  float limit;
  std::size_t count;
};

// Splits off the `wanted` smallest of `count` numbers; more, if others are equal to the last of them.
// None is negative, and all are up to `most`.
//
// Photons are spread evenly over areas, so the squares of their distances are even, too: guessing
// between two that are known comes close at once. Numbers that are not negative are ordered as
// their bits are; halving these comes to an end whatever the numbers are.
DURER_INLINE Split split_off(std::size_t wanted, const float* numbers, std::size_t count,
                             float most) {
  constexpr int guesses = 12;
  struct Known {
    std::int32_t bits;
    float number;
    std::size_t count;  // up to the number
  };
  Known low{-1, 0, 0};
  Known high{std::bit_cast<std::int32_t>(most), most, count};
  for (int i = 0; high.count != wanted && high.bits - low.bits > 1; ++i) {
    std::int32_t middle = low.bits + (high.bits - low.bits) / 2;
    if (i < guesses) {
      const float part = (static_cast<float>(wanted - low.count) + 0.5F) /
                         static_cast<float>(high.count - low.count);
      const float guess = low.number + (high.number - low.number) * part;
      middle = std::clamp(std::bit_cast<std::int32_t>(guess), low.bits + 1, high.bits - 1);
    }
    const float number = std::bit_cast<float>(middle);
    const Known known{middle, number, count_up_to(number, numbers, count)};
    (known.count < wanted ? low : high) = known;
  }
  return {high.number, high.count};
}

}  // namespace

// One walk over the tree. When four times as many as wanted are found, those that are too far away
// go, and the search narrows.
class PhotonMap::Search {
 public:
  Search(const PhotonMap& map, const PhotonQuery& query, FoundPhotons& found)
      : map_(map),
        distances2_(found.distances2.data()),
        indices_(found.indices.data()),
        p_(query.p),
        n_(query.n),
        most_(std::min(query.most, map.size())) {}

  /// Enough for `most`.
  static std::size_t room(std::size_t most) { return 4 * most + 2 * lanes; }

  /// Looks within the square of a distance; within that of a longer one as long as there are not
  /// more than wanted, up to that of `limit2`.
  DURER_INLINE void look(float first2, float limit2) {
    float bound2 = std::min(std::max(first2, std::numeric_limits<float>::min()), limit2);
    run(bound2);
    while (count_ <= most_ && !narrowed_ && bound2 < limit2) {
      const float lacking = static_cast<float>(most_) / static_cast<float>(count_);
      bound2 = std::min(bound2 * std::clamp(1.3F * lacking, 1.3F, 4.0F), limit2);
      run(bound2);
    }
    if (count_ > most_) narrow();
  }
#if DURER_HAS_WIDE
  DURER_WIDE void look_wide(float first2, float limit2) { look(first2, limit2); }
#endif
  void look_plain(float first2, float limit2) { look(first2, limit2); }

  /// There were more than wanted, the farther of which are left out.
  [[nodiscard]] bool narrowed() const { return narrowed_; }
  /// Square of the distance of the farthest one that was kept.
  [[nodiscard]] float farthest2() const { return bound_; }
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  DURER_INLINE void run(float bound2) {
    bound_ = bound2;
    count_ = 0;
    narrowed_ = false;
    struct Step {
      unsigned children;  // bits of those that are left
      std::uint32_t first;
    };
    std::array<Step, most_levels> steps;
    std::size_t level = map_.levels_.size() - 1;
    const auto enter = [&](std::uint32_t node) DURER_LAMBDA_INLINE {
      const Node& n = map_.levels_[level][node];
      steps[level] = {near_children(n), n.first};
    };
    enter(0);
    while (true) {
      Step& step = steps[level];
      if (level == 0) {
        wide::each_bit(step.children, [&](std::size_t i) DURER_LAMBDA_INLINE {
          look_into(step.first + static_cast<std::uint32_t>(i));
        });
        step.children = 0;
      }
      if (step.children != 0) {
        const auto i = static_cast<std::uint32_t>(std::countr_zero(step.children));
        step.children &= step.children - 1;
        --level;
        enter(step.first + i);
      } else if (++level == map_.levels_.size()) {
        break;
      }
    }
  }

  DURER_INLINE unsigned near_children(const Node& node) const {
    Float8 d2{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float p = p_[static_cast<int>(axis)];
      const Float8 off = wide::greater_of(wide::greater_of(load8(node.lo[axis].data()) - p,
                                                           p - load8(node.hi[axis].data())),
                                          Float8{});
      d2 += off * off;
    }
    return wide::bits_of_8(d2 < bound_);
  }

  DURER_INLINE void look_into(std::uint32_t index) {
    // How much more a photon off the plane counts than one in it.
    constexpr float off_plane = 16;
    const Block& block = map_.blocks_[index];
    const Float8 x = load8(block.x.data()) - p_.x;
    const Float8 y = load8(block.y.data()) - p_.y;
    const Float8 z = load8(block.z.data()) - p_.z;
    const Float8 height = n_.x * x + n_.y * y + n_.z * z;
    const Float8 off = wide::greater_of(height, -height);
    const Float8 d2 = (x * x + y * y + z * z) * (1 + off_plane * off);
    const unsigned near = wide::bits_of_8(d2 < bound_);
    if (near == 0) return;
    std::array<float, lanes> numbers;
    std::memcpy(numbers.data(), &d2, sizeof d2);
    std::size_t at = count_;
    for (std::size_t i = 0; i < lanes; ++i) {
      distances2_[at] = numbers[i];
      indices_[at] = index * static_cast<std::uint32_t>(lanes) + static_cast<std::uint32_t>(i);
      at += near >> i & 1U;
    }
    count_ = at;
    if (count_ >= 4 * most_) narrow();
  }

  // Keeps the nearest `most_`; of those that are as far away as the last one, the first.
  DURER_INLINE void narrow() {
    std::fill_n(distances2_ + count_, lanes, std::numeric_limits<float>::infinity());
    const float finite = std::min(bound_, std::numeric_limits<float>::max());
    const Split nearer = split_off(most_, distances2_, count_, finite);
    bound_ = greatest_up_to(nearer.limit, distances2_, count_);
    if (nearer.count > most_) leave_out(nearer.count - most_);
    std::size_t to = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const float d2 = distances2_[i];
      distances2_[to] = d2;
      indices_[to] = indices_[i];
      to += d2 <= nearer.limit ? 1 : 0;
    }
    count_ = most_;
    narrowed_ = true;
  }

  // Forgets the last of those that are exactly at the bound.
  void leave_out(std::size_t count) {
    for (std::size_t i = count_; count > 0;) {
      if (distances2_[--i] != bound_) continue;
      distances2_[i] = std::numeric_limits<float>::infinity();
      --count;
    }
  }

  const PhotonMap& map_;
  float* const distances2_;
  std::uint32_t* const indices_;
  const vec3 p_;
  const vec3 n_;
  const std::size_t most_;
  std::size_t count_ = 0;
  float bound_ = 0;
  bool narrowed_ = false;
};

namespace {

// What is known of the place; as a start, what was found elsewhere.
FoundPhotons::Hint& hint_at(const PhotonQuery& query, FoundPhotons& found) {
  const double scale = 4 / query.radius;
  std::uint32_t cell = 0;
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<float>(std::floor(query.p[i] * scale));
    cell = (cell ^ std::bit_cast<std::uint32_t>(at)) * 0x9E3779B1U;
    cell ^= cell >> 15;
  }
  FoundPhotons::Hint& hint = found.hints[cell % found.hints.size()];
  // Too small is better than too large: looking in vain costs less than finding too many.
  constexpr float elsewhere = 0.7F;
  if (hint.cell != cell) hint = {cell, elsewhere * found.last_radius};
  return hint;
}

// The radius that would hold as many as are wanted, going by those that were found.
float radius_of(const FoundPhotons& found, std::size_t most) {
  const auto radius = static_cast<float>(found.radius);
  const auto count = static_cast<float>(std::max<std::size_t>(found.count, 4));
  const float share = static_cast<float>(most) / count;
  return share > 1 ? radius * std::sqrt(share) : radius;
}

}  // namespace

void PhotonMap::nearest(const PhotonQuery& query, FoundPhotons& found) const {
  found.count = 0;
  found.radius = query.radius;
  if (empty() || query.most == 0 || !(query.radius > 0)) return;
  const std::size_t room = Search::room(std::min(query.most, size()));
  if (found.indices.size() < room) {
    found.indices.resize(room);
    found.distances2.resize(room);
  }
  Search search(*this, query, found);
  FoundPhotons::Hint& hint = hint_at(query, found);
  constexpr float margin = 1.06F;
  const float guess = hint.radius > 0 ? margin * hint.radius : static_cast<float>(query.radius) / 8;
  const auto limit = static_cast<float>(query.radius * query.radius);
#if DURER_HAS_WIDE
  has_wide_vectors() ? search.look_wide(guess * guess, limit)
                       : search.look_plain(guess * guess, limit);
#else
  search.look_plain(guess * guess, limit);
#endif
  found.count = search.count();
  if (search.narrowed()) found.radius = std::sqrt(search.farthest2());
  hint.radius = found.last_radius = radius_of(found, query.most);
}

}  // namespace durer::tracer
