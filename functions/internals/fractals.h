// Noise and sums of noise octaves (builtin-functions §3, §5).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "functions/internals/common.h"

namespace durer::functions::internals {

template <class T>
T signed_noise(const T& x, const T& y, const T& z, NoiseGenerator g) {
  return 2 * noise(x, y, z, g) - 1;
}
[[nodiscard]] inline NoiseGenerator generator_of(double p) {
  return static_cast<NoiseGenerator>(truncated32(p)) & 3;
}

template <class T>
T ridge_sum(const T& x, const T& y, const T& z, const double* p) {
  const double lambda = p[0];
  const double octaves = p[1];
  const double omega = p[2];
  const double offset = p[3];
  const double ridge = p[4];
  const NoiseGenerator g = generator_of(p[5]);
  const double size = max(ridge, 1 - ridge);
  const auto f = [&](double k) {
    return T(abs(noise(k * x, k * y, k * z, g) - ridge) / size - offset);
  };
  const int n = static_cast<int>(truncated32(octaves));
  T value = f(1);
  double total = 1;
  double frequency = lambda;
  double weight = omega;
  for (int i = 2; i <= n; ++i) {
    value += weight * f(frequency);
    total += weight;
    frequency *= lambda;
    weight *= omega;
  }
  const double rest = octaves - n;
  if (rest != 0) {
    value += weight * rest * f(frequency);
    total += weight * rest;
  }
  return value / max(offset, 1 - offset) / total;
}

/// The octaves of ridged_mf_sum() that are finer than a box: nothing is known of them but their
/// range and how steep they can be, and that costs little.
struct RidgedTail {
  double lacunarity, offset, gain, falloff;

  /// `signal` and `sum` before the octave with noise at (x, y, z) and amplitude `amplitude`; `left`
  /// octaves follow, this one included.
  [[nodiscard]] Trend operator()(const std::array<Trend, 3>& p, const Trend& signal,
                                 const Trend& sum, double amplitude, double left,
                                 NoiseGenerator g) const {
    const Interval fall = offset - abs(Interval(-1, 1));
    const Interval octave = sqr(fall);
    const double steepest = 4 * magnitude(fall) * steepest_noise(g).slope;
    std::array<double, 3> speed{};
    std::array<double, 3> steepness{};
    Trend::Slopes slopes;
    for (std::size_t k = 0; k < 3; ++k) {
      for (const Trend& c : p) speed[k] += square(magnitude(c.slope(k)));
      speed[k] = std::sqrt(speed[k]);
      steepness[k] = magnitude(signal.slope(k));
      slopes[k] = sum.slope(k);
    }
    Interval last = signal.range();
    Interval range = sum.range();
    for (double i = 0; i < left; ++i) {
      const Interval weight = min(Interval(1), max(last * gain, Interval(0)));
      last = octave * weight;
      range += last * amplitude;
      for (std::size_t k = 0; k < 3; ++k) {
        steepness[k] = steepest * speed[k] * weight.hi + octave.hi * std::abs(gain) * steepness[k];
        const double most = std::abs(amplitude) * steepness[k];
        slopes[k] += Interval{-most, most};
        speed[k] *= std::abs(lacunarity);
      }
      amplitude *= falloff;
    }
    return {range, slopes};
  }

