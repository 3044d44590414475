// The tilings of the plane by regular polygons and their like, as polygons that repeat on a lattice
// (textures §9.1).
#pragma once

#include <limits>
#include <vector>

#include "base/vec.h"

namespace durer::tracer::patterns {

/// A convex tile.
struct Tile {
  struct Edge {
    double x, z, at;  // inside is where x·px + z·pz + at > 0; unit length
  };
  int kind = 0;
  std::vector<Edge> edges;

  /// Distance from the nearest edge; negative outside.
  [[nodiscard]] double depth(dvec2 p) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Edge& e : edges) {
      const double d = e.x * p.x + e.z * p.y + e.at;
      if (d < least) least = d;
    }
    return least;
  }
};

/// All tiles that reach into the cell of a lattice. Points are (x, z).
class Tiling {
 public:
  /// What a point sees: the kind of its tile, and how far it is from the border.
  struct Place {
    int kind = 0;
    double depth = 0;
  };

  /// Number 1 to 24, but not 12 or 22.
  explicit Tiling(int number);

  [[nodiscard]] Place at(dvec2 p) const;

  double steepness = 1;  // 1 / how far from the border a tile is flat
  int kinds = 1;

 private:
  using Points = std::vector<dvec2>;

  void lattice(dvec2 a, dvec2 b);
  void add(int kind, const Points& corners);
  void fill_with_triangles();
  void close();

  // What the numbers stand for, in groups that share their tiles.
  void by_squares(int number);
  void by_triangles(int number);
  void by_hexagons(int number);
  void by_trapezoids(const int (&kind_of)[5]);
  void by_triangle_rings();
  void by_small_rings(int number);
  void by_big_rings(int number);

  [[nodiscard]] dvec2 lattice_place(dvec2 p) const;

  dvec2 a_{1, 0}, b_{0, 1};
  struct Outline {
    int kind;
    Points corners;
  };
  std::vector<Outline> outlines_;
  std::vector<Tile> tiles_;
};

/// The one copy of a tiling. Thread-safe.
[[nodiscard]] const Tiling& tiling_of(int number);

}  // namespace durer::tracer::patterns
