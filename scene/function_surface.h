// Surfaces that functions describe, as plain data that objects share (objects §10.13, §11.8).
#pragma once

#include <array>
#include <glm/vec2.hpp>

#include "base/bounds.h"
#include "base/vec.h"
#include "functions/tape.h"

namespace durer::scene {

/// The solid outside of which a function is not looked at.
struct Container {
  enum class Kind : std::uint8_t { box, sphere };
  Kind kind = Kind::box;
  dvec3 lo{-1.0};  // box: corners, lo <= hi
  dvec3 hi{1.0};
  dvec3 centre{0.0};  // sphere
  double radius = 1;

  [[nodiscard]] Bounds3 bounds() const {
    if (kind == Kind::box) return {lo, hi};
    return {centre - radius, centre + radius};
  }
};

/// Where function = threshold inside the container; solid where it is not above.
struct Isosurface {
  functions::FunctionRef function;  // of x, y, z
  Container container;
  double threshold = 0;
  double accuracy = 0.001;  // of depths; also the step of differences for the normal
  /// Steepest slope: asked only where a function cannot be bounded over boxes.
  double max_gradient = 1.1;
  /// `evaluate`: a gradient found during rendering grows by these; 0, 0, 0: it does not.
  dvec3 evaluate{0.0};
  int max_trace = 1;
  bool open = false;  // the container's own surface is not seen
};

/// The points <x(u,v), y(u,v), z(u,v)> inside the container.
struct Parametric {
  std::array<functions::FunctionRef, 3> functions;  // of u, v
  dvec2 from{0.0};                                  // ranges of u and v, from <= to
  dvec2 to{1.0};
  Container container;
  double accuracy = 0.001;
  double max_gradient = 1;
};

}  // namespace durer::scene
