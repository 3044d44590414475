#include "tracer/shading/interior.h"

#include <cmath>

namespace durer::tracer {

Interior compile_interior(const scene::Interior* in, bool hollow, const scene::Finish* finish) {
  constexpr double caustics_scale = 45;  // written 0…1 becomes an exponent (shading §5.1)
  Interior out;
  out.hollow = hollow;
  if (in != nullptr) {
    if (in->ior > 0) out.ior = in->ior;
    out.dispersion = in->dispersion;
    out.dispersion_samples = in->dispersion_samples;
    out.caustics = caustics_scale * in->caustics;
    out.fade_distance = in->fade_distance;
    out.fade_power = in->fade_power;
    out.fade_colour = in->fade_colour;
    out.refraction = in->refraction;
  }
  if (finish != nullptr) {
    if (finish->ior > 0) out.ior = finish->ior;
    if (finish->caustics >= 0) out.caustics = finish->caustics;
    out.refraction = finish->refraction >= 0 ? finish->refraction : 1;
  }
  return out;
}

IndexRatio index_ratio(std::span<const Interior> interiors, std::uint32_t id,
                       const Containment& inside) {
  static constexpr Interior air;
  const Interior& body = interiors[id];
  const std::span ids = inside.ids();
  const auto ratio = [](const Interior& from, const Interior& to) {
    return IndexRatio{from.ior / to.ior, from.dispersion / to.dispersion};
  };
  if (ids.empty()) return ratio(air, body);
  if (ids.back() != id) {
    // Leaving a body that is not the innermost one is leaving an overlap: straight on.
    return inside.contains(id) ? IndexRatio{} : ratio(interiors[ids.back()], body);
  }
  if (ids.size() == 1) return ratio(body, air);
  const bool twice = inside.first(id) + 1 < ids.size();  // then it is still the innermost one
  return ratio(body, twice ? body : interiors[ids[ids.size() - 2]]);
}

IndexRatio pass(std::span<const Interior> interiors, std::uint32_t id, Containment& inside) {
  const IndexRatio ratio = index_ratio(interiors, id, inside);
  inside.toggle(id);
  return ratio;
}

double fresnel_index(std::span<const Interior> interiors, std::uint32_t id,
                     const Containment& inside) {
  const double ior = interiors[id].ior;
  if (inside.empty()) return ior;
  const double innermost = interiors[inside.innermost()].ior;
  if (!inside.contains(id)) return ior / innermost;
  return (inside.size() == 1 ? 1.0 : innermost) / ior;
}

vec3 fade(const Interior& interior, double depth) {
  constexpr double exponential = 1000;  // powers from here on mean Beer's law
  const double x = depth / interior.fade_distance;
  const vec3 k = interior.fade_colour;
  vec3 a;
  for (int i = 0; i < 3; ++i) {
    const double lost = 1.0 - k[i];
    a[i] = static_cast<float>(interior.fade_power >= exponential
                                  ? std::exp(-lost * x)
                                  : k[i] + lost / (1 + std::pow(x, interior.fade_power)));
  }
  return a;
}

}  // namespace durer::tracer
