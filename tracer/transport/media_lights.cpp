// Where lamps shine along a ray (participating-and-global §1.5).
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "tracer/transport/media.h"

namespace durer::tracer {
namespace {

constexpr double far = 1e7;

struct Span {
  double from = 0;
  double to = 0;
};

// Where a ray is inside a cone of light; which half of the double cone a root belongs to tells its
// height above the apex.
std::optional<Span> cone_span(const Light& light, const Ray& ray) {
  const double cosine = light.falloff;
  const dvec3 v = ray.o - light.position;
  const double k1 = glm::dot(ray.d, light.axis);
  const double k2 = glm::dot(v, light.axis);
  const double apart = glm::length(v);
  const bool inside = apart == 0 || k2 / apart >= cosine;
  if (k1 <= 0 && k2 < 0) return std::nullopt;
  const double c2 = cosine * cosine;
  const double a = 1 - k1 * k1 / c2;
  const double b = glm::dot(v, ray.d) - k1 * k2 / c2;
  const double c = glm::dot(v, v) - k2 * k2 / c2;
  if (a == 0) return inside ? std::optional<Span>({0, -c / b}) : std::nullopt;
  const double d = b * b - a * c;
  if (d <= epsilon) {
    if (d < -epsilon) return std::nullopt;
    return inside ? Span{0, -b / a} : Span{-b / a, far};
  }
  const double root = std::sqrt(d);
  double t1 = (-b - root) / a;
  double t2 = (-b + root) / a;
  if (t1 > t2) std::swap(t1, t2);
  const double height1 = k2 + t1 * k1;
  const double height2 = k2 + t2 * k1;
  if (height1 <= 0 && height2 <= 0) return std::nullopt;
  if (height1 > 0 && height2 > 0) return Span{t1, t2};
  if (!inside) return Span{height1 <= 0 ? t2 : t1, far};
  if (height1 > 0) return Span{0, t1};
  return Span{0, t2 <= 0 ? far : t2};
}

// Where a ray is inside the beam of a cylinder.
std::optional<Span> beam_span(const Light& light, const Ray& ray) {
  const dvec3 v = ray.o - light.position;
  const double k1 = glm::dot(ray.d, light.axis);
  const double k2 = glm::dot(v, light.axis);
  const double a = 1 - k1 * k1;
  const double b = glm::dot(v, ray.d) - k1 * k2;
  const double c = glm::dot(v, v) - k2 * k2 - light.falloff * light.falloff;
  const double d = b * b - a * c;
  if (a == 0 || d <= epsilon) return std::nullopt;
  const double root = std::sqrt(d);
  Span s{(-b - root) / a, (-b + root) / a};
  const bool before = k2 + s.from * k1 <= 0;
  const bool after = k2 + s.to * k1 <= 0;
  if (before && after) return std::nullopt;
  if (before) s.from = 0;
  if (after) s.to = (far - k2) / k1;
  return s;
}

// The whole ray, unless the lamp shines on a part of space only.
std::optional<Span> lit_span(const Light& light, const Ray& ray, double depth) {
  using Kind = scene::Light::Kind;
  switch (light.kind) {
    case Kind::spotlight: return cone_span(light, ray);
    case Kind::cylinder: return beam_span(light, ray);
    default: return Span{0, depth};
  }
}

// The parts between the ends of the spans; overlapping spans make one lit part.
void merge(std::span<const LampSpan> spans, double depth, std::vector<LitPart>& parts) {
  if (spans.empty()) {
    parts.push_back({0, depth, false});
    return;
  }
  double end = 0;
  for (const LampSpan& s : spans) {
    if (!parts.empty() && s.from <= end) {
      end = parts.back().to = std::max(end, s.to);
      continue;
    }
    if (s.from > end) parts.push_back({end, s.from, false});
    parts.push_back({s.from, s.to, true});
    end = s.to;
  }
  if (end < depth) parts.push_back({end, depth, false});
}

}  // namespace

void find_lit_parts(std::span<const Light> lights, std::span<const std::uint32_t> lamps,
                    const Ray& ray, double depth, std::vector<LampSpan>& spans,
                    std::vector<LitPart>& parts) {
  constexpr double least = 0.001;  // spans that end before are none
  for (const std::uint32_t i : lamps) {
    const Light& light = lights[i];
    if (light.shadowless || !light.media_interaction) continue;
    const std::optional<Span> s = lit_span(light, ray, depth);
    if (!s || s->from >= depth || s->to <= least) continue;
    spans.push_back({i, std::max(s->from, 0.0), std::min(s->to, depth)});
  }
  std::sort(spans.begin(), spans.end(), [](const LampSpan& a, const LampSpan& b) {
    return a.from != b.from ? a.from < b.from : a.light < b.light;
  });
  merge(spans, depth, parts);
}

}  // namespace durer::tracer
