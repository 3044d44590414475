// From the points that the language lists to the arcs of a curve (objects §10.7, §10.8).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tracer/primitives/outline.h"

namespace durer::tracer {

enum class Spline : std::uint8_t { linear, quadratic, cubic, bezier };

/// Pairs of numbers as points.
[[nodiscard]] std::vector<dvec2> points_of(std::span<const double> numbers);

/// Arcs, or what is wrong with the points.
struct Curves {
  std::vector<Arc> arcs;
  std::optional<std::string> problem;
  std::optional<std::string> doubt;
};
/// One curve after the other, each up to where it comes back to its first point.
[[nodiscard]] Curves closed_curves(Spline spline, std::span<const dvec2> points);

/// The arcs of one open curve (objects §10.7), or what is wrong with the points.
[[nodiscard]] Curves open_curve(Spline spline, std::span<const dvec2> points);

}  // namespace durer::tracer
