// Light of lamps that media scatter along a ray (participating-and-global §1.10).
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "tracer/transport/media.h"

namespace durer::tracer {

// Light of all lamps that shine on points of the ray, at `t`, by their directions. Lamp by lamp:
// what comes of one point does not wait for what comes of another.
void MediaIntegrator::add_scattered(const double* t, std::span<const dvec3> points,
                                    Matter* matter) {
  constexpr std::size_t most = MediaStore::most_points;
  std::array<std::size_t, most> lit;
  std::array<Incidence, most> in;
  std::array<vec3, most> sum{};
  for (std::size_t k = 0; k < scratch_.lamp_spans.size(); ++k) {
    const LampSpan& span = scratch_.lamp_spans[k];
    const Light& light = scene_.lights[span.light];
    std::size_t count = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (t[i] < span.from || t[i] > span.to || matter[i].scattering == vec3(0.0F)) continue;
      lit[count] = i;
      in[count++] = incidence(light, points[i]);
    }
    for (std::size_t j = 0; j < count; ++j) {
      if (dark(in[j].colour)) continue;
      const vec3 light_there = arriving(k, light, in[j], points[lit[j]]);
      if (dark(light_there)) continue;
      sum[lit[j]] += static_cast<float>(mean_phase(glm::dot(ray_.d, in[j].l))) * light_there;
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    matter[i].emission += matter[i].scattering * sum[i];
  }
}

// The oracle takes the mean of all media, whether they scatter or not.
double MediaIntegrator::mean_phase(double cosine) const {
  if (isotropic_) return 1;
  double factor = 0;
  for (std::uint32_t i = first_; i < end_; ++i) factor += phase_factor(media(i), cosine);
  return factor / (end_ - first_);
}

vec3 MediaIntegrator::arriving(std::size_t index, const Light& light, const Incidence& in,
                               dvec3 p) {
  using Casters = LampSpan::Casters;
  const LampSpan& span = scratch_.lamp_spans[index];
  if (span.casters == Casters::unknown) find_casters(index, light);
  if (span.casters == Casters::none) return in.colour;
  const Tracer::Receiver receiver{setting_.gathering, collects_};
  if (span.casters == Casters::many) {
    return tracer_.shadowed(light, in, p, setting_.inside, receiver);
  }
  return tracer_.shadowed_by(scratch_.lamp_casters[index], light, in, p, setting_.inside, receiver);
}

// Shadow rays from one ray to one lamp lie in a triangle. Mostly nothing is in there.
void MediaIntegrator::find_casters(std::size_t index, const Light& light) {
  constexpr int worthwhile = 8;  // shadow rays that cost as much
  LampSpan& span = scratch_.lamp_spans[index];
  span.casters = LampSpan::Casters::many;
  if (leader_->method != 3 && leader_->intervals * leader_->min_samples < worthwhile) return;
  if (light.has_area && !setting_.gathering) return;
  if (scratch_.lamp_casters.size() <= index) scratch_.lamp_casters.resize(index + 1);
  std::vector<Caster>& casters = scratch_.lamp_casters[index];
  if (!tracer_.few_casters(light, ray_, span.from, last_sample(span), casters)) return;
  span.casters = casters.empty() ? LampSpan::Casters::none : LampSpan::Casters::few;
}

// The end of a span or, if that is the surface where the ray ends, a place before that which no
// sample of method 3 is beyond: so that the surface is no caster.
double MediaIntegrator::last_sample(const LampSpan& span) const {
  if (leader_->method != 3 || span.to < length_) return span.to;
  const auto parts = static_cast<int>(scratch_.lit_parts.size());
  const double last_interval = (span.to - span.from) / std::max(leader_->intervals, parts);
  return span.to - last_interval * left_out();
}

// Finds all that could stand between a piece of a ray and a lamp.
bool Tracer::few_casters(const Light& light, const Ray& ray, double from, double to,
                         std::vector<Caster>& out) const {
  if (light.parallel || light.projector != scene::none) return false;
  if (light.dimmed_by_air && dims()) return false;
  return scene_->geometry.casters(Sheet({light.position, ray.at(from), ray.at(to)}), out);
}

// The same as `shadowed`, where only `casters` can be in the way of a lamp that is a point.
vec3 Tracer::shadowed_by(std::span<Caster> casters, const Light& light, const Incidence& in,
                         dvec3 p, const Containment& inside, Receiver receiver) {
  if (in.distance <= 2 * t_shadow) return in.colour;
  const Geometry::Way way = scene_->geometry.way_between(
      casters, {p, in.l}, t_shadow, in.distance - t_shadow, *scratch_->geometry);
  if (way == Geometry::Way::unknown) return shadowed(light, in, p, inside, receiver);
  ++scratch_->rays;
  return way == Geometry::Way::blocked && quality_.shadows ? vec3(0.0F) : in.colour;
}

}  // namespace durer::tracer
