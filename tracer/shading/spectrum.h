// Dispersion: white light as bands of wavelengths (shading §5.2, §5.3).
#pragma once

#include "base/vec.h"

namespace durer::tracer {

/// One of `count` equal bands of the visible range.
struct Band {
  double wavelength;  // nm, the middle
  vec3 hue;           // the bands' mean is nearly white
};
[[nodiscard]] Band spectral_band(int index, int count);

/// What the ratio of refraction indices is multiplied by at a wavelength in nm.
[[nodiscard]] double index_factor(double dispersion_ratio, double wavelength);

}  // namespace durer::tracer
