#pragma once

#include <cstdint>
#include <vector>

namespace durer::tracer {

/// What a crossing does to the inside of its primitive, seen along the ray.
enum class Side : std::uint8_t {
  enter,
  exit,
  sheet,  // a surface with the same side of matter before and behind it
};

/// One place where a line meets a primitive.
struct Crossing {
  double t = 0;            // along the ray
  std::uint32_t leaf = 0;  // CSG only: which leaf of the program
  std::uint32_t part = 0;  // which face, for normal()
  Side side = Side::enter;
  bool visible = true;  // false: the inside changes here, but no surface stands here (open caps)
};
using Crossings = std::vector<Crossing>;

/// The first visible crossing in a range.
struct Nearest {
  double t;
  std::uint32_t part;
};

}  // namespace durer::tracer
