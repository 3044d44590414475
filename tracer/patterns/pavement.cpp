#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "tracer/patterns/pattern_type.h"
#include "tracer/patterns/pavement_words.h"

namespace durer::tracer::patterns {
namespace {

constexpr double half_root3 = std::numbers::sqrt3 / 2;
constexpr double root3 = std::numbers::sqrt3;

std::int64_t floor_mod(std::int64_t a, std::int64_t b) { return (a % b + b) % b; }

/// How many patterns there are of 1, 2, 3 … tiles.
constexpr std::array<int, 6> patterns_of_3 = {1, 1, 1, 3, 4, 12};
constexpr std::array<int, 6> patterns_of_4 = {1, 1, 2, 5, 12, 35};
constexpr std::array<int, 6> patterns_of_6 = {1, 1, 3, 7, 22, 0};

/// A cell of the plane and the way through the rows of a pavement: the index of its letter.
struct PavementCell {
  std::int64_t x, z;

  [[nodiscard]] std::int64_t shifted(std::int64_t width, std::int64_t shift,
                                     std::int64_t rows) const {
    return floor_mod(x + shift * floor_mod(z, rows), width);
  }
  [[nodiscard]] std::int64_t grid(std::int64_t width, std::int64_t rows) const {
    return floor_mod(x, width) + width * floor_mod(z, rows);
  }
  /// Every other row is another one, and pairs of them are shifted.
  [[nodiscard]] std::int64_t pairs(std::int64_t width, std::int64_t shift, std::int64_t rows,
                                   std::int64_t of = 2) const {
    const std::int64_t row = floor_mod(z, rows);
    return floor_mod(x + shift * (row / of), width) + width * (row % of);
  }

  [[nodiscard]] std::int64_t of_squares(int tiles, int pattern) const;
  [[nodiscard]] std::int64_t of_triangles(int tiles, int pattern) const;
  [[nodiscard]] std::int64_t of_hexagons(int tiles, int pattern) const;
};

std::int64_t PavementCell::of_squares(int tiles, int pattern) const {
  switch (tiles) {
    case 1: return 0;
    case 2: return floor_mod(z, 2);
    case 3: return grid(3, 2);
    case 4: return grid(4, 4);
    case 5:
      switch (pattern) {
        case 1:
        case 2: return grid(5, 2);
        case 3:
        case 10: return pairs(5, 3, 10);
        case 11: return pairs(5, 4, 10);
        case 4:
        case 5: return shifted(5, 2, 5);
        case 8: return shifted(10, 3, 10);
        case 12: return shifted(10, 8, 10);
        default: return shifted(10, 1, 10);
      }
    default: break;
  }
  switch (pattern) {
    case 5:
    case 8:
    case 20:
    case 21: return shifted(6, 5, 6);
    case 12:
    case 19:
    case 28: return shifted(6, 1, 6);
    case 11:
    case 13:
    case 22:
    case 23:
    case 25:
    case 26:
    case 27: return grid(4, 3);
    case 14:
    case 33: return grid(3, 4);
    case 15: return pairs(3, 2, 6);
    case 16: {
      const std::int64_t column = floor_mod(x, 6);
      return column % 2 + 2 * floor_mod(z + column / 2, 3);
    }
    case 17:
    case 18: return pairs(6, 1, 12);
    case 24:
    case 29: return pairs(6, 4, 12);
    case 30:
    case 31: return pairs(6, 3, 4);
    case 32: return shifted(6, 4, 3);
    case 34: return shifted(12, 7, 12);
    case 35: return pairs(4, 2, 6, 3);
    default: return grid(6, 2);
  }
}

std::int64_t PavementCell::of_triangles(int tiles, int pattern) const {
  switch (tiles) {
    case 1:
    case 2: return 0;
    case 3: return shifted(6, 3, 2);
    case 4: {
      const std::int64_t row = floor_mod(z, 4);
      return floor_mod(x + row, 4) + 4 * (row % 2);
    }
    case 5: return pattern == 4 ? shifted(10, 3, 10) : shifted(10, 5, 2);
    default: break;
  }
  switch (pattern) {
    case 1:
    case 2:
    case 10: return floor_mod(x + 5 * z, 6);
    case 3:
    case 11:
    case 12: return shifted(6, 3, 2);
    case 4: return pairs(6, 14, 6);
    case 5:
    case 9: return pairs(6, 8, 6);
    case 7:
    case 8: return pairs(4, -1, 12, 3);
    default: return grid(6, 2);
  }
}

std::int64_t PavementCell::of_hexagons(int tiles, int pattern) const {
  // Columns of `width` cells are moved up, one after the other.
  const auto columns = [&](std::int64_t period, std::int64_t width, std::int64_t shift,
                           std::int64_t rows) {
    const std::int64_t row = floor_mod(z + shift * (floor_mod(x, period) / width), rows);
    return floor_mod(x, width) + width * row;
  };
  switch (tiles) {
    case 1: return shifted(6, 3, 2);
    case 2: return grid(6, 2);
    case 3: return pattern == 1 ? grid(6, 6) : pattern == 2 ? columns(18, 6, 2, 6) : grid(18, 2);
    case 4:
      switch (pattern) {
        case 1: return grid(6, 8);
        case 2: return columns(12, 6, 2, 8);
        case 3: return grid(12, 2);
        case 7: return grid(12, 4);
        default: return columns(24, 6, -2, 8);
      }
    default: break;
  }
  switch (pattern) {
    case 8: return columns(60, 3, -7, 20);
    case 1:
    case 3:
    case 4:
    case 6:
    case 7:
    case 20: return columns(30, 6, 0, 10);
    case 2:
    case 5:
    case 10: return columns(30, 6, -2, 10);
    case 12:
    case 17: return columns(30, 6, -6, 10);
    case 13:
    case 19: return columns(30, 6, 6, 10);
    default: return columns(30, 6, 2, 10);
  }
}

const PavementRow* find_row(std::span<const PavementRow> rows, int tiles, int pattern) {
  for (const PavementRow& row : rows) {
    if (row.tiles == tiles && row.pattern == pattern) return &row;
  }
  return nullptr;  // a single tile, which has the same word everywhere
}
unsigned word_of(const PavementRow& row, std::span<const std::uint16_t> bits, std::int64_t index) {
  const char c = row.letters[static_cast<std::size_t>(index) % row.letters.size()];
  return bits[static_cast<std::size_t>(c >= 'a' ? c - 'a' : c - 'A' + 26)];
}

// Tiles made of several triangles, squares or hexagons in the xz plane: 0 in their middle, 1 at
// their borders (textures §10).
struct Pavement {
  double sides = 3;
  double tiles = 1;
  double pattern = 1;
  double exterior = 0;
  double interior = 0;
  double form = 0;
  const PavementRow* row = nullptr;

