#include "tracer/shading/media.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tracer/chi_square.h"
#include "tracer/patterns/patterns.h"

namespace durer::tracer {
namespace {

bool black(vec3 c) { return c == vec3(0.0F); }

// A rough order of what patterns cost: noise in them, or before them.
int cost(const scene::Pigment& d) {
  int sum = static_cast<int>(d.pattern->warps.size());
  if (d.pattern->function || d.pattern->pigment) sum += 4;
  const std::string_view name = pattern_types()[d.pattern->type]->name;
  for (const std::string_view cheap :
       {"spherical", "planar", "cylindrical", "boxed", "gradient", "onion", "radial"}) {
    if (name == cheap) return sum;
  }
  return sum + 4;
}

// After how much variance sampling stops (participating-and-global §1.8).
std::vector<double> thresholds(const scene::Media& m) {
  const auto n = static_cast<std::size_t>(m.max_samples);
  std::vector<double> out(n, 0.0);
  if (n == 1 || m.max_samples <= m.min_samples) return out;
  const double whole = chi_square_exceeded(m.confidence, m.max_samples - 1);
  const double scale = whole > 0 ? m.variance / whole : m.variance * epsilon;
  for (std::size_t i = 0; i < n; ++i) {
    out[i] = scale * chi_square_exceeded(m.confidence, static_cast<int>(i) + 1);
  }
  return out;
}

MediaProgram compile(const scene::Media& in) {
  MediaProgram out;
  out.emission = in.emission;
  out.scattering = in.scattering;
  out.extinction = in.absorption + static_cast<float>(in.extinction) * in.scattering;
  out.phase = in.phase;
  out.eccentricity = in.eccentricity;
  out.collects = in.collect;
  out.scatters = !black(in.scattering);
  out.dims = !black(in.absorption) || out.scatters;
  out.has_density = !in.densities.empty();
  out.constant = in.densities.empty() || !in.densities.back().pattern->exists();
  out.method = in.method;
  out.intervals = in.intervals;
  out.min_samples = in.min_samples;
  out.max_samples = in.max_samples;
  out.ratio = in.ratio;
  out.jitter = in.jitter;
  out.aa_threshold = in.aa_threshold;
  out.aa_level = in.aa_level;
  if (in.method != 3) out.thresholds = thresholds(in);
  return out;
}

}  // namespace

MediaRange MediaStore::add(std::span<const scene::Media> media, const Transform& to_world) {
  MediaRange range{static_cast<std::uint32_t>(media_.size()), 0};
  for (const scene::Media& m : media) {
    MediaProgram program = compile(m);
    std::vector<const scene::Pigment*> patterned;
    for (const scene::Pigment& d : m.densities) {
      if (d.pattern->exists()) {
        patterned.push_back(&d);
      } else {
        program.density *= d.colour.rgb;
      }
    }
    // The first one that is zero spares the others.
    std::stable_sort(patterned.begin(), patterned.end(),
                     [](const auto* a, const auto* b) { return cost(*a) < cost(*b); });
    program.varies = !patterned.empty();
    program.first_density = static_cast<std::uint32_t>(densities_.size());
    for (const scene::Pigment* d : patterned) densities_.push_back(pigments_.add(*d, to_world));
    program.end_density = static_cast<std::uint32_t>(densities_.size());
    media_.push_back(std::move(program));
  }
  range.end = static_cast<std::uint32_t>(media_.size());
  return range;
}

vec3 MediaStore::density(const MediaProgram& media, dvec3 p) const {
  vec3 product = media.density;
  for (std::uint32_t i = media.first_density; i < media.end_density && !black(product); ++i) {
    product *= pigments_.at(densities_[i], p).rgb;
  }
  return product;
}

void MediaStore::densities(const MediaProgram& media, std::span<const dvec3> points,
                           vec3* out) const {
  std::fill_n(out, points.size(), media.density);
  for (std::uint32_t i = media.first_density; i < media.end_density; ++i) {
    std::array<dvec3, most_points> left;  // where there is something so far
    std::array<std::size_t, most_points> of;
    std::size_t count = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (black(out[k])) continue;
      left[count] = points[k];
      of[count++] = k;
    }
    if (count == 0) return;
    std::array<Colour, most_points> colours;
    pigments_.at(densities_[i], std::span(left).first(count), colours.data());
    for (std::size_t k = 0; k < count; ++k) out[of[k]] *= colours[k].rgb;
  }
}

double phase_factor(const MediaProgram& media, double cosine) {
  const auto eighth_power = [](double x) {
    x *= x;
    x *= x;
    return x * x;
  };
  switch (media.phase) {
    case scene::Phase::isotropic: return 1;
    case scene::Phase::mie_hazy: return 0.576655375 * (1 + 9 * eighth_power((1 + cosine) / 2));
    case scene::Phase::mie_murky: {
      const double x = eighth_power((1 + cosine) / 2);
      return 0.495714547 * (1 + 50 * (x * x) * (x * x));
    }
    case scene::Phase::rayleigh: return 0.799372013 * (1 + cosine * cosine);
    case scene::Phase::henyey_greenstein: {
      const double g = media.eccentricity;
      const double x = 1 + g * g - 2 * g * cosine;
      return (1 - g * g) / (x * std::sqrt(x));
    }
  }
  return 1;
}

double mean_phase_factor(const MediaProgram& media) {
  // The mean of ((1 + cosine) / 2)^n over all directions is 1 / (n + 1), that of the cosine's
  // square 1/3.
  switch (media.phase) {
    case scene::Phase::mie_hazy: return 0.576655375 * (1 + 9.0 / 9);
    case scene::Phase::mie_murky: return 0.495714547 * (1 + 50.0 / 33);
    case scene::Phase::rayleigh: return 0.799372013 * (1 + 1.0 / 3);
    default: return 1;
  }
}

double phase_cosine(const MediaProgram& media, dvec2 u) {
  const double even = 2 * u.y - 1;
  // Sums of powers: one of them is chosen by its share of the mean.
  const auto forward = [&](double share, double power) {
    return u.x < share ? 2 * std::pow(u.y, 1 / (power + 1)) - 1 : even;
  };
  switch (media.phase) {
    case scene::Phase::isotropic: return even;
    case scene::Phase::mie_hazy: return forward(0.5, 8);
    case scene::Phase::mie_murky: return forward(50.0 / 83, 32);
    case scene::Phase::rayleigh: return u.x < 0.25 ? std::cbrt(even) : even;
    case scene::Phase::henyey_greenstein: {
      const double g = media.eccentricity;
      if (std::abs(g) < 1e-3) return even;
      const double x = (1 - g * g) / (1 + g * even);
      return std::clamp((1 + g * g - x * x) / (2 * g), -1.0, 1.0);
    }
  }
  return even;
}

}  // namespace durer::tracer
