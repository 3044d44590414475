// When samples agree well enough: the distribution of their variance (shading §2.7,
// participating-and-global §1.8).
#pragma once

namespace durer::tracer {

/// The value that a chi-square variable of `freedom` > 0 degrees of freedom exceeds with
/// `probability`: 0 for 1, infinity for 0. Relative accuracy 1e-10.
[[nodiscard]] double chi_square_exceeded(double probability, int freedom);

}  // namespace durer::tracer
