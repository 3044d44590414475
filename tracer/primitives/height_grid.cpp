#include "tracer/primitives/height_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <mutex>

#include "tracer/accel/lanes.h"

namespace durer::tracer {

std::shared_ptr<const HeightGrid> shared_height_grid(
    const std::shared_ptr<const scene::HeightField>& field) {
  static std::mutex mutex;
  static std::map<const scene::HeightField*, std::weak_ptr<const HeightGrid>> known;
  const std::lock_guard lock(mutex);
  // A grid holds its field, so no other can have taken the address while it lives.
  std::weak_ptr<const HeightGrid>& entry = known[field.get()];
  if (auto grid = entry.lock()) return grid;
  auto grid = std::make_shared<const HeightGrid>(field);
  entry = grid;
  return grid;
}

std::shared_ptr<const HeightGrid> raised_height_grid(const scene::HeightField& field,
                                                     std::uint16_t least) {
  auto raised = std::make_shared<scene::HeightField>(field);
  for (std::uint16_t& h : raised->heights) h = std::max(h, least);
  return std::make_shared<const HeightGrid>(std::move(raised));
}

HeightGrid::HeightGrid(std::shared_ptr<const scene::HeightField> field)
    : columns_(field->width - 1), rows_(field->height - 1), field_(std::move(field)) {
  Level cells{columns_, rows_, {}};
  cells.cells.reserve(std::size_t{columns_} * rows_);
  for (std::uint32_t j = 0; j < rows_; ++j) {
    for (std::uint32_t i = 0; i < columns_; ++i) {
      const std::uint16_t* h = &field_->heights[std::size_t{rows_ - j} * field_->width + i];
      const std::uint16_t* up = h - field_->width;
      const auto [low, high] = std::minmax({h[0], h[1], up[0], up[1]});
      cells.cells.push_back({low, high});
    }
  }
  levels_.push_back(std::move(cells));
  while (levels_.back().cells.size() > 1) {
    const Level& fine = levels_.back();
    Level coarse{(fine.columns + 1) / 2, (fine.rows + 1) / 2, {}};
    coarse.cells.assign(std::size_t{coarse.columns} * coarse.rows, {65535, 0});
    for (std::uint32_t j = 0; j < fine.rows; ++j) {
      for (std::uint32_t i = 0; i < fine.columns; ++i) {
        const Extremes e = fine.cells[std::size_t{j} * fine.columns + i];
        Extremes& sum = coarse.cells[std::size_t{j / 2} * coarse.columns + i / 2];
        sum.low = std::min(sum.low, e.low);
        sum.high = std::max(sum.high, e.high);
      }
    }
    levels_.push_back(std::move(coarse));
  }
}

double HeightGrid::height_at(double x, double z) const {
  const auto i = static_cast<std::uint32_t>(std::clamp(x, 0.0, columns_ - 1.0));
  const auto j = static_cast<std::uint32_t>(std::clamp(z, 0.0, rows_ - 1.0));
  const double s = x - i;
  const double t = z - j;
  const double y10 = height(i + 1, j);
  const double y01 = height(i, j + 1);
  if (s + t < 1) return height(i, j) + s * (y10 - height(i, j)) + t * (y01 - height(i, j));
  const double y11 = height(i + 1, j + 1);
  return y11 + (1 - s) * (y01 - y11) + (1 - t) * (y10 - y11);
}

dvec3 HeightGrid::facet_normal(std::uint32_t i, std::uint32_t j, bool far_half) const {
  const double y10 = height(i + 1, j);
  const double y01 = height(i, j + 1);
  if (!far_half) return {height(i, j) - y10, 1, height(i, j) - y01};
  const double y11 = height(i + 1, j + 1);
  return {y01 - y11, 1, y10 - y11};
}

// Up to four triangles, each of the point and two of its neighbours.
dvec3 HeightGrid::vertex_normal(std::uint32_t i, std::uint32_t j) const {
  const double y = height(i, j);
  const bool left = i > 0;
  const bool right = i < columns_;
  const bool down = j > 0;
  const bool up = j < rows_;
  const double y_left = left ? y - height(i - 1, j) : 0;
  const double y_right = right ? y - height(i + 1, j) : 0;
  const double y_down = down ? y - height(i, j - 1) : 0;
  const double y_up = up ? y - height(i, j + 1) : 0;
  // All four at once: right and below, left and below, left and above, right and above.
  using wide::Double4;
  const Double4 x{y_right, -y_left, -y_left, y_right};
  const Double4 z{-y_down, -y_down, y_up, y_up};
  const Double4 exists{right && down ? 1.0 : 0.0, left && down ? 1.0 : 0.0,
                       left && up ? 1.0 : 0.0, right && up ? 1.0 : 0.0};
  const Double4 unit = exists / wide::root_of(x * x + 1.0 + z * z);
  const auto all = [](Double4 v) { return ((v[0] + v[1]) + v[2]) + v[3]; };
  dvec3 sum(all(unit * x), all(unit), all(unit * z));
  sum = glm::normalize(sum);
  for (int k = 0; k < 3; ++k) sum[k] = std::trunc(32767 * sum[k]) / 32767;
  return sum;
}

}  // namespace durer::tracer
