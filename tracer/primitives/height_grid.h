// Heights over a grid and the pyramid of their extremes, as rays ask for them (objects §10.11).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/bounds.h"
#include "base/ray.h"
#include "scene/height_field.h"

namespace durer::tracer {

/// Grid units: x from 0 to columns, z from 0 to rows (away from the viewer), y 0 to 65535. Cells
/// are halved by the diagonal from (i+1, j) to (i, j+1).
class HeightGrid {
 public:
  explicit HeightGrid(std::shared_ptr<const scene::HeightField> field);

  [[nodiscard]] std::uint32_t columns() const { return columns_; }
  [[nodiscard]] std::uint32_t rows() const { return rows_; }
  [[nodiscard]] double lowest() const { return levels_.back().cells[0].low; }
  [[nodiscard]] double highest() const { return levels_.back().cells[0].high; }
  [[nodiscard]] double height(std::uint32_t i, std::uint32_t j) const {
    // The field begins with the farthest row.
    return field_->heights[static_cast<std::size_t>(rows_ - j) * (columns_ + 1) + i];
  }
  /// Height of the surface over a point of the grid.
  [[nodiscard]] double height_at(double x, double z) const;
  /// Normal of one of the two triangles of a cell, upwards.
  [[nodiscard]] dvec3 facet_normal(std::uint32_t i, std::uint32_t j, bool far_half) const;
  /// The mean of the normals around a grid point, as 16-bit numbers hold it.
  [[nodiscard]] dvec3 vertex_normal(std::uint32_t i, std::uint32_t j) const;

  /// Calls f(i, j, t_in, t_out) for the cells under or over the ray within t_in…t_out in which it
  /// may meet the surface, in its order; and skip(t, below) for the pieces in between, where it is
  /// above or below all of it. Both return false to stop.
  template <typename Cell, typename Skip>
  void walk(const Ray& ray, double t_in, double t_out, Cell&& cell, Skip&& skip) const {
    const Slanted slanted{ray, 1 / ray.d.x, 1 / ray.d.z};
    descend(slanted, static_cast<std::uint32_t>(levels_.size() - 1), 0, 0, t_in, t_out, cell, skip);
  }

 private:
  struct Extremes {
    std::uint16_t low;
    std::uint16_t high;
  };
  /// Blocks of 2^level cells each way.
  struct Level {
    std::uint32_t columns;
    std::uint32_t rows;
    std::vector<Extremes> cells;
  };

  struct Slanted {
    const Ray& ray;
    double inverse_x;
    double inverse_z;
  };

  template <typename Cell, typename Skip>
  bool descend(const Slanted& slanted, std::uint32_t level, std::uint32_t i, std::uint32_t j, double t_in,
               double t_out, Cell& cell, Skip& skip) const;

  std::uint32_t columns_;
  std::uint32_t rows_;
  std::shared_ptr<const scene::HeightField> field_;
  std::vector<Level> levels_;
};

template <typename Cell, typename Skip>
bool HeightGrid::descend(const Slanted& slanted, std::uint32_t level, std::uint32_t i,
                         std::uint32_t j, double t_in, double t_out, Cell& cell,
                         Skip& skip) const {
  const Ray& ray = slanted.ray;
  for (;; --level) {
    const Level& here = levels_[level];
    if (i >= here.columns || j >= here.rows) return true;
    const Extremes e = here.cells[static_cast<std::size_t>(j) * here.columns + i];
    const double y_in = ray.o.y + t_in * ray.d.y;
    const double y_out = ray.o.y + t_out * ray.d.y;
    if (y_in > e.high && y_out > e.high) return skip(t_in, false);
    if (y_in < e.low && y_out < e.low) return skip(t_in, true);
    if (level == 0) return cell(i, j, t_in, t_out);
    // The lines between the four blocks below.
    const double size = static_cast<double>(1U << (level - 1));
    const double x_mid = (2 * i + 1) * size;
    const double z_mid = (2 * j + 1) * size;
    const double tx = (x_mid - ray.o.x) * slanted.inverse_x;
    const double tz = (z_mid - ray.o.z) * slanted.inverse_z;
    // On which side the piece begins; it changes sides at tx and tz, if these lie within.
    bool right = tx > t_in ? ray.d.x < 0 : ray.d.x > 0;
    bool far = tz > t_in ? ray.d.z < 0 : ray.d.z > 0;
    if (ray.d.x == 0) right = ray.o.x >= x_mid;
    if (ray.d.z == 0) far = ray.o.z >= z_mid;
    const bool cuts_x = ray.d.x != 0 && tx > t_in && tx < t_out;
    const bool cuts_z = ray.d.z != 0 && tz > t_in && tz < t_out;
    const bool x_first = cuts_x && !(cuts_z && tz < tx);
    const auto go = [&](double until) {
      const bool on = descend(slanted, level - 1, 2 * i + (right ? 1 : 0), 2 * j + (far ? 1 : 0),
                              t_in, until, cell, skip);
      t_in = until;
      return on;
    };
    if (cuts_x && x_first) {
      if (!go(tx)) return false;
      right = !right;
    }
    if (cuts_z) {
      if (!go(tz)) return false;
      far = !far;
    }
    if (cuts_x && !x_first) {
      if (!go(tx)) return false;
      right = !right;
    }
    i = 2 * i + (right ? 1 : 0);  // the last piece, in a turn of the loop
    j = 2 * j + (far ? 1 : 0);
  }
}

/// The grid of a field; made once, as long as anybody holds it.
[[nodiscard]] std::shared_ptr<const HeightGrid> shared_height_grid(
    const std::shared_ptr<const scene::HeightField>& field);
/// That of the same field with nothing lower than `least`.
[[nodiscard]] std::shared_ptr<const HeightGrid> raised_height_grid(const scene::HeightField& field,
                                                                   std::uint16_t least);

}  // namespace durer::tracer
