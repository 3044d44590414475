// A function at a point and a step away from it along each axis, as normals of surfaces need it.
#pragma once

#include <array>

#include "base/vec.h"
#include "functions/evaluate.h"

namespace durer::functions {

/// For a function of three parameters. What does not depend on a coordinate is not computed again
/// when only that one changes; the results are those of four evaluations, bit for bit.
class Differences {
 public:
  explicit Differences(FunctionRef function);

  /// f(p), f(p.x + step, p.y, p.z), f(p.x, p.y + step, p.z), f(p.x, p.y, p.z + step).
  [[nodiscard]] std::array<double, 4> operator()(const dvec3& p, double step, Workspace& w) const;
  /// The same at eight points.
  [[nodiscard]] std::array<Pack, 4> operator()(const std::array<Pack, 3>& p, double step,
                                               Workspace& w) const;

 private:
  template <class T>
  [[nodiscard]] std::array<T, 4> evaluate(const std::array<T, 3>& p, double step,
                                          Workspace& w) const;

  // All work on one frame: the function at p and the points beside it, then the instructions that
  // depend on x, y, z at these, each on registers of its own.
  Function here_;
  std::array<Function, 3> beside_;
  Register step_;
};

}  // namespace durer::functions
