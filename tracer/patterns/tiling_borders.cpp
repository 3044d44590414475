#include "tracer/patterns/tiling_borders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/floor.h"

namespace durer::tracer::patterns {
namespace {

constexpr double root2 = std::numbers::sqrt2;
constexpr double root3 = std::numbers::sqrt3;
constexpr double h = root3 / 2;

/// True beyond one of the sides of the triangle over 0 to 1.
bool outside_triangle(double x, double z) { return z > root3 * x || z > root3 * (1 - x); }

/// Triangles. Upright ones have the upper hand in the line through their tips.
int triangles(double x, double z) {
  x = floor_mod(x, 1);
  z = floor_mod(z, root3);
  const bool mirrored = z > h;
  if (mirrored) z = root3 - z;
  return (x != 0 && outside_triangle(x, z)) != mirrored ? 1 : 0;
}

/// Rhombs in three directions.
int rhombs(double x, double z) {
  z = floor_mod(z, root3);
  if (z > h) {
    z -= h;
    x -= 1.5;
  }
  x = floor_mod(x, 3);
  const bool mirrored = x >= 1.5;
  if (mirrored) x = 3 - x;
  if (x == 0 || z / x > root3 || x == 1.5 || (h - z) / (1.5 - x) > root3) return 1;
  return mirrored ? 2 : 0;
}

/// Rows of squares between rows of triangles.
int squares_and_triangles(double x, double z) {
  z = floor_mod(z, 2 + root3);
  if (z >= 1 + h) {
    z -= 1 + h;
    x += 0.5;
  }
  if (z <= 1) return 2;
  return outside_triangle(floor_mod(x, 1), z - 1) ? 1 : 0;
}

/// Hexagons that touch, triangles between them.
int hexagons_and_triangles(double x, double z) {
  z = floor_mod(z, 2 * root3);
  if (z > root3) {
    z -= root3;
    x += 1;
  }
  const bool mirrored = z >= h;
  if (mirrored) z = root3 - z;
  x = floor_mod(x, 2) - 1;
  if (!(x > 0 && z < root3 * x && z < root3 * (1 - x))) return 2;
  return mirrored ? 1 : 0;
}

/// Hexagons with triangles all around, in a skewed cell; the one of tiling 20 leans the other way.
/// A hexagon has its lower border, but not its upper one.
int lone_hexagons(int number, double x, double z) {
  const bool leans_right = number == 20;
  const dvec2 step = leans_right ? dvec2(2, 2 * h) : dvec2(2.5, h);
  const double shift = leans_right ? -0.5 : 0.5;  // from a row of cells to the next one
  const double row = floored(z / (3 * h));
  z -= row * (3 * h);
  x = floor_mod(x + shift * row, 7);
  while (x > step.x) {
    x -= step.x;
    z += step.y;
    if (z > 3 * h) {
      z -= 3 * h;
      x += shift;
    }
  }
  if (z >= h && z < 3 * h && std::abs(z - 2 * h) <= root3 * (1 - std::abs(x - 1))) return 2;
  if (z > 2 * h) {
    z -= 2 * h;
  } else if (z > h) {
    z -= h;
    x -= 0.5;
  }
  x = floor_mod(x, 1);
  return x == 0 || outside_triangle(x, z) ? 1 : 0;
}

/// Hexagons, triangles and squares of three directions, seen from the middle of an upright square.
/// The kind of tile in tiling 17.
int small_rings(dvec2 p) {
  constexpr double width = 1.5 + h;  // to the next upright square, which is higher by `height`
  constexpr double height = 0.5 + h;
  double x = floor_mod(p.x - height, 2 * width);
  double z = floor_mod(p.y, 2 * height);
  bool left = x >= width;
  bool below = z >= height;
  if (left) x = 2 * width - x;
  if (below) z = 2 * height - z;
  for (int turn = 0; turn < 2; ++turn) {  // as this square sees it, as the other one does
    if (x < 0.5 && z < 0.5) return 0;
    if (x >= 0.5 && root3 * z < height - x) return left ? 4 : 3;
    if (z >= 0.5 && root3 * (x - 0.5) < z - 0.5) return 5;
    x = width - x;
    z = height - z;
    left = !left;
    below = !below;
  }
  return left == below ? 2 : 1;
}
constexpr std::array<int, 6> kinds_in_16 = {0, 0, 0, 1, 1, 2};

/// A square in the middle of four trapezoids, seen from that middle; 4 by 4.
struct Frame {
  double x, z;

  explicit Frame(dvec2 p) : x(floor_mod(p.x * root2, 4) - 2), z(floor_mod(p.y * root2, 4) - 2) {}

  enum Part : std::size_t { square, right, left, top, bottom };
  [[nodiscard]] Part part() const {
    if (std::abs(x) < 1 && std::abs(z) < 1) return square;
    if (std::abs(x) > std::abs(z)) return x > 0 ? right : left;
    return z > 0 ? top : bottom;
  }
};

constexpr std::array<std::array<int, 5>, 2> kinds_in_frame = {{{0, 2, 2, 1, 1}, {4, 0, 1, 3, 2}}};
constexpr std::array<int, 2> kinds_of_frames = {3, 5};

/// Where the square in the middle of tiling 12 would be, the value is a little higher.
std::optional<double> bricks_on_mirror(dvec2 p) {
  if (floor_mod(p.y, 6) == 0) return 1.0 / 3 - 2e-5;
  if (floor_mod(p.x, 6) != 0) return {};
  const double z = std::abs(floor_mod(p.y, 6) - 3);
  return 1.0 / 3 - (z >= 1 && z < 2 ? 1e-5 : 2e-5);
}

/// Left and right of the frame, the tile above or below goes on, without an end.
std::optional<double> frames_on_mirror(std::size_t which, dvec2 p) {
  const Frame frame(p);
  if (frame.z == -2) return 0.0;
  if (frame.x != -2) return {};
  const double from_outside = 2 - std::abs(frame.z);
  if (from_outside <= 1) return 0.0;
  const int kind = kinds_in_frame[which][frame.z > 0 ? Frame::top : Frame::bottom];
  return (kind + 2 * from_outside - 1) / kinds_of_frames[which];
}

}  // namespace

double floor_mod(double a, double b) { return a - b * floored(a / b); }

std::optional<int> kind_by_folding(int number, dvec2 p) {
  switch (number) {
    case 3: return triangles(p.x, p.y);
    case 5: return rhombs(p.x, p.y);
    case 8: return squares_and_triangles(p.x, p.y);
    case 9: return hexagons_and_triangles(p.x, p.y);
    case 13: return kinds_in_frame[0][Frame(p).part()];
    case 14: return kinds_in_frame[1][Frame(p).part()];
    case 16: return kinds_in_16[static_cast<std::size_t>(small_rings(p))];
    case 17: return small_rings(p);
    case 19:
    case 20: return lone_hexagons(number, p.x, p.y);
    default: return {};
  }
}

std::optional<double> value_on_mirror(int number, dvec2 p) {
  switch (number) {
    case 12: return bricks_on_mirror(p);
    case 13: return frames_on_mirror(0, p);
    case 14: return frames_on_mirror(1, p);
    default: return {};
  }
}

}  // namespace durer::tracer::patterns
