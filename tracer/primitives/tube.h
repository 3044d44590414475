// The body that cylinders and cones share: a round wall between two planes across the z axis.
// Canonical: z in [0, 1], radius 1 + slope·z. Parts: 0 wall, 1 low cap, 2 high cap.
#pragma once

#include <array>
#include <optional>

#include "base/bounds.h"
#include "base/ray.h"
#include "tracer/primitives/crossing.h"
#include "tracer/primitives/shaft_hull.h"

namespace durer::tracer {

struct Tube {
  double slope = 0;  // 0: a cylinder; below -1: an hourglass
  bool open = false;

  static constexpr double far = t_far;

  [[nodiscard]] Bounds3 bounds() const;
  /// As in the oracle, the closed body shrinks by 1e-10 and the open one grows (objects §10.3).
  [[nodiscard]] bool contains(dvec3 p) const;
  [[nodiscard]] bool misses(const ShaftHull& hull) const;
  [[nodiscard]] dvec3 normal(dvec3 p, std::uint32_t part) const;
  /// Caps of an open body are invisible crossings: its inside is that of the closed one.
  void crossings(const Ray& ray, Crossings& out) const;
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const;

 private:
  struct End {
    double t;
    std::uint16_t part;
  };
  struct Piece {
    End enter;
    End exit;
  };
  /// The parts of the line inside the body: at most one, two for an hourglass.
  struct Pieces {
    std::array<Piece, 2> items;
    int count = 0;

    void add(End enter, End exit) { items[static_cast<std::size_t>(count++)] = {enter, exit}; }
  };
  [[nodiscard]] double radius(double z) const { return 1 + slope * z; }
  [[nodiscard]] Pieces inside_wall(const Ray& ray) const;
  [[nodiscard]] Pieces inside(const Ray& ray) const;
  [[nodiscard]] bool visible(std::uint16_t part) const { return part == 0 || !open; }
};

}  // namespace durer::tracer