  static constexpr std::array operands{
      keyword<&Pavement::sides>("number_of_sides", "3, 4 or 6"),
      keyword<&Pavement::tiles>("number_of_tiles", "how many make one stone"),
      keyword<&Pavement::pattern>("pattern", "which way of laying them"),
      keyword<&Pavement::exterior>("exterior", "how convex corners look"),
      keyword<&Pavement::interior>("interior", "how concave corners look"),
      keyword<&Pavement::form>("form", "how bent corners look"),
  };
  static constexpr std::array samples{
      Sample{{0.5, 0, 0.28867513459481287}, 0},
  };

  void prepare() {
    const int kind = static_cast<int>(sides);
    const std::span<const PavementRow> rows = kind == 4   ? std::span<const PavementRow>(pavement_rows_4)
                                              : kind == 6 ? std::span<const PavementRow>(pavement_rows_6)
                                                          : std::span<const PavementRow>(pavement_rows_3);
    row = find_row(rows, static_cast<int>(tiles), static_cast<int>(pattern));
  }
  double operator()(dvec3 p) const {
    return static_cast<int>(sides) == 4 ? squares(p.x, p.z) : triangles(p.x, p.z);
  }

 private:
  [[nodiscard]] int ways(double v, int count) const {
    return static_cast<int>(floor_mod(static_cast<std::int64_t>(v), count));
  }
  [[nodiscard]] double squares(double x, double z) const;
  [[nodiscard]] double triangles(double x, double z) const;
};

/// Corners of a square: signs of x and z, the borders that make it convex, the bits of a bent one.
struct SquareCorner {
  double x, z;
  unsigned inner, borders, bent;
};
constexpr std::array<SquareCorner, 4> square_corners{{
    {-1, 1, 0x10, 0x09, 0x16},
    {1, 1, 0x20, 0x03, 0x2C},
    {1, -1, 0x40, 0x06, 0x49},
    {-1, -1, 0x80, 0x0C, 0x83},
}};

double Pavement::squares(double x, double z) const {
  const PavementCell cell{static_cast<std::int64_t>(std::floor(x)),
                          static_cast<std::int64_t>(std::floor(z))};
  const int t = static_cast<int>(tiles);
  const int n = static_cast<int>(pattern);
  const unsigned word =
      row == nullptr ? 0x0F : word_of(*row, pavement_bits_4, cell.of_squares(t, n));
  const double a = 2 * (x - std::floor(x)) - 1;
  const double b = 2 * (z - std::floor(z)) - 1;

  const int bend = ways(form, 4);
  for (const SquareCorner& c : square_corners) {
    if (bend == 3 || (word & c.bent) != c.bent) continue;
    const double u = c.x * a;
    const double v = c.z * b;
    if (bend == 0) return std::max({-u, -v, std::min(u, v)});
    if (bend == 1) return std::min(1.0, std::abs(1 - u - v));
    return std::min(1.0, std::abs(std::sqrt((1 - u) * (1 - u) + (1 - v) * (1 - v)) - 1));
  }

  double r = 0;
  if ((word & 0x01) != 0) r = std::max(r, b);
  if ((word & 0x02) != 0) r = std::max(r, a);
  if ((word & 0x04) != 0) r = std::max(r, -b);
  if ((word & 0x08) != 0) r = std::max(r, -a);
  const int concave = ways(interior, 3);
  const int convex = ways(exterior, 3);
  for (const SquareCorner& c : square_corners) {
    const double u = c.x * a;
    const double v = c.z * b;
    if ((word & c.inner) != 0) {
      r = std::max(r, concave == 0   ? std::min(u, v)
                      : concave == 1 ? u + v - 1
                                     : 1 - std::sqrt((1 - u) * (1 - u) + (1 - v) * (1 - v)));
    }
    if ((word & c.borders) != c.borders) continue;
    if (convex == 1) r = std::max(r, std::min(1.0, u + v));
    if (convex == 2 && u >= 0 && v >= 0) {
      r = std::max(r, std::min(1.0, std::sqrt(u * u + v * v)));
    }
  }
  return r;
}

/// A place in a unit triangle (0,0), (1,0), (1/2,√3/2), and which triangle it is.
struct TrianglePlace {
  double x, z;
  PavementCell cell;

