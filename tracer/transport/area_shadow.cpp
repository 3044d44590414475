// What stands between a point and a lamp of some extent (shading §6.6).
#include <cmath>

#include "tracer/random.h"
#include "tracer/transport/trace.h"

namespace durer::tracer {

vec3 Tracer::area_shadow(const Light& light, const Incidence& in, dvec3 p,
                         const Containment& inside, bool collects) {
  AreaShadow whole{light, in, AreaGrid(light.area, in.l), p, inside, collects};
  whole.few = few_casters(whole);
  if (whole.few && scratch_->casters.empty()) return in.colour;
  const auto samples = static_cast<std::size_t>(light.area.n1 * light.area.n2);
  scratch_->area.assign(samples, AreaSample::unknown);
  if (scratch_->area_light.size() < samples) scratch_->area_light.resize(samples);
  return area_part(whole, {0, 0, light.area.n1 - 1, light.area.n2 - 1}, 0);
}

// Finds all that could stand between a point and a lamp's area, unless that is too much.
bool Tracer::few_casters(const AreaShadow& lit) {
  const Light& light = lit.light;
  if (light.parallel || light.projector != scene::none) return false;
  if (light.dimmed_by_air && dims()) return false;
  const dvec2 reach = lit.grid.reach();
  const Shaft shaft(lit.p, light.position, reach.x * lit.grid.u_axis, reach.y * lit.grid.v_axis,
                    t_shadow);
  if (!scene_->geometry.casters(shaft, scratch_->casters)) return false;
  return !translucent_shadows_ || scratch_->casters.empty();
}

// Where a sample of a lamp's area is, as AreaGrid has it.
dvec2 Tracer::area_place(const AreaGrid& grid, int u, int v) {
  double a = u;
  double b = v;
  if (grid.area->jitter) {
    a += random_unit(scratch_->noise) - 0.5;
    b += random_unit(scratch_->noise) - 0.5;
  }
  return grid.place(a, b);
}

// The light of one sample; asked again, it answers the same. Most are lit or dark, and then one byte is
// all there is to remember: colours that come back from memory just after they were put there keep a
// processor waiting.
vec3 Tracer::area_corner(const AreaShadow& lit, int u, int v) {
  const auto place = static_cast<std::size_t>(v * lit.light.area.n1 + u);
  AreaSample& sample = scratch_->area[place];
  if (sample == AreaSample::unknown) sample = area_sample(lit, area_place(lit.grid, u, v), place);
  switch (sample) {
    case AreaSample::lit: return lit.centre.colour;
    case AreaSample::dark: return vec3(0.0F);
    default: return scratch_->area_light[place];
  }
}

AreaSample Tracer::area_sample(const AreaShadow& lit, dvec2 place, std::size_t number) {
  Incidence in = direction_to(lit.light, lit.grid.offset(place), lit.p);
  in.colour = lit.centre.colour;
  if (!lit.few || in.distance <= 2 * t_shadow) {
    scratch_->area_light[number] = point_shadow(lit.light, in, lit.p, lit.inside, lit.collects);
    return AreaSample::dimmed;
  }
  ++scratch_->rays;
  const bool blocked =
      scene_->geometry.occluded_by(scratch_->casters, {lit.p, in.l}, t_shadow,
                                   in.distance - t_shadow, *scratch_->geometry);
  return blocked ? AreaSample::dark : AreaSample::lit;
}

// The mean of a rectangle's corners; where they differ, of its quarters. So samples weigh more the
// finer the division around them is, as in the oracle.
vec3 Tracer::area_part(const AreaShadow& lit, const AreaPart& r, int level) {
  const vec3 a = area_corner(lit, r.u1, r.v1);
  const vec3 b = area_corner(lit, r.u2, r.v1);
  const vec3 c = area_corner(lit, r.u1, r.v2);
  const vec3 d = area_corner(lit, r.u2, r.v2);
  const vec3 mean = (a + b + c + d) * 0.25F;
  if (r.u2 - r.u1 <= 1 && r.v2 - r.v1 <= 1) return mean;
  const auto differ = [](vec3 p, vec3 q) {
    const vec3 e = p - q;
    return std::abs(e.x) + std::abs(e.y) + std::abs(e.z) > 0.1F;
  };
  if (level >= lit.light.area.adaptive && !differ(a, b) && !differ(b, d) && !differ(d, c) &&
      !differ(c, a)) {
    return mean;
  }
  const int u_low = (r.u1 + r.u2) / 2;
  const int v_low = (r.v1 + r.v2) / 2;
  const int u_high = (r.u1 + r.u2 + 1) / 2;
  const int v_high = (r.v1 + r.v2 + 1) / 2;
  vec3 sum = area_part(lit, {r.u1, r.v1, u_low, v_low}, level + 1);
  sum += area_part(lit, {u_high, r.v1, r.u2, v_low}, level + 1);
  sum += area_part(lit, {r.u1, v_high, u_low, r.v2}, level + 1);
  sum += area_part(lit, {u_high, v_high, r.u2, r.v2}, level + 1);
  return sum * 0.25F;
}

}  // namespace durer::tracer
