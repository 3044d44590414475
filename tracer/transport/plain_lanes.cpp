#include "tracer/transport/plain_lanes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "tracer/accel/lanes.h"
#include "tracer/accel/vector_lanes.h"
#include "tracer/random.h"

namespace durer::tracer {
namespace {

using wide::each_bit;
using Mask = PlainPoints::Mask;

template <class Doubles>
using Vector = std::array<Doubles, 3>;

template <class Doubles>
DURER_INLINE Vector<Doubles> load(const PlainPoints::Vectors<double>& v, std::size_t first) {
  return {Doubles::load(&v[0][first]), Doubles::load(&v[1][first]), Doubles::load(&v[2][first])};
}
template <class Doubles>
DURER_INLINE Vector<Doubles> all(const dvec3& v) {
  return {Doubles::all(v.x), Doubles::all(v.y), Doubles::all(v.z)};
}
template <class Doubles>
DURER_INLINE Doubles dot(const Vector<Doubles>& a, const Vector<Doubles>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Exponent::of() for those lanes that are wanted; others are anything.
template <class Doubles>
DURER_INLINE Doubles powers(const Exponent& exponent, Doubles x, Mask wanted) {
  if (exponent.whole() == 0) {
    alignas(64) std::array<double, Doubles::size> each;
    x.store(each.data());
    each_bit(wanted, [&](std::size_t i) DURER_LAMBDA_INLINE { each[i] = exponent.of(each[i]); });
    return Doubles::load(each.data());
  }
  Doubles y = Doubles::all(1);
  for (unsigned n = exponent.whole();; x = x * x) {
    if ((n & 1U) != 0) y = y * x;
    if ((n >>= 1U) == 0) return y;
  }
}

/// What one lamp does to points of one finish (shading §4.4-4.7).
template <class Instructions>
class PlainShading {
 public:
  using Floats = typename Instructions::Floats;
  using Doubles = typename Instructions::Doubles;
  static_assert(Doubles::size == PlainPoints::group && Floats::size == PlainPoints::size);
  static constexpr Mask all_of_group = (Mask{1} << Doubles::size) - 1;

  static DURER_INLINE void aim(PlainPoints& points, const Light& lamp);

  DURER_INLINE PlainShading(PlainPoints& points, const PlainBeam& beam, Mask lit)
      : points_(points), finish_(*points.finish), beam_(beam), lit_(lit) {}
  DURER_INLINE void run();

 private:
  template <class Visit>
  DURER_INLINE void each_group(const Visit& visit) const {
    for (std::size_t first = 0; first < points_.count; first += Doubles::size) {
      if (const Mask lit = lit_ >> first & all_of_group; lit != 0) visit(first, lit);
    }
  }
  DURER_INLINE void spread();
  DURER_INLINE void shine(std::size_t first, Mask lit);
  DURER_INLINE void add_phong(std::size_t first, Mask lit);
  DURER_INLINE void add_specular(std::size_t first, Mask lit);
  DURER_INLINE void add_powers(const Exponent& exponent, float share, Doubles s, std::size_t first,
                               Mask wanted);
  DURER_INLINE void sum_up();
  DURER_INLINE void add_tints(PlainPoints::Vectors<float>& tints) const;
  DURER_INLINE void add_film();

  PlainPoints& points_;
  const Finish& finish_;
  const PlainBeam& beam_;
  Mask lit_;
  alignas(64) PlainPoints::PerPoint<float> intensity_{};
  alignas(64) PlainPoints::PerPoint<double> highlight_{};
  alignas(64) PlainPoints::Vectors<float> sums_;
};

/// See direction_to().
template <class Instructions>
void PlainShading<Instructions>::aim(PlainPoints& points, const Light& lamp) {
  const auto position = all<Doubles>(lamp.position + dvec3(0.0));
  points.facing = 0;
  points.apart = 0;
  points.shaded = 0;
  points.to_lamp.count = points.count;
  for (std::size_t first = 0; first < PlainPoints::size; first += Doubles::size) {
    const auto p = load<Doubles>(points.p(), first);
    const Vector<Doubles> way{position[0] - p[0], position[1] - p[1], position[2] - p[2]};
    Doubles distance = root(dot(way, way));
    Vector<Doubles> l{way[0] / distance, way[1] / distance, way[2] / distance};
    points.apart |= (above(distance, Doubles::all(0)) & all_of_group) << first;
    if (lamp.parallel) {
      distance = distance * (Doubles::all(-0.0) - dot(all<Doubles>(lamp.axis), l));
      l = all<Doubles>(-lamp.axis);
    }
    points.shaded |= (above(distance, Doubles::all(2 * t_shadow)) & all_of_group) << first;
    Doubles::all(t_shadow).store(&points.to_lamp.t_from[first]);
    (distance - Doubles::all(t_shadow)).store(&points.to_lamp.t_to[first]);
    const Doubles cosine = dot(load<Doubles>(points.n, first), l);
    points.facing |= (~above(Doubles::all(epsilon), cosine) & all_of_group) << first;
    for (std::size_t k = 0; k < 3; ++k) l[k].store(&points.to_lamp.d.of[k][first]);
    distance.store(&points.distance[first]);
    cosine.store(&points.cosine[first]);
  }
}

template <class Instructions>
void PlainShading<Instructions>::run() {
  spread();
  if (finish_.highlights && beam_.highlights) {
    each_group([&](std::size_t first, Mask lit) DURER_LAMBDA_INLINE { shine(first, lit); });
  }
  sum_up();
}

/// What a matt surface sends to all sides.
template <class Instructions>
void PlainShading<Instructions>::spread() {
  const float k = beam_.diffuse;
  if (!(k > 0)) return;
  each_group([&](std::size_t first, Mask lit) DURER_LAMBDA_INLINE {
    const Doubles cosine = Doubles::load(&points_.cosine[first]);
    powers(finish_.brilliance, abs(cosine), lit).narrowed(&intensity_[first]);
  });
  (Floats::load(intensity_.data()) * Floats::all(k)).store(intensity_.data());
  if (!(finish_.crand > 0)) return;
  each_bit(lit_, [&](std::size_t i) DURER_LAMBDA_INLINE {
    intensity_[i] -= random_unit(points_.noise[i]) * finish_.crand;
  });
}

/// See highlight().
template <class Instructions>
void PlainShading<Instructions>::shine(std::size_t first, Mask lit) {
  if (finish_.phong > 0) add_phong(first, lit);
  if (finish_.specular > 0) add_specular(first, lit);
}

template <class Instructions>
void PlainShading<Instructions>::add_phong(std::size_t first, Mask lit) {
  const auto d = load<Doubles>(points_.d, first);
  const auto n = load<Doubles>(points_.n, first);
  const Doubles twice = Doubles::all(2) * dot(d, n);
  const Vector<Doubles> mirrored{d[0] - twice * n[0], d[1] - twice * n[1], d[2] - twice * n[2]};
  const Doubles s = dot(mirrored, load<Doubles>(points_.l(), first));
  const double least =
      finish_.phong_size < 60 ? finish_.least_phong : std::max(finish_.least_phong, 0.0008);
  add_powers(finish_.phong_size, finish_.phong, s, first, lit & above(s, Doubles::all(least)));
}

template <class Instructions>
void PlainShading<Instructions>::add_specular(std::size_t first, Mask lit) {
  const auto d = load<Doubles>(points_.d, first);
  const auto l = load<Doubles>(points_.l(), first);
  const Doubles two = Doubles::all(2);
  const Vector<Doubles> half{(l[0] - d[0]) / two, (l[1] - d[1]) / two, (l[2] - d[2]) / two};
  const Doubles along = dot(half, load<Doubles>(points_.n, first));
  const Doubles square = dot(half, half);
  const double least = finish_.least_specular * (1 - highlight_rounding);
  lit &= above(along, Doubles::all(0)) & above(along * along, Doubles::all(least * least) * square);
  if (lit == 0) return;
  const Doubles s = along / root(square);
  lit &= above(s, Doubles::all(finish_.least_specular));
  add_powers(finish_.specular_exponent, finish_.specular, s, first, lit);
}

template <class Instructions>
void PlainShading<Instructions>::add_powers(const Exponent& exponent, float share, Doubles s,
                                            std::size_t first, Mask wanted) {
  if (wanted == 0) return;
  alignas(64) std::array<double, Doubles::size> bright;
  (Doubles::all(share) * powers(exponent, s, wanted)).store(bright.data());
  each_bit(wanted, [&](std::size_t i) DURER_LAMBDA_INLINE { highlight_[first + i] += bright[i]; });
}

/// Adds all that is sent back to what other lamps have brought.
template <class Instructions>
void PlainShading<Instructions>::sum_up() {
  const bool shines = finish_.highlights && beam_.highlights;
  alignas(64) PlainPoints::PerPoint<float> white;
  if (shines) {
    for (std::size_t first = 0; first < PlainPoints::size; first += Doubles::size) {
      Doubles::load(&highlight_[first]).narrowed(&white[first]);
    }
  }
  alignas(64) PlainPoints::Vectors<float> tints;
  if (shines && finish_.metallic > 0) add_tints(tints);
  for (std::size_t k = 0; k < 3; ++k) {
    Floats light = Floats::all(beam_.colour[static_cast<int>(k)]);
    if (beam_.shares != nullptr) light = light * Floats::load(beam_.shares);
    Floats sum = Floats::all(0);
    if (beam_.diffuse > 0) {
      sum = Floats::load(intensity_.data()) * Floats::load(points_.pigment[k].data()) * light;
    }
    if (shines) {
      Floats highlight = Floats::load(white.data());
      if (finish_.metallic > 0) highlight = highlight * Floats::load(tints[k].data());
      sum = sum + highlight * light;
    }
    sum.store(sums_[k].data());
  }
  if (finish_.irid > 0) add_film();
  const bool all_lit = lit_ == (Mask{2} << (points_.count - 1)) - 1;
  for (std::size_t k = 0; k < 3; ++k) {
    float* const lit = points_.lit[k].data();
    const float* const sum = sums_[k].data();
    if (all_lit) {
      (Floats::load(lit) + Floats::load(sum)).store(lit);
    } else {
      each_bit(lit_, [&](std::size_t i) DURER_LAMBDA_INLINE { lit[i] += sum[i]; });
    }
  }
}

template <class Instructions>
void PlainShading<Instructions>::add_tints(PlainPoints::Vectors<float>& tints) const {
  for (auto& tint : tints) tint.fill(1);
  each_bit(lit_, [&](std::size_t i) DURER_LAMBDA_INLINE {
    if (highlight_[i] == 0) return;
    const vec3 pigment(points_.pigment[0][i], points_.pigment[1][i], points_.pigment[2][i]);
    const vec3 tint = metal_tint(finish_.metallic, points_.cosine[i], pigment);
    for (std::size_t k = 0; k < 3; ++k) tints[k][i] = tint[static_cast<int>(k)];
  });
}

/// Of a film on the surface, which colours all of it.
template <class Instructions>
void PlainShading<Instructions>::add_film() {
  const auto at = [](const PlainPoints::Vectors<double>& v, std::size_t i)
                      DURER_LAMBDA_INLINE { return dvec3(v[0][i], v[1][i], v[2][i]); };
  each_bit(lit_, [&](std::size_t i) DURER_LAMBDA_INLINE {
    const double cos_view = glm::dot(at(points_.n, i), at(points_.d, i));
    const vec3 film = iridescence(finish_, at(points_.p(), i), points_.cosine[i], cos_view);
    for (std::size_t k = 0; k < 3; ++k) sums_[k][i] *= film[static_cast<int>(k)];
  });
}

template <class Instructions>
DURER_INLINE void shade_with(PlainPoints& points, const PlainBeam& beam, Mask lit) {
  PlainShading<Instructions>(points, beam, lit).run();
}

using Lanes128 = wide::LanesOf<16>;
void aim_128(PlainPoints& points, const Light& lamp) { PlainShading<Lanes128>::aim(points, lamp); }
void shade_128(PlainPoints& points, const PlainBeam& beam, Mask lit) {
  shade_with<Lanes128>(points, beam, lit);
}
#if defined(__x86_64__)
using Lanes256 = wide::LanesOf<32>;
using Lanes512 = wide::LanesOf<64>;
DURER_AVX2 void aim_256(PlainPoints& points, const Light& lamp) {
  PlainShading<Lanes256>::aim(points, lamp);
}
DURER_AVX2 void shade_256(PlainPoints& points, const PlainBeam& beam, Mask lit) {
  shade_with<Lanes256>(points, beam, lit);
}
DURER_AVX512 void aim_512(PlainPoints& points, const Light& lamp) {
  PlainShading<Lanes512>::aim(points, lamp);
}
DURER_AVX512 void shade_512(PlainPoints& points, const PlainBeam& beam, Mask lit) {
  shade_with<Lanes512>(points, beam, lit);
}
#endif

}  // namespace

std::span<const PlainLanes> plain_lanes() {
  static const std::vector<PlainLanes> versions = [] {
    std::vector<PlainLanes> all{{aim_128, shade_128}};
#if defined(__x86_64__)
    if (simd::has_avx2()) all.push_back({aim_256, shade_256});
    if (simd::has_avx512()) {
      all.push_back({aim_512, shade_512});
    }
#endif
    return all;
  }();
  return versions;
}

}  // namespace durer::tracer