  TrianglePlace(double px, double pz) : x(px), z(pz), cell{} {
    std::int64_t i = static_cast<std::int64_t>(std::floor(x));
    std::int64_t j = static_cast<std::int64_t>(std::floor(z / root3));
    x -= static_cast<double>(i);
    z -= root3 * static_cast<double>(j);
    i *= 2;
    j *= 2;
    if (z > half_root3) {
      z -= half_root3;
      ++j;
      const bool right = x > 0.5;
      x += right ? -0.5 : 0.5;
      i += right ? 1 : -1;
    }
    if (x == 0 || z / x > root3) {
      z = half_root3 - z;
      x = 0.5 - x;
      --i;
    }
    if (x == 1 || z / (1 - x) > root3) {
      z = half_root3 - z;
      x = 1.5 - x;
      ++i;
    }
    cell = {i, j};
  }
};

/// What the parts of a triangle tell about a word's borders and corners (textures §10.2).
class TriangleValue {
 public:
  TriangleValue(unsigned word, double x, double z)
      : word_(word),
        x_(x),
        z_(z),
        left_(1 - std::abs(root3 * x - z) * root3),
        right_(1 - std::abs(root3 * (1 - x) - z) * root3),
        bottom_(1 - 2 * root3 * z),
        d1_(1 - std::abs(root3 * z + x)),
        d2_(1 - std::abs(root3 * z - x + 1)),
        d3_(1 - 2 * x) {}

  void borders() {
    if (has(0x01)) r_ = std::max(r_, left_);
    if (has(0x02)) r_ = std::max(r_, right_);
    if (has(0x04)) r_ = std::max(r_, bottom_);
  }

  void concave(int way, bool of_hexagon) {
    if ((word_ & 0x83) == 0 || (of_hexagon && has(0x4000))) apex(way);
    if ((word_ & 0x85) == 0 || (of_hexagon && has(0x2000))) left(way);
    if ((word_ & 0x86) == 0 || (of_hexagon && has(0x1000))) right(way);
  }

  void convex(int way) {
    const double u = x_ - 0.5;
    const double v = z_ - half_root3 / 3;
    if (way == 2) {
      if ((has(0x03) && d1_ <= 0 && d2_ <= 0) || (has(0x06) && d2_ >= 0 && d3_ <= 0) ||
          (has(0x05) && d1_ >= 0 && d3_ >= 0)) {
        r_ = std::min(1.0, 2 * root3 * std::sqrt(u * u + v * v));
      }
    } else if (way == 1) {
      if (has(0x03) && left_ >= 0 && right_ >= 0) r_ = std::min(1.0, 2 * root3 * std::abs(v));
      if (has(0x06) && right_ >= 0 && bottom_ >= 0) {
        r_ = std::min(1.0, root3 * std::abs(root3 * u - v));
      }
      if (has(0x05) && left_ >= 0 && bottom_ >= 0) {
        r_ = std::min(1.0, root3 * std::abs(root3 * u + v));
      }
    }
  }

