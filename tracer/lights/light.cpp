#include "tracer/lights/light.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace durer::tracer {
namespace {

// 0 below lo, 1 from hi on, a smooth cubic between.
double smooth_step(double lo, double hi, double x) {
  if (x < lo) return 0;
  if (x >= hi) return 1;
  const double y = (x - lo) / (hi - lo);
  return y * y * (3 - 2 * y);
}

// The cone of a spotlight; the edge is smooth in cosines, not in angles.
double cone(const Light& light, double cosine) {
  if (cosine <= 0) return 0;
  double a = light.tightness == 0 ? 1 : std::pow(cosine, light.tightness);
  if (light.cos_radius > 0 && cosine < light.cos_radius) {
    a *= smooth_step(light.cos_falloff, light.cos_radius, cosine);
  }
  return a;
}

double attenuation(const Light& light, dvec3 l, double distance) {
  double a = 1;
  if (light.spot) {
    const double cosine = glm::dot(l, light.axis);
    a = cone(light, distance > 0 ? -cosine : cosine);
  }
  if (a > 0 && light.fade_power > 0 && std::abs(light.fade_distance) > epsilon) {
    a *= 2 / (1 + std::pow(distance / light.fade_distance, light.fade_power));
  }
  return a;
}

}  // namespace

Light compile_light(const scene::Light& in) {
  Light light;
  light.position = in.position;
  const dvec3 axis = in.point_at - in.position;
  const double length = glm::length(axis);
  if (length > 0) light.axis = axis / length;
  light.colour = in.colour;
  light.spot = in.kind == scene::Light::Kind::spotlight;
  light.parallel = in.parallel;
  light.shadowless = in.shadowless;
  light.cos_radius = std::cos(glm::radians(in.radius_deg));
  light.cos_falloff = std::cos(glm::radians(in.falloff_deg));
  light.tightness = in.tightness;
  light.fade_distance = in.fade_distance;
  light.fade_power = in.fade_power;
  light.media_interaction = in.media_interaction;
  light.media_attenuation = in.media_attenuation;
  return light;
}

Incidence incidence(const Light& light, dvec3 p) {
  Incidence in;
  const dvec3 way = light.position - p;
  in.distance = glm::length(way);
  if (in.distance == 0) return in;  // the lamp itself: no direction, no light
  in.l = way / in.distance;
  if (light.parallel) {
    in.distance *= -glm::dot(light.axis, in.l);
    in.l = -light.axis;
  }
  in.colour = static_cast<float>(attenuation(light, in.l, in.distance)) * light.colour;
  return in;
}

}  // namespace durer::tracer
