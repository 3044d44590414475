// One question to the hierarchy, as it travels from object to object.
#pragma once

#include <cstdint>

#include "base/ray.h"
#include "tracer/primitives/store.h"

namespace durer::tracer {

struct Parts;       // shapes and programs of the scene, see csg/
struct SweepState;  // buffers of one thread, see csg/

/// Where a ray ended: enough to make a Hit.
struct Found {
  const Store* store = nullptr;  // null: nothing yet
  std::uint32_t shape = 0;
  std::uint32_t leaf = 0;
  std::uint32_t part = 0;
};

/// Looks for t_from <= t < t_to; t_to shrinks to the nearest hit. World space, double: the
/// hierarchy's own single-precision ray only chooses whom to ask.
struct RayQuery {
  Ray ray;
  double t_from = 0;
  double t_to = 0;
  std::uint8_t mask = 0;
  Found found{};
  const Parts* parts = nullptr;
  SweepState* sweep = nullptr;
  bool any = false;  // one hit is as good as any other
};

/// True if the bounds of a gated leaf let the ray through (csg/gate.cpp).
[[nodiscard]] bool gates_open(std::uint32_t leaf, RayQuery& query);

}  // namespace durer::tracer
