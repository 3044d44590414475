#include "tracer/shading/spectrum.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace durer::tracer {
namespace {

constexpr double first_wavelength = 380;  // nm
constexpr double visible_range = 350;     // nm

// How much red, green and blue lie below a wavelength: from 375 nm in steps of 5 nm, in units of
// 1/10000.
constexpr double table_start = 375;
constexpr double table_step = 5;
// clang-format off
constexpr std::array<std::array<short, 3>, 74> integral{{
    {0, 0, 0}, {9, 0, 38}, {29, 0, 113}, {58, 0, 222}, {94, 0, 363},
    {135, 0, 534}, {178, 0, 734}, {223, 0, 960}, {267, 0, 1210}, {308, 0, 1482},
    {344, 0, 1775}, {374, 0, 2085}, {394, 0, 2412}, {404, 0, 2753}, {404, 0, 3106},
    {404, 0, 3470}, {404, 0, 3841}, {404, 0, 4219}, {404, 0, 4600}, {404, 0, 4984},
    {404, 0, 5368}, {404, 0, 5750}, {404, 0, 6128}, {404, 0, 6500}, {404, 0, 6864},
    {404, 45, 7218}, {404, 131, 7560}, {404, 256, 7888}, {404, 417, 8200}, {404, 612, 8494},
    {404, 839, 8768}, {404, 1095, 9020}, {404, 1378, 9248}, {404, 1684, 9449}, {404, 2013, 9623},
    {404, 2360, 9767}, {404, 2724, 9878}, {404, 3102, 9956}, {404, 3492, 9997}, {404, 3891, 10000},
    {429, 4297, 10000}, {502, 4707, 10000}, {620, 5119, 10000}, {780, 5530, 10000}, {979, 5937, 10000},
    {1215, 6340, 10000}, {1483, 6733, 10000}, {1781, 7117, 10000}, {2105, 7487, 10000}, {2454, 7841, 10000},
    {2823, 8178, 10000}, {3210, 8494, 10000}, {3611, 8786, 10000}, {4024, 9054, 10000}, {4446, 9293, 10000},
    {4873, 9501, 10000}, {5302, 9677, 10000}, {5731, 9817, 10000}, {6155, 9919, 10000}, {6573, 9981, 10000},
    {6982, 10000, 10000}, {7377, 10000, 10000}, {7756, 10000, 10000}, {8116, 10000, 10000}, {8454, 10000, 10000},
    {8767, 10000, 10000}, {9052, 10000, 10000}, {9306, 10000, 10000}, {9525, 10000, 10000}, {9707, 10000, 10000},
    {9849, 10000, 10000}, {9947, 10000, 10000}, {9998, 10000, 10000}, {10000, 10000, 10000},
}};
// clang-format on

vec3 light_below(double wavelength) {
  const double last = static_cast<double>(integral.size() - 1);
  const double x = std::clamp((wavelength - table_start) / table_step, 0.0, last);
  const auto i = static_cast<std::size_t>(std::min(x, last - 1));
  const double t = x - static_cast<double>(i);
  vec3 c;
  for (int k = 0; k < 3; ++k) {
    c[k] = static_cast<float>(((1 - t) * integral[i][k] + t * integral[i + 1][k]) * 1e-4);
  }
  return c;
}

}  // namespace

Band spectral_band(int index, int count) {
  const double width = visible_range / count;
  const double middle = first_wavelength + width * (index + 0.5);
  const vec3 hue = light_below(middle + width / 2) - light_below(middle - width / 2);
  return {middle, hue * static_cast<float>(count)};
}

double index_factor(double dispersion_ratio, double wavelength) {
  constexpr double neutral = first_wavelength + visible_range / 2;
  return std::pow(dispersion_ratio, -(wavelength - neutral) / visible_range);
}

}  // namespace durer::tracer
