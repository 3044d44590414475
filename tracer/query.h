// One question to the hierarchy, as it travels from object to object.
#pragma once

#include <array>
#include <cstdint>

#include "base/ray.h"
#include "tracer/primitives/packet.h"
#include "tracer/primitives/store.h"

namespace durer::tracer {

/// How deep contents that are kept once may be nested; what is deeper is copied.
inline constexpr std::uint32_t max_placement_depth = 4;

/// The way down to what was hit, innermost placement first.
using PlacementPath = std::array<std::uint32_t, max_placement_depth>;

struct Parts;       // shapes and programs of the scene, see csg/
struct SweepState;  // buffers of one thread, see csg/

/// Where a ray ended: enough to make a Hit.
struct Found {
  const Store* store = nullptr;  // null: nothing yet
  std::uint32_t shape = 0;
  std::uint32_t leaf = 0;
  std::uint32_t part = 0;
  std::uint32_t depth = 0;  // entries of the query's path
};

/// Objects that rays came by and that wait to be asked once for all of these.
struct PutOff {
  struct Object {
    const Targets* targets;
    std::uint32_t index;
    std::uint32_t rays;  // a bit for each
  };
  static constexpr std::uint32_t most = 16;
  /// Of a ray that passes more of them, those on its way are asked before it goes on, lest it asks
  /// everybody behind what it hits.
  static constexpr std::uint32_t most_of_ray = 4;

  std::array<Object, most> objects;  // in the order in which rays came by
  std::uint32_t count = 0;
  // The ray that is on its way.
  std::uint32_t ray = 0;  // its bit
  std::uint32_t passed = 0;

  void begin(std::uint32_t number) {
    ray = 1U << number;
    passed = 0;
  }
  /// False if there is no room.
  bool add(const Targets& targets, std::uint32_t index) {
    if (passed == most_of_ray) return false;
    std::uint32_t i = 0;
    while (i < count && (objects[i].targets != &targets || objects[i].index != index)) ++i;
    if (i == most) return false;
    if (i == count) objects[count++] = {&targets, index, 0};
    objects[i].rays |= ray;
    ++passed;
    return true;
  }
};

/// Looks for t_from <= t < t_to; t_to shrinks to the nearest hit. World space, double: the
/// hierarchy's own single-precision ray only chooses whom to ask.
struct RayQuery {
  const Ray& ray;  // not a copy: reading at once what was just written in smaller pieces takes long
  double t_from = 0;
  double t_to = 0;
  const Parts* parts = nullptr;
  SweepState* sweep = nullptr;
  PutOff* later = nullptr;  // null: everybody answers at once
  Found found{};
  PlacementPath path{};  // valid as far as `found` says
  // Bytes stand last: where they are between larger things, these are cleared in pieces that overlap
  // them, and reading takes long again.
  std::uint8_t mask = 0;
  bool any = false;  // one hit is as good as any other
};

/// True if these bounds (Parts::gates), or those of a gated leaf, let the ray through (csg/gate.cpp).
[[nodiscard]] bool gate_open(std::uint32_t gate, const RayQuery& query);
[[nodiscard]] bool gates_open(std::uint32_t leaf, const RayQuery& query);

/// Asks what a query has put off, which from now on puts off nothing (geometry_together.cpp).
void ask_now(RayQuery& query);

}  // namespace durer::tracer
