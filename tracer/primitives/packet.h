// Several rays to one shape.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>

#include "base/ray.h"

namespace durer::tracer {

/// So many rays go side by side at most.
inline constexpr std::size_t most_in_packet = 16;

/// One of several rays that a shape answers together, in the shape's space; |d| is anything. Wanted is
/// the first visible crossing in t_from <= t < t_to.
struct PacketRay {
  Ray ray;
  double t_from;
  double t_to;
};

/// Room for something of each ray, which whoever uses it makes there: clearing all of it for every
/// packet would cost more than some answers.
template <typename T>
union Packet {
  static_assert(std::is_trivially_destructible_v<T>);

  Packet() {}  // NOLINT: `= default` would be deleted
  [[nodiscard]] T& operator[](std::size_t i) { return items[i]; }
  [[nodiscard]] std::span<T> first(std::size_t count) { return std::span<T>(items).first(count); }

  std::array<T, most_in_packet> items;
};

}  // namespace durer::tracer
