// Whose is the border between two tiles? Found by folding the plane with the same comparisons as
// POV-Ray's, which shows in whole lines of a picture: cameras look at 0 and at whole numbers.
#pragma once

#include <optional>

#include "base/vec.h"

namespace durer::tracer::patterns {

/// The remainder of a division that rounds down: 0 to b.
[[nodiscard]] double floor_mod(double a, double b);

/// The kind of tile that a point (x, z) belongs to, borders included; none for tilings of which the
/// tile beyond the border, on the side of greater x and z, says enough.
[[nodiscard]] std::optional<int> kind_by_folding(int number, dvec2 p);

/// The value on those lines of tilings 12, 13 and 14 where POV-Ray finds no tile: mirrors of the
/// pattern. None elsewhere.
[[nodiscard]] std::optional<double> value_on_mirror(int number, dvec2 p);

}  // namespace durer::tracer::patterns
