#include "tracer/lights/light.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace durer::tracer {
namespace {

using Kind = scene::Light::Kind;

// 0 below lo, 1 from hi on, a smooth cubic between.
double smooth_step(double lo, double hi, double x) {
  if (x < lo) return 0;
  if (x >= hi) return 1;
  const double y = (x - lo) / (hi - lo);
  return y * y * (3 - 2 * y);
}

double tightened(const Light& light, double x) {
  return light.tightness == 0 ? 1 : std::pow(x, light.tightness);
}

// The cone of a spotlight; the edge is smooth in cosines, not in angles.
double cone(const Light& light, double cosine) {
  if (cosine <= 0) return 0;
  double a = tightened(light, cosine);
  if (light.radius > 0 && cosine < light.radius) {
    a *= smooth_step(light.falloff, light.radius, cosine);
  }
  return a;
}

// The beam of a cylinder, which begins at the lamp.
double beam(const Light& light, dvec3 p) {
  const dvec3 way = p - light.position;
  const double along = glm::dot(way, light.axis);
  if (along <= 0) return 0;
  const double aside = glm::length(way - along * light.axis);
  if (aside >= light.falloff) return 0;
  const double x = 1 - aside / light.falloff;
  double a = tightened(light, x);
  if (light.radius > 0 && aside > light.radius) {
    a *= smooth_step(0, 1 - light.radius / light.falloff, x);
  }
  return a;
}

}  // namespace

dvec3 axis_from(const Light& light, dvec3 position) {
  const dvec3 way = light.point_at - position;
  const double length = glm::length(way);
  return length > 0 ? way / length : light.axis;
}

Light compile_light(const scene::Light& in, bool areas) {
  Light light;
  light.kind = in.kind;
  light.position = in.position;
  light.point_at = in.point_at;
  light.axis = axis_from(light, in.position);
  light.colour = in.colour;
  light.parallel = in.parallel;
  light.shadowless = in.shadowless;
  light.dimmed_by_air = in.media_attenuation && in.media_interaction;
  light.has_area = in.has_area && areas;
  light.area = in.area;
  const bool spot = in.kind == Kind::spotlight;
  light.radius = spot ? std::cos(glm::radians(in.radius_deg)) : in.radius_deg;
  light.falloff = spot ? std::cos(glm::radians(in.falloff_deg)) : in.falloff_deg;
  light.tightness = in.tightness;
  light.fade_distance = in.fade_distance;
  light.fade_power = in.fade_power;
  light.weakened = in.kind != Kind::point || in.fade_power > 0;
  light.plain = !light.has_area && !in.shadowless;
  light.media_interaction = in.media_interaction;
  light.photons = in.photons;
  return light;
}

Reach reach_of(const Light& light) {
  Reach reach{light.position, light.axis, 0, false};
  const bool spread = light.has_area && light.area.illumination;
  if (light.kind != Kind::spotlight || light.parallel || spread) return reach;
  reach.bounded = true;
  constexpr double margin = 1e-9;
  if (light.radius <= 0) return reach;  // no edge: everything before the lamp
  const double widest = std::max(0.0, std::min(light.radius, light.falloff) - margin);
  reach.cosine2 = widest * widest;
  return reach;
}

double attenuation(const Light& light, const Incidence& in, dvec3 p) {
  double a = 1;
  if (light.kind == Kind::spotlight) {
    const double cosine = glm::dot(in.l, light.axis);
    a = cone(light, in.distance > 0 ? -cosine : cosine);
  } else if (light.kind == Kind::cylinder) {
    a = beam(light, p);
  }
  if (a > 0 && light.fade_power > 0 && std::abs(light.fade_distance) > epsilon) {
    a *= 2 / (1 + std::pow(in.distance / light.fade_distance, light.fade_power));
  }
  return a;
}

}  // namespace durer::tracer
