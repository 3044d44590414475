#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "tracer/patterns/patterns.h"
#include "tracer/random.h"
#include "tracer/shading/atmosphere.h"

namespace durer::tracer {
namespace {

// A colour map as a pigment along x.
scene::Pigment along_x(const std::vector<scene::PigmentEntry>& entries) {
  const auto types = pattern_infos();
  const auto gradient = std::find_if(types.begin(), types.end(), [](const scene::PatternInfo* i) {
    return i->name == "gradient";
  });
  scene::Pigment p;
  p.pattern.edit().type = static_cast<std::uint32_t>(gradient - types.begin());
  p.pattern.edit().args = {1, 0, 0};
  p.entries = entries;
  return p;
}

Rainbow compile_rainbow(const scene::Rainbow& in, PigmentStore& pigments) {
  Rainbow bow;
  bow.direction = in.direction;
  bow.up = glm::normalize(in.up - glm::dot(in.up, in.direction) * in.direction);
  bow.right = glm::cross(bow.up, in.direction);
  bow.width = glm::radians(in.width_deg);
  bow.inner = glm::radians(in.angle_deg) - bow.width / 2;
  bow.arc = glm::radians(in.arc_angle_deg / 2);
  bow.falloff = glm::radians(in.falloff_angle_deg / 2);
  bow.distance = in.distance;
  bow.jitter = in.jitter;
  if (bow.jitter <= 0 && bow.width > 0) {
    constexpr double margin = 1e-6;  // for rounding
    const auto cosine = [](double angle) {
      return std::cos(std::clamp(angle, 0.0, std::numbers::pi));
    };
    bow.least_ahead = std::max(0.0, cosine(bow.inner + bow.width) - margin);
    if (bow.inner > 0) bow.most_ahead = cosine(bow.inner) + margin;
  }
  bow.colours = pigments.add(along_x(in.colours), {});
  return bow;
}

}  // namespace

Atmosphere::Atmosphere(const scene::Scene& scene) : pigments_(scene.settings) {
  const auto generator = scene.settings.resolved_noise_generator();
  for (std::size_t i = scene.fogs.size(); i-- > 0;) {
    if (std::abs(scene.fogs[i].distance) > epsilon) fogs_.emplace_back(scene.fogs[i], generator);
  }
  for (const scene::Rainbow& bow : scene.rainbows) {
    if (bow.width_deg == 0 || bow.distance == 0 || bow.colours.empty()) continue;
    rainbows_.push_back(compile_rainbow(bow, pigments_));
  }
}

/// One rainbow before something at `depth`; false where it is not seen.
bool Atmosphere::band(const Rainbow& bow, dvec3 d, double depth, std::uint32_t& noise,
                      Veil& out) const {
  const double ahead = glm::dot(d, bow.direction);
  if (ahead < bow.least_ahead || ahead > bow.most_ahead) return false;
  const double x = glm::dot(d, bow.right);
  const double y = glm::dot(d, bow.up);
  const double length = std::hypot(x, y);
  const double round = std::acos(length > 0 ? std::clamp(y / length, -1.0, 1.0) : y);
  if (round > bow.arc) return false;
  double i = (std::acos(std::min(ahead, 1.0)) - bow.inner) / bow.width;
  if (bow.jitter > 0) i += (2.0 * random_unit(noise) - 1) * bow.jitter;
  if (!(i >= 0 && i <= 1 - epsilon)) return false;
  const Colour c = pigments_.at(bow.colours, {i, 0, 0});
  double fade = 0;
  if (round > bow.falloff && bow.arc > bow.falloff) {
    const double z = (round - bow.falloff) / (bow.arc - bow.falloff);
    fade = z * z * (3 - 2 * z);
  }
  const double t = c.transmit;
  const auto k =
      static_cast<float>(std::max(std::exp(-depth / bow.distance), fade * (1 - t) + t));
  const float shown = 1 - k;
  const float filtered = shown * c.filter;
  out.glow = shown * c.rgb;
  out.through = k * (1 - filtered + filtered * c.rgb);
  out.transmittance = k * c.transmit;
  return true;
}

Veil Atmosphere::rainbow(const Ray& ray, double depth, std::uint32_t& noise) const {
  Veil sum{vec3(0.0F), vec3(0.0F), 1};
  int seen = 0;
  for (const Rainbow& bow : rainbows_) {
    Veil one;
    if (!band(bow, ray.d, depth, noise, one)) continue;
    ++seen;
    sum.glow += one.glow;
    sum.through += one.through;
    sum.transmittance *= one.transmittance;
  }
  if (seen == 0) return {};
  const auto n = static_cast<float>(seen);
  return {sum.glow / n, sum.through / n, sum.transmittance};
}

}  // namespace durer::tracer
