// Tilings that never repeat (textures §9.3).
#pragma once

namespace durer::tracer::patterns {

/// The value of tiling 25 (pentagons), 26 (kites and darts) or 27 (rhombs) at a point.
[[nodiscard]] double penrose_pentagons(double x, double z);
[[nodiscard]] double penrose_kites(double x, double z);
[[nodiscard]] double penrose_rhombs(double x, double z);

}  // namespace durer::tracer::patterns