  void bent(int way) {
    const bool above = d1_ < 0 && d2_ < 0;
    const bool at_left = d1_ > 0 && d3_ > 0;
    const bool at_right = d3_ < 0 && d2_ > 0;
    if (has(0x120) && above) return bend(way, -2 * d1_, 0, 0);
    if (has(0x140) && at_left) return bend(way, 2 * d1_, 0.5, half_root3);
    if (has(0x210) && above) return bend(way, -2 * d2_, 1, 0);
    if (has(0x240) && at_right) return bend(way, 2 * d2_, 0.5, half_root3);
    if (has(0x410) && at_left) return bend(way, 2 * d3_, 1, 0);
    if (has(0x420) && at_right) return bend(way, -2 * d3_, 0, 0);
  }

  [[nodiscard]] double result() const { return r_; }

 private:
  [[nodiscard]] bool has(unsigned bits) const { return (word_ & bits) == bits; }
  [[nodiscard]] double distance(double x, double z) const {
    return std::sqrt((x_ - x) * (x_ - x) + (z_ - z) * (z_ - z));
  }
  void raise(double v) { r_ = std::max(r_, v); }

  void apex(int way) {
    if (way == 0) raise(1 - (half_root3 - z_) * 2 * root3);
    if (way == 1 && d1_ < 0 && d2_ < 0) {
      raise(std::min(1.5 * (1 - d1_) - 2, 1.5 * (1 - d2_) - 2));
    }
    if (way == 2) raise(1 - 3 * distance(0.5, half_root3));
  }
  void left(int way) {
    if (way == 0) raise(1 - (root3 * x_ + z_) * root3);
    if (way == 1 && d1_ > 0 && d3_ > 0) raise(std::min(1 - 1.5 * (1 - d1_), 1 - 3 * x_));
    if (way == 2) raise(1 - 3 * distance(0, 0));
  }
  void right(int way) {
    if (way == 0) raise(1 - std::abs(root3 * (x_ - 1) - z_) * root3);
    if (way == 1 && d3_ < 0 && d2_ > 0) raise(std::min(1 - 1.5 * (1 - d2_), 3 * x_ - 2));
    if (way == 2) raise(1 - 3 * distance(1, 0));
  }
  void bend(int way, double straight, double x, double z) {
    r_ = way == 1 ? std::min(1.0, straight)
                  : std::clamp(2 * root3 * (distance(x, z) - root3 / 3), 0.0, 1.0);
  }

  unsigned word_;
  double x_, z_;
  double left_, right_, bottom_;
  double d1_, d2_, d3_;
  double r_ = 0;
};

double Pavement::triangles(double px, double pz) const {
  const TrianglePlace place(px, pz);
  const int t = static_cast<int>(tiles);
  const int n = static_cast<int>(pattern);
  const bool hexagons = static_cast<int>(sides) == 6;
  unsigned word = t == 1 ? 0x07 : 0x166;
  if (row != nullptr) {
    word = hexagons ? word_of(*row, pavement_bits_6, place.cell.of_hexagons(t, n))
                    : word_of(*row, pavement_bits_3, place.cell.of_triangles(t, n));
  }
  TriangleValue value(word, place.x, place.z);
  value.borders();
  value.concave(ways(interior, 3), hexagons);
  if (!hexagons) value.convex(ways(exterior, 3));
  if (const int way = ways(form, 3); way != 0) value.bent(way);
  return value.result();
}

std::optional<std::string> check_pavement(std::span<const double> args) {
  const int sides = static_cast<int>(args[0]);
  if (sides != 3 && sides != 4 && sides != 6) return "`number_of_sides` is 3, 4 or 6";
  const int tiles = static_cast<int>(args[1]);
  const int most = sides == 6 ? 5 : 6;
  if (tiles < 1 || tiles > most) {
    return "`number_of_tiles` is 1 to " + std::to_string(most) + " for this number of sides";
  }
  const auto& table = sides == 3 ? patterns_of_3 : sides == 4 ? patterns_of_4 : patterns_of_6;
  const int patterns = table[static_cast<std::size_t>(tiles - 1)];
  const int pattern = static_cast<int>(args[2]);
  if (pattern < 1 || pattern > patterns) {
    return "`pattern` is 1 to " + std::to_string(patterns) + " for this number of tiles";
  }
  return {};
}

constexpr PatternType checked(PatternType type) {
  type.validate = &check_pavement;
  return type;
}

}  // namespace

extern constinit const PatternType pavement_pattern = checked(describe_pattern<Pavement>(
    "pavement", "Stones of several tiles each.", {.default_map = black_to_white}));

}  // namespace durer::tracer::patterns
