// Several rays to one shape: arrays of their coordinates, which are read in vectors.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "base/ray.h"

namespace durer::tracer {

/// So many rays go side by side at most.
inline constexpr std::size_t most_in_packet = 16;

/// A number of each ray.
template <typename T>
using PerRay = std::array<T, most_in_packet>;

/// A vector of each, by coordinate. Not set at first: clearing all of it for every packet would
/// cost more than some answers.
struct PacketVectors {
  alignas(64) std::array<PerRay<double>, 3> of;

  [[nodiscard]] dvec3 operator[](std::size_t i) const { return {of[0][i], of[1][i], of[2][i]}; }
  void set(std::size_t i, const dvec3& v) {
    of[0][i] = v.x;
    of[1][i] = v.y;
    of[2][i] = v.z;
  }
};

/// To unit length: glm::normalize of each of the first `count`, to the last bit.
void normalize(PacketVectors& vectors, std::size_t count);
/// Bits of those among the first `count` with a · b > 0.
[[nodiscard]] std::uint32_t along(const PacketVectors& a, const PacketVectors& b,
                                  std::size_t count);
/// Bits of those among them whose length is above zero.
[[nodiscard]] std::uint32_t above_zero(const PacketVectors& vectors, std::size_t count);

/// Bits of all rays of a packet that is full.
inline constexpr std::uint32_t all_of_packet = (1U << most_in_packet) - 1;

/// Rays that a shape answers together, in the shape's space; |d| is anything. Wanted is the first
/// visible crossing in t_from <= t < t_to; ranges may be empty.
struct PacketRays {
  PacketVectors o, d;
  alignas(64) PerRay<double> t_from;
  alignas(64) PerRay<double> t_to;
  std::size_t count = 0;

  [[nodiscard]] std::size_t size() const { return count; }
  [[nodiscard]] Ray ray(std::size_t i) const { return {o[i], d[i]}; }
  void add(const Ray& ray, double from, double to) {
    o.set(count, ray.o);
    d.set(count, ray.d);
    t_from[count] = from;
    t_to[count] = to;
    ++count;
  }
  /// Idle places repeat the last ray: whoever reads all of them meets nothing strange. To be called
  /// when there are no more rays to add.
  void fill_up() {
    if (count < most_in_packet) repeat_last();
  }

 private:
  void repeat_last();
};

/// The answers.
struct PacketHits {
  std::uint32_t met = 0;  // a bit for each ray
  PerRay<double> t;       // of those that met something, and which part that is
  PerRay<std::uint32_t> part;

  void set(std::size_t i, double at, std::uint32_t of_part) {
    met |= 1U << i;
    t[i] = at;
    part[i] = of_part;
  }
};

/// Points on one shape, and on which part of it each of them lies.
struct PacketPoints {
  PacketVectors p;
  PerRay<std::uint32_t> part;
  std::size_t count = 0;

  void add(const dvec3& point, std::uint32_t of_part) {
    p.set(count, point);
    part[count++] = of_part;
  }
  /// As with PacketRays.
  void fill_up() {
    if (count < most_in_packet) repeat_last();
  }

 private:
  void repeat_last();
};

/// Room for something of each ray, which whoever uses it makes there.
template <typename T>
union Packet {
  static_assert(std::is_trivially_destructible_v<T>);

  Packet() {}  // NOLINT: `= default` would be deleted
  [[nodiscard]] T& operator[](std::size_t i) { return items[i]; }
  [[nodiscard]] std::span<T> first(std::size_t count) { return std::span<T>(items).first(count); }

  std::array<T, most_in_packet> items;
};

}  // namespace durer::tracer
