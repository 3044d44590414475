#include "tracer/primitives/height_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <mutex>

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
  dvec3 sum(0.0);
  const auto add = [&](bool has_x, double y_x, double dx, bool has_z, double y_z, double dz) {
    if (has_x && has_z) sum += glm::normalize(dvec3(dx * (y - y_x), 1, dz * (y - y_z)));
  };
  const double y_left = left ? height(i - 1, j) : 0;
  const double y_right = right ? height(i + 1, j) : 0;
  const double y_down = down ? height(i, j - 1) : 0;
  const double y_up = up ? height(i, j + 1) : 0;
  add(right, y_right, 1, down, y_down, -1);
  add(left, y_left, -1, down, y_down, -1);
  add(left, y_left, -1, up, y_up, 1);
  add(right, y_right, 1, up, y_up, 1);
  sum = glm::normalize(sum);
  for (int k = 0; k < 3; ++k) sum[k] = std::trunc(32767 * sum[k]) / 32767;
  return sum;
}

}  // namespace durer::tracer