 private:
  [[nodiscard]] static double magnitude(const Interval& v) {
    return std::max(std::abs(v.lo), std::abs(v.hi));
  }
  [[nodiscard]] static double square(double v) { return v * v; }
};

/// Octave weights (lacunarity^i)^-H are computed for every call; the oracle keeps those of the
/// first call of the run for ever, which differs only in scenes with several parameter sets.
template <class T>
T ridged_mf_sum(T x, T y, T z, const double* p) {
  const double H = p[0];
  const double lacunarity = p[1];
  const double octaves = p[2];
  const double offset = p[3];
  const double gain = p[4];
  const NoiseGenerator g = generator_of(p[5]);
  const auto ridge = [&] { return T(sqr(offset - abs(signed_noise(x, y, z, g)))); };
  T signal = ridge();
  T result = signal;
  const double falloff = std::pow(lacunarity, -H);
  double weight_of_octave = 1;
  for (int i = 1; i < octaves; ++i) {
    x *= lacunarity;
    y *= lacunarity;
    z *= lacunarity;
    weight_of_octave *= falloff;
    if constexpr (std::is_same_v<T, Trend>) {
      const bool bounded = x.is_bounded() && y.is_bounded() && z.is_bounded();
      if (bounded && signal.is_bounded() && is_any_noise(x, y, z, g)) {
        const RidgedTail tail{lacunarity, offset, gain, falloff};
        return tail({x, y, z}, signal, result, weight_of_octave, octaves - i, g);
      }
    }
    const T weight = min(T(1), max(T(signal * gain), T(0)));
    signal = ridge() * weight;
    result += signal * weight_of_octave;
  }
  return result;
}

template <class T>
T hetero_mf_sum(T x, T y, T z, const double* p) {
  const double H = p[0];
  const double lacunarity = p[1];
  const double octaves = p[2];
  const double offset = p[3];
  const double power = p[4];
  const NoiseGenerator g = generator_of(p[5]);
  const auto n = [&] { return T(signed_noise(x, y, z, g) + offset); };
  const auto next_octave = [&] {
    x *= lacunarity;
    y *= lacunarity;
    z *= lacunarity;
  };
  T sum = n();
  next_octave();
  const double w = std::pow(lacunarity, -H);
  double e = w;
  const int repeats = static_cast<int>(truncated32(power));
  for (int i = 1; i < octaves; ++i) {
    T d = n() * e;
    for (int k = 0; k < repeats; ++k) d *= sum;
    sum += d;
    next_octave();
    e *= w;
  }
  const double rest = octaves - std::trunc(octaves);
  if (rest != 0) sum += rest * n() * e * sum;  // the power does not act on the partial octave
  return sum;
}

/// Applies a sum whose parameters are single numbers. Where they vary over the batch it goes lane
/// by lane, over a box there is no bound, and gradients take them as constants.
template <int octaves, class T, class Sum>
T with_uniform_parameters(const Args<T>& a, Sum sum) {
  double p[6];
  bool uniform = true;
  for (int i = 0; i < 6; ++i) uniform = is_uniform(a.p[i], p[i]) && uniform;
  p[octaves] = std::min(p[octaves], max_terms);
  if constexpr (std::is_same_v<T, Pack>) {
    if (!uniform) {
      return by_lane<6>(
          a, [&](const Args<double>& b) { return with_uniform_parameters<octaves>(b, sum); });
    }
  } else if constexpr (std::is_same_v<T, Interval>) {
    if (!uniform) return Interval::entire(true);
  } else if constexpr (std::is_same_v<T, Trend>) {
    if (!uniform) return Trend::erratic(Interval::entire(true));
  }
  return sum(a.x, a.y, a.z, p);
}

template <class T>
T f_ridge(const Args<T>& a) {
  return with_uniform_parameters<1>(a, [](const auto&... q) { return ridge_sum(q...); });
}
template <class T>
T f_ridged_mf(const Args<T>& a) {
  return with_uniform_parameters<2>(a, [](const auto&... q) { return ridged_mf_sum(q...); });
}
template <class T>
T f_hetero_mf(const Args<T>& a) {
  return with_uniform_parameters<2>(a, [](const auto&... q) { return hetero_mf_sum(q...); });
}

template <class T>
T f_noise3d(const Args<T>& a) {
  return noise(a.x, a.y, a.z, a.context.noise_generator);
}
template <class T>
T f_noise_generator(const Args<T>& a) {
  double g = 0;
  const bool uniform = is_uniform(a.p[0], g);
  if constexpr (std::is_same_v<T, Pack>) {
    if (!uniform) return by_lane<1>(a, [](const auto& b) { return f_noise_generator(b); });
  } else if constexpr (std::is_same_v<T, Interval>) {
    if (!uniform) return {0, 1, true};
  } else if constexpr (std::is_same_v<T, Trend>) {
    if (!uniform) return Trend::erratic({0, 1, true});
  }
  return noise(a.x, a.y, a.z, generator_of(g));
}
/// The back end of pattern functions; called directly it is 0.
template <class T>
T f_pattern(const Args<T>&) {
  return T(0);
}

}  // namespace durer::functions::internals
