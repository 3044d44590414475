#include "tracer/patterns/tilings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <mutex>
#include <numbers>

namespace durer::tracer::patterns {
namespace {

constexpr double root2 = std::numbers::sqrt2;
constexpr double root3 = std::numbers::sqrt3;
constexpr double h = root3 / 2;  // height of a triangle of unit side

using Points = std::vector<dvec2>;

Points box(double x0, double x1, double z0, double z1) {
  return {{x0, z0}, {x1, z0}, {x1, z1}, {x0, z1}};
}

/// The regular hexagon of unit side with two horizontal edges.
Points hexagon(double x, double z) {
  return {{x + 1, z},       {x + 0.5, z + h}, {x - 0.5, z + h},
          {x - 1, z},       {x - 0.5, z - h}, {x + 0.5, z - h}};
}

Points moved(Points points, dvec2 by) {
  for (dvec2& p : points) p += by;
  return points;
}
Points mirrored_x(Points points) {
  for (dvec2& p : points) p.x = -p.x;
  return points;
}
Points mirrored_z(Points points) {
  for (dvec2& p : points) p.y = -p.y;
  return points;
}
/// Counter-clockwise, with z upwards.
Points turned(Points points, double degrees, dvec2 about) {
  const double angle = degrees * std::numbers::pi / 180;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  for (dvec2& p : points) {
    const dvec2 d = p - about;
    p = about + dvec2(c * d.x - s * d.y, s * d.x + c * d.y);
  }
  return points;
}

const Points up_triangle = {{0, 0}, {1, 0}, {0.5, h}};
const Points down_triangle = {{0, 0}, {0.5, h}, {-0.5, h}};
const Points rhombus = {{0, 0}, {1, 0}, {1.5, h}, {0.5, h}};

dvec2 middle(const Points& points) {
  dvec2 sum(0.0);
  for (const dvec2& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

Tile tile_of(int kind, Points corners) {
  Tile tile{kind, {}};
  const dvec2 m = middle(corners);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const dvec2 from = corners[i];
    const dvec2 along = corners[(i + 1) % corners.size()] - from;
    const double length = std::sqrt(along.x * along.x + along.y * along.y);
    dvec2 n(-along.y / length, along.x / length);
    if (n.x * (m.x - from.x) + n.y * (m.y - from.y) < 0) n = -n;
    tile.edges.push_back({n.x, n.y, -(n.x * from.x + n.y * from.y)});
  }
  return tile;
}

}  // namespace

void Tiling::lattice(dvec2 a, dvec2 b) {
  a_ = a;
  b_ = b;
}

void Tiling::add(int kind, const Points& corners) { outlines_.push_back({kind, corners}); }

dvec2 Tiling::lattice_place(dvec2 p) const {
  const double det = a_.x * b_.y - a_.y * b_.x;
  return {(p.x * b_.y - p.y * b_.x) / det, (a_.x * p.y - a_.y * p.x) / det};
}

/// Keeps the copies of the tiles that reach into the cell at the origin.
void Tiling::close() {
  constexpr int reach = 4;
  constexpr double margin = 1e-6;
  for (const Outline& o : outlines_) {
    for (int i = -reach; i <= reach; ++i) {
      for (int j = -reach; j <= reach; ++j) {
        const Points copy = moved(o.corners, static_cast<double>(i) * a_ + static_cast<double>(j) * b_);
        dvec2 lo(1e9);
        dvec2 hi(-1e9);
        for (const dvec2& p : copy) {
          const dvec2 q = lattice_place(p);
          lo = {std::min(lo.x, q.x), std::min(lo.y, q.y)};
          hi = {std::max(hi.x, q.x), std::max(hi.y, q.y)};
        }
        if (hi.x < -margin || hi.y < -margin || lo.x > 1 + margin || lo.y > 1 + margin) continue;
        tiles_.push_back(tile_of(o.kind, copy));
      }
    }
  }
}

/// Cuts what the tiles so far leave free into triangles of unit side.
void Tiling::fill_with_triangles() {
  const std::vector<Outline> taken = outlines_;
  const auto is_free = [&](dvec2 p) {
    for (const Outline& o : taken) {
      const Tile tile = tile_of(o.kind, o.corners);
      for (int i = -3; i <= 3; ++i) {
        for (int j = -3; j <= 3; ++j) {
          if (tile.depth(p + static_cast<double>(i) * a_ + static_cast<double>(j) * b_) > 0) return false;
        }
      }
    }
    return true;
  };
  for (int i = -8; i <= 8; ++i) {
    for (int j = -8; j <= 8; ++j) {
      const dvec2 by(i + 0.5 * j, h * j);
      for (int kind = 0; kind < 2; ++kind) {
        const Points triangle = moved(kind == 0 ? up_triangle : down_triangle, by);
        const dvec2 q = lattice_place(middle(triangle));
        if (q.x < 0 || q.x >= 1 || q.y < 0 || q.y >= 1 || !is_free(middle(triangle))) continue;
        add(kind, triangle);
      }
    }
  }
}

void Tiling::by_squares(int number) {
  steepness = 2;
  switch (number) {
    case 6:
      kinds = 2;
      lattice({1, 1}, {4, 0});
      add(0, box(1, 3, 0, 1));
      return add(1, box(0, 1, 0, 2));
    case 10: lattice({1, 0}, {0.5, 1}); return add(0, box(0, 1, 0, 1));
    case 11:
      kinds = 3;
      lattice({3, 0}, {0, 3});
      add(0, box(1, 2, 1, 2));
      add(1, box(1, 3, 0, 1));
      add(1, box(0, 2, 2, 3));
      add(2, box(0, 1, 0, 2));
      return add(2, box(2, 3, 1, 3));
    case 15:
      kinds = 2;
      lattice({2, 1}, {-1, 2});
      add(0, box(0, 1, 0, 1));
      return add(1, box(1, 3, -1, 1));
    case 18:
      kinds = 2;
      lattice({2, 2}, {4, 0});
      add(0, box(2, 4, 0, 1));
      add(0, box(2, 4, 1, 2));
      add(1, box(0, 1, 0, 2));
      return add(1, box(1, 2, 0, 2));
    case 7: {
      const double q = 1 + root2;
      kinds = 2;
      lattice({q, 0}, {0, q});
      add(0, {{q / 2, 0.5}, {q - 0.5, q / 2}, {q / 2, q - 0.5}, {0.5, q / 2}});
      return add(1, {{0.5, q / 2}, {-0.5, q / 2}, {-q / 2, 0.5}, {-q / 2, -0.5},
                     {-0.5, -q / 2}, {0.5, -q / 2}, {q / 2, -0.5}, {q / 2, 0.5}});
    }
    default: return add(0, box(0, 1, 0, 1));
  }
}

void Tiling::by_triangles(int number) {
  steepness = 4 * h;
  if (number == 8) {
    kinds = 3;
    lattice({1, 0}, {0.5, 1 + h});
    add(0, moved(up_triangle, {0, 1}));
    add(1, moved(down_triangle, {0, 1}));
    return add(2, box(0, 1, 0, 1));
  }
  if (number == 9) {
    kinds = 3;
    lattice({2, 0}, {1, 2 * h});
    add(0, moved(up_triangle, {-1, 0}));
    add(1, {{-1, 2 * h}, {0, 2 * h}, {-0.5, h}});
    return add(2, hexagon(0.5, h));
  }
  if (number == 3) {
    kinds = 2;
    lattice({1, 0}, {0.5, h});
    add(0, up_triangle);
    return add(1, down_triangle);
  }
  kinds = 3;  // 19 and 20
  if (number == 19) {
    lattice({2.5, -h}, {-0.5, 3 * h});
  } else {
    lattice({2.5, h}, {0.5, 3 * h});
  }
  add(2, hexagon(1, 2 * h));
  fill_with_triangles();
}

void Tiling::by_hexagons(int number) {
  if (number == 2) {
    steepness = 1 / h;
    lattice({3, 0}, {1.5, h});
    return add(0, hexagon(0.5, h));
  }
  steepness = 2 / h;
  if (number == 4) {
    lattice({1, 0}, {0.5, h});
    return add(0, rhombus);
  }
  kinds = 3;  // 5
  lattice({3, 0}, {1.5, h});
  add(0, rhombus);
  add(1, {{0, 0}, {0.5, h}, {0, 2 * h}, {-0.5, h}});
  add(2, mirrored_x(rhombus));
}

/// 13 and 14: a square and four trapezoids around it. Kinds of square, right, left, top, bottom.
void Tiling::by_trapezoids(const int (&kind_of)[5]) {
  steepness = 2 * root2;
  lattice({2 * root2, 0}, {0, 2 * root2});
  const auto scaled = [](Points points) {
    for (dvec2& p : points) p = (p + 2.0) / root2;
    return points;
  };
  const Points right = {{1, -1}, {2, -2}, {2, 2}, {1, 1}};
  const Points top = {{-1, 1}, {-2, 2}, {2, 2}, {1, 1}};
  add(kind_of[0], scaled(box(-1, 1, -1, 1)));
  add(kind_of[1], scaled(right));
  add(kind_of[2], scaled(mirrored_x(right)));
  add(kind_of[3], scaled(top));
  add(kind_of[4], scaled(mirrored_z(top)));
}

/// 16 and 17: hexagons in rings of squares and triangles.
void Tiling::by_small_rings(int number) {
  steepness = 4 * h;
  lattice({3 + root3, 0}, {h + 1.5, h + 0.5});
  const dvec2 m(h + 0.5, h + 0.5);
  const Points square = box(h, 1 + h, -0.5, 0.5);
  const Points left = {{h, -0.5}, {h, 0.5}, {0, 0}};
  const Points right = {{1 + h, -0.5}, {1 + h, 0.5}, {1 + 2 * h, 0}};
  const bool many = number == 17;
  kinds = many ? 6 : 3;
  add(many ? 5 : 2, hexagon(m.x, m.y));
  add(0, square);
  add(many ? 2 : 0, turned(square, 60, m));
  add(many ? 1 : 0, turned(square, -60, m));
  add(many ? 4 : 1, left);
  add(many ? 3 : 1, right);
}

/// 21: pairs of triangles between squares.
void Tiling::by_triangle_rings() {
  const double q = 1 + root3;
  steepness = 4 * h;
  kinds = 6;
  lattice({q, 0}, {0, q});
  const dvec2 half(q / 2, q / 2);
  const Points right = {{0, -0.5}, {0, 0.5}, {h, 0}};
  add(0, right);
  add(0, moved(right, half));
  add(2, mirrored_x(right));
  add(2, moved(mirrored_x(right), half));
  add(3, {{q / 2 - 0.5, 0}, {q / 2 + 0.5, 0}, {q / 2, h}});
  add(3, {{-0.5, q / 2}, {0.5, q / 2}, {0, q / 2 + h}});
  add(1, {{q / 2 - 0.5, 0}, {q / 2 + 0.5, 0}, {q / 2, -h}});
  add(1, {{-0.5, q / 2}, {0.5, q / 2}, {0, q / 2 - h}});
  const Points square = {{0, 0.5}, {h, 0}, {h + 0.5, h}, {0.5, h + 0.5}};
  add(4, square);
  add(4, mirrored_z(mirrored_x(square)));
  add(5, mirrored_x(square));
  add(5, mirrored_z(square));
}

/// 23 and 24: dodecagons in rings of squares and hexagons.
void Tiling::by_big_rings(int number) {
  steepness = 2;
  const bool many = number == 24;
  kinds = many ? 5 : 3;
  lattice({3 + root3, 0}, {1.5 + h, 3 * h + 1.5});
  const dvec2 m(1.5 + h, 1 + root3);
  Points dodecagon;
  const double radius = 0.5 / std::sin(std::numbers::pi / 12);
  for (int i = 0; i < 12; ++i) {
    const double angle = (15 + 30 * i) * std::numbers::pi / 180;
    dodecagon.push_back(m + radius * dvec2(std::cos(angle), std::sin(angle)));
  }
  add(many ? 4 : 2, dodecagon);
  const Points square = box(-0.5, 0.5, root3 + 0.5, root3 + 1.5);
  add(1, square);
  add(many ? 2 : 1, turned(square, 60, m));
  add(many ? 3 : 1, turned(square, -60, m));
  const Points below = hexagon(1.5 + h, 0);
  add(0, below);
  add(0, turned(below, 60, m));
}

Tiling::Tiling(int number) {
  switch (number) {
    case 2:
    case 4:
    case 5: by_hexagons(number); break;
    case 3:
    case 8:
    case 9:
    case 19:
    case 20: by_triangles(number); break;
    case 13:
      kinds = 3;
      by_trapezoids({0, 2, 2, 1, 1});
      break;
    case 14:
      kinds = 5;
      by_trapezoids({4, 0, 1, 3, 2});
      break;
    case 16:
    case 17: by_small_rings(number); break;
    case 21: by_triangle_rings(); break;
    case 23:
    case 24: by_big_rings(number); break;
    default: by_squares(number); break;
  }
  close();
}

Tiling::Place Tiling::at(dvec2 p) const {
  const dvec2 q = lattice_place(p);
  p -= std::floor(q.x) * a_ + std::floor(q.y) * b_;
  // A border belongs to the tile beyond it: to the right, or above.
  const dvec2 beside = p + dvec2(2e-10, 1e-10);
  const Tile* best = &tiles_.front();
  double depth = -1e9;
  for (const Tile& tile : tiles_) {
    const double d = tile.depth(beside);
    if (d > depth) {
      depth = d;
      best = &tile;
    }
  }
  return {best->kind, std::max(0.0, best->depth(p))};
}

const Tiling& tiling_of(int number) {
  static std::array<std::unique_ptr<const Tiling>, 25> known;
  static std::mutex making;
  const std::lock_guard lock(making);
  auto& tiling = known[static_cast<std::size_t>(number)];
  if (!tiling) tiling = std::make_unique<const Tiling>(number);
  return *tiling;
}

}  // namespace durer::tracer::patterns
