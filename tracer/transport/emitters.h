// Where to look for light: boxes around all that glows, and the bright parts of the sky.
#pragma once

#include <cstdint>
#include <vector>

#include "base/bounds.h"
#include "base/vec.h"

namespace durer::tracer {

struct CompiledScene;

/// A direction to look for light in, and how dense such directions are, per steradian.
struct Aim {
  dvec3 d{0.0};
  double density = 0;  // 0: nowhere
};

/// The sky as a table of brightness, to choose directions from.
class BrightSky {
 public:
  BrightSky() = default;
  /// `brightness`: of the middles of `columns` times `rows` cells, row 0 around +y.
  BrightSky(std::vector<double> brightness, int columns, int rows);

  /// Brightness times steradians, all of it.
  [[nodiscard]] double power() const { return power_; }
  [[nodiscard]] Aim aim(dvec2 u) const;
  [[nodiscard]] double density(dvec3 d) const;
  /// The middle of a cell.
  [[nodiscard]] static dvec3 direction(double column, double row, int columns, int rows);

 private:
  [[nodiscard]] double cell_density(std::size_t cell) const;

  int columns_ = 0;
  int rows_ = 0;
  double power_ = 0;
  std::vector<double> sums_;  // of power, over the cells up to and with each
};

/// Proposes directions in which a point may see light. They need not hold any: a box is more than
/// what glows in it, and something may stand before it. What light there is, whoever asks finds out
/// with a ray, and weighs it by the density. Lamps are not among these; they have no surface.
class Emitters {
 public:
  struct Box {
    Bounds3 bounds;    // finite, not empty
    double light = 0;  // radiance, roughly
  };

  Emitters() = default;
  /// Boxes beyond a number that is soon looked through are joined with their neighbours.
  Emitters(std::vector<Box> boxes, BrightSky sky);

  [[nodiscard]] bool empty() const { return boxes_.empty() && sky_.power() == 0; }
  /// `pick` and `u`: random, 0…1.
  [[nodiscard]] Aim aim(dvec3 from, double pick, dvec2 u) const;
  /// Density of what `aim` proposes.
  [[nodiscard]] double density(dvec3 from, dvec3 d) const;

  [[nodiscard]] const std::vector<Box>& boxes() const { return boxes_; }

 private:
  [[nodiscard]] double with_sky(double boxes) const;

  std::vector<Box> boxes_;
  BrightSky sky_;
};

/// All that glows in a scene whose surfaces are compiled.
[[nodiscard]] Emitters find_emitters(const CompiledScene& scene);

}  // namespace durer::tracer
