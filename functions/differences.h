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
  /// The last three less the first, at eight points: p and `out` are arrays of eight coordinates
  /// along x, y, z. These are best kept as aligned as a Pack.
  void operator()(const std::array<const double*, 3>& p, double step,
                  const std::array<double*, 3>& out, Workspace& w) const;

 private:
  template <class T>
  void evaluate(T* registers, double step, Workspace& w) const;

  // All work on one frame: the function at p and the points beside it, then the instructions that
  // depend on x, y, z at these, each on registers of its own.
  Function here_;
  std::array<Function, 3> beside_;
  Register step_;
};

}  // namespace durer::functions
