#include "tracer/patterns/penrose.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/vec.h"

namespace durer::tracer::patterns {
namespace {

// A tile is blown up until the point lies in a tile of the first generation; on the way each
// subdivision tells which tile of the next one the point is in. Names and order of the cases follow
// textures §9.3, where q is 1/φ.

constexpr double phi = std::numbers::phi;
constexpr double q = 1 / phi;
constexpr double slack = 1e-6;  // keeps tiles of different kinds apart

double cosine(double degrees) { return std::cos(degrees * std::numbers::pi / 180); }
double sine(double degrees) { return std::sin(degrees * std::numbers::pi / 180); }
double tangent(double degrees) { return std::tan(degrees * std::numbers::pi / 180); }

struct Point {
  double x, z;

  [[nodiscard]] Point turned(double degrees) const {
    const double c = cosine(degrees);
    const double s = sine(degrees);
    return {x * c - z * s, z * c + x * s};
  }
  [[nodiscard]] Point scaled(double by) const { return {x * by, z * by}; }
  /// The half above the axis: tiles are symmetric.
  [[nodiscard]] Point folded() const { return {x, std::abs(z)}; }
};

/// Folds a pattern of fivefold symmetry into one of its ten sectors.
Point fivefold(Point p) {
  const double r = std::sqrt(p.x * p.x + p.z * p.z);
  p = p.folded();
  if (p.x < r * cosine(36)) p = p.turned(p.x < r * cosine(108) ? -144 : -72);
  return p.folded();
}

/// Distance from the line through (x, 0) at an angle.
double line(Point p, double degrees, double x) {
  return std::abs(sine(degrees) * (p.x - x) - cosine(degrees) * p.z);
}
/// True below that line, as its tangent has it.
bool below(Point p, double degrees, double x) { return p.z < (p.x - x) * tangent(degrees); }

// ---- kites, darts and rhombs

/// Two grades that rise towards two borders, in the lower or the upper half of the values.
double lower_half(double a, double b, double steep) {
  return std::min(std::max({0.5 - steep * a, 0.5 - steep * b, 0.0}), 0.5 - slack);
}
double upper_half(double a, double b, double steep) {
  return std::max({1 - steep * a, 1 - steep * b, 0.5 + slack});
}

double dart(Point p, int n, bool rhombs);

double kite(Point p, int n, bool rhombs) {
  p = p.folded();
  if (n > 0) {
    if (below(p, 144, q)) return dart(p.scaled(phi), n - 1, rhombs);
    const Point turned = Point{p.x - cosine(36), p.z - sine(36)}.turned(108);
    return kite(turned.scaled(phi), n - 1, rhombs);
  }
  if (!rhombs) return lower_half(line(p, 36, 0), line(p, 108, 1), 2.23);
  if (below(p, 72, q)) return upper_half(line(p, 72, q), line(p, 108, 1), 2.775);
  return lower_half(std::abs(p.z), line(p, 72, q), 2.775);
}

double dart(Point p, int n, bool rhombs) {
  p = p.folded();
  if (n > 0) {
    if (below(p, 108, q)) return kite(p.turned(-36).scaled(phi), n - 1, rhombs);
    return dart(Point{p.x - 1, p.z}.turned(-144).scaled(phi), n - 1, rhombs);
  }
  if (rhombs) return lower_half(line(p, 36, 0), line(p, 144, 1), 2.775);
  return upper_half(std::abs(p.z), line(p, 144, 1), 2.23);
}

double kites(double x, double z, bool rhombs) {
  if (std::sqrt(x * x + z * z) <= epsilon) return 1;
  Point p = fivefold({x, z});
  if (rhombs) p = p.scaled(q);
  const double d = std::abs(sine(108) * p.x - cosine(108) * p.z) / cosine(18);
  const int m = std::max(0, static_cast<int>(std::ceil(std::log(d) / std::log(phi * phi))));
  p = p.scaled(std::pow(q, 2 * m));
  if (m % 2 != 0) p = p.turned(-36);
  return kite(p, 2 * m, rhombs);
}

// ---- pentagons, stars, boats and diamonds

const double side = 0.5 / sine(36);
const double apothem = 0.5 / tangent(36);
constexpr double steep = 5.55 * q;

/// Keeps a value within the share of the tiles of kind k, 1 to 6.
double share(int k, double v) {
  return std::min(std::max(v, (k - 1) / 6.0 + (k > 1 ? slack : 0.0)), k / 6.0 - slack);
}
/// How far a point of a pentagon is from its border.
double pentagon_grade(Point p) { return std::abs(fivefold(p).x - apothem) * steep; }

double star(Point p, int n);
double boat(Point p, int n, bool wedge);
enum class Diamond { of_pentagons, of_thirds };
double diamond(Point p, int n, Diamond kind);
double second(Point p, int n, bool quad);
double third(Point p, int n, bool wedge);

double first(Point p, int n) {
  p = fivefold(p);
  if (n > 0) {
    if (p.z < (p.x - apothem) * tangent(54) + 0.5) {
      return second(Point{p.x - apothem - q * side * cosine(72), p.z}.scaled(phi), n - 1, false);
    }
    return star(p.turned(-36).scaled(phi), n - 1);
  }
  return share(1, (1 - std::abs(p.x - apothem) * steep) / 6);
}

double second(Point p, int n, bool quad) {
  p = p.folded();
  if (n == 0) return share(2, (2 - pentagon_grade(p)) / 6);
  if (quad) {
    if (below(p, 54, q * q * side)) return first(Point{p.x - side, p.z}.scaled(phi), n - 1);
    if (below(p, 162, q * q * side)) {
      return diamond(Point{-p.x, p.z}.scaled(phi), n - 1, Diamond::of_pentagons);
    }
    const Point t = p.turned(108);
    return second(Point{t.x + q * side, t.z}.scaled(phi), n - 1, true);
  }
  if (below(p, 18, -side)) {
    return diamond(Point{p.x + side - q * q * side, p.z}.scaled(phi), n - 1, Diamond::of_thirds);
  }
  const Point t = p.turned(-36);
  return third(Point{-t.x - cosine(72) * side, t.z - sine(72) * side}.scaled(phi), n - 1, false);
}

double third(Point p, int n, bool wedge) {
  p = p.folded();
  if (n == 0) return share(3, (3 - pentagon_grade(p)) / 6);
  if (wedge && p.x > q * q * side * cosine(72)) {
    const Point t{p.x - q * q * side * cosine(72) - q * apothem, p.z};
    return second(Point{-t.x, t.z}.scaled(phi), n - 1, true);
  }
  if (!wedge && p.x < side * cosine(108)) {
    const Point t = p.turned(-144);
    return second(Point{t.x - side, t.z}.scaled(phi), n - 1, false);
  }
  if (!wedge && p.z > (p.x - q * q * side) * tangent(126)) {
    const Point t = p.turned(36);
    return third(Point{-t.x - cosine(72) * side, t.z - sine(72) * side}.scaled(phi), n - 1, false);
  }
  return boat(p.scaled(phi), n - 1, wedge);
}

double star(Point p, int n) {
  p = p.folded();
  if (n == 0) return share(4, (4 - line(p, 162, phi * side) * steep) / 6);
  if (p.x < q * apothem) return first(p.scaled(phi), n - 1);
  return third(Point{-(p.x - 2 * q * apothem), p.z}.scaled(phi), n - 1, true);
}

double boat(Point p, int n, bool wedge) {
  p = p.folded();
  if (n > 0) {
    if (wedge && p.x > phi * side * cosine(108)) {
      return first(Point{-p.x, p.z}.scaled(phi), n - 1);
    }
    const Point t = wedge ? p : p.turned(72);
    return third(Point{t.x + side, t.z}.scaled(phi), n - 1, true);
  }
  const double a = std::abs(p.x - q * side * cosine(72)) * steep;
  const double b = line(fivefold({-p.x, p.z}), 162, phi * side) * steep;
  return share(5, std::max(5 - a, 5 - b) / 6);
}

double diamond(Point p, int n, Diamond kind) {
  p = p.folded();
  if (n > 0) {
    return kind == Diamond::of_pentagons ? first(p.scaled(phi), n - 1)
                                         : third(p.scaled(phi), n - 1, true);
  }
  return share(6, (6 - line(p, 18, -q * side) * steep) / 6);
}

}  // namespace

double penrose_kites(double x, double z) { return kites(x, z, false); }
double penrose_rhombs(double x, double z) { return kites(x, z, true); }

double penrose_pentagons(double x, double z) {
  if (std::sqrt(x * x + z * z) <= epsilon) return 1;
  Point p = fivefold({x, z});
  const double growth = std::log(2 * p.x * tangent(36)) / std::log(phi * phi * phi * phi);
  const int m = std::max(0, static_cast<int>(std::ceil(growth)));
  p = p.scaled(std::pow(q, 4 * m));
  return first(p, 4 * m);
}

}  // namespace durer::tracer::patterns
