#include "cli/window.h"

#include <fmt/format.h>

namespace durer::cli {
namespace {

struct Range {
  int first;
  int end;
};

std::optional<Range> range_of(const std::optional<double>& start, const std::optional<double>& end,
                              int size, std::string_view what, std::string& problem) {
  Range r{0, size};
  if (start) r.first = static_cast<int>(*start < 1 ? *start * size : *start - 1);
  if (end) r.end = static_cast<int>(*end <= 1 ? *end * size : *end);
  if (r.first >= 0 && r.first < r.end && r.end <= size) return r;
  problem = fmt::format("{}s {} to {} are not in a picture of {}", what, r.first + 1, r.end, size);
  return std::nullopt;
}

}  // namespace

std::optional<Window> window_of(const Settings& s, std::string& problem) {
  const auto columns = range_of(s.start_column, s.end_column, s.width, "column", problem);
  if (!columns) return std::nullopt;
  const auto rows = range_of(s.start_row, s.end_row, s.height, "row", problem);
  if (!rows) return std::nullopt;
  return Window{columns->first, columns->end, rows->first, rows->end};
}

void blacken_outside(image::Image& image, const Window& w) {
  for (int y = 0; y < image.height; ++y) {
    const bool row_inside = y >= w.first_row && y < w.end_row;
    if (row_inside && w.first_column <= 0 && w.end_column >= image.width) continue;
    for (int x = 0; x < image.width; ++x) {
      if (row_inside && x >= w.first_column && x < w.end_column) continue;
      const auto pixel = image.at(x, y);
      pixel[0] = pixel[1] = pixel[2] = 0;
      pixel[3] = 1;
    }
  }
}

}  // namespace durer::cli
