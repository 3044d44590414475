// Surfaces as scattering functions (docs/path-tracing.md).
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "tracer/shading/spectrum.h"
#include "tracer/transport/directions.h"
#include "tracer/transport/layers.h"
#include "tracer/transport/path_tracer.h"
#include "tracer/transport/texture_parts.h"

namespace durer::tracer {
namespace {

constexpr double pi = std::numbers::pi;

// A chance should not depend on hues that the eye hardly sees: plain means.
double size_of(vec3 c) { return (std::abs(c.x) + std::abs(c.y) + std::abs(c.z)) / 3.0; }

}  // namespace

// Of several textures in one place, one is drawn.
PathTracer::View PathTracer::see(const Hit& hit, dvec3 d) {
  Tracer::Look look = tracer_.look(hit, d);
  if (look.blend.count > 1) {
    Draw draw{random_->next()};
    std::uint32_t chosen = 0;
    for (std::uint32_t i = 0; i < look.blend.count; ++i) {
      if (draw.take(look.blend.parts[i].weight)) chosen = i;
    }
    tracer_.dress(look.view, look, hit, look.blend.parts[chosen].texture);
  }
  while (look.view.texture->patterned()) {
    Draw draw{random_->next()};
    View chosen = look.view;
    tracer_.for_parts(look.view, [&](const View& part, float weight) {
      if (draw.take(weight)) chosen = part;
    });
    if (draw.own == 0) break;
    look.view = chosen;
  }
  return look.view;
}

vec3 PathTracer::glow(const View& view, const Containment& inside) const {
  vec3 sum(0.0F);
  (void)tracer_.walk_layers(view, 0.0F, [&](const LayerPoint& layer, const auto& above) {
    const Finish& f = *layer.finish;
    sum += above.through * layer.pigment * f.glow_pigment * layer.opacity;
    return f.conserve_energy ? tracer_.reflectivity_of(view, inside, layer).rho : vec3(0.0F);
  });
  return sum;
}

void PathTracer::survey(Vertex& vertex, const Path& path) {
  const View& view = *vertex.view;
  coats_.clear();
  vertex.layers = tracer_.walk_layers(view, 0.0F, [&](const LayerPoint& layer, const auto& above) {
    const Finish& f = *layer.finish;
    vertex.glow += above.through * layer.pigment * f.glow_pigment * layer.opacity;
    Coat coat{layer, above.through};
    if (f.reflects) coat.rho = tracer_.reflectivity_of(view, path.inside, layer).rho;
    coats_.push_back(coat);
    return coat.rho;
  });
  if (vertex.layers.sigma > 0) look_beyond(vertex, path);
}

// The path behind the surface. Of white light that is dispersed, one band goes on.
void PathTracer::look_beyond(Vertex& vertex, const Path& path) {
  Path arrived = path;
  if (path.wavelength == 0) {
    const Tracer::Crossing crossing = tracer_.cross(*vertex.view, vertex.layers, path);
    if (crossing.disperses) {
      const int bands = tracer_.bands(*vertex.view, crossing);
      const Band band = spectral_band(static_cast<int>(random_->next() * bands), bands);
      arrived.wavelength = band.wavelength;
      vertex.hue = band.hue;
    }
  }
  vertex.beyond = arrived;
  tracer_.transmit(*vertex.view, vertex.layers, vertex.beyond, vertex.step);
}

// The ways on, each with a chance near its share of the light.
void PathTracer::find_lobes(Vertex& vertex) {
  lobes_.clear();
  double total = 0;
  const auto add = [&](LobeKind kind, bool back, std::size_t coat, double share) {
    if (!(share > 0)) return;
    lobes_.push_back({kind, back, static_cast<std::uint32_t>(coat), share});
    total += share;
  };
  for (std::size_t i = 0; i < coats_.size(); ++i) {
    const Coat& coat = coats_[i];
    const Finish& f = *coat.layer.finish;
    const double dull = size_of(coat.through * coat.layer.pigment * coat.layer.opacity) * 2 /
                        (double{f.brilliance} + 1);
    const double clear = size_of(coat.through);
    const float back = vertex.view->double_illuminate ? f.diffuse : f.diffuse_back;
    add(LobeKind::diffuse, false, i, dull * double{f.diffuse});
    add(LobeKind::diffuse, true, i, dull * double{back});
    add(LobeKind::phong, false, i, clear * 2 * double{f.phong} / (double{f.phong_size} + 1));
    add(LobeKind::specular, false, i,
        clear * 4 * double{f.specular} / (double{f.specular_exponent} + 2));
  }
  vertex.scatters = total > 0;
  for (std::size_t i = 0; i < coats_.size(); ++i) {
    const Coat& coat = coats_[i];
    if (vertex.step.tir && nearly_equal(coat.layer.n, vertex.layers.top)) continue;
    add(LobeKind::mirror, false, i, size_of(coat.rho));
  }
  if (vertex.step.continues) add(LobeKind::beyond, false, 0, size_of(vertex.step.through));
  for (Lobe& lobe : lobes_) lobe.share /= total;
}

/// Light of radiance 1 from direction `d`, per steradian, that goes back along the ray: as if it
/// were a lamp's, whose colour 1 means an irradiance of pi.
vec3 PathTracer::scattered(const View& view, dvec3 d) const {
  // Bumps do not let light through.
  const bool back = glm::dot(view.g, d) < 0;
  const Tracer::Beam from_around{d, vec3(1.0F), true};
  vec3 sum(0.0F);
  for (const Coat& coat : coats_) {
    const double cosine = glm::dot(coat.layer.n, d);
    if (back != (cosine < 0)) continue;
    const bool hidden = tracer_.is_behind(view, coat.layer, d);
    if (hidden && coat.layer.finish->diffuse_back == 0) continue;
    sum += coat.through * tracer_.shade(view, coat.layer, from_around, hidden, false);
  }
  return sum / static_cast<float>(pi);
}

namespace {

struct HalfWay {
  dvec3 h{0.0};
  double cosine = 0;  // with either way
};

HalfWay half_way(dvec3 d, dvec3 l) {
  const dvec3 sum = l - d;
  const double length = glm::length(sum);
  if (length == 0) return {};
  return {sum / length, std::abs(glm::dot(d, sum)) / length};
}

}  // namespace

/// Density of what `direction` makes, over all lobes that scatter.
double PathTracer::density(const View& view, dvec3 d) const {
  double sum = 0;
  for (const Lobe& lobe : lobes_) {
    const LayerPoint& layer = coats_[lobe.coat].layer;
    const Finish& f = *layer.finish;
    switch (lobe.kind) {
      case LobeKind::diffuse: {
        const double cosine = glm::dot(layer.n, d);
        sum += lobe.share * power_density(lobe.back ? -cosine : cosine, f.brilliance);
        break;
      }
      case LobeKind::phong: {
        const dvec3 r = view.d - 2 * glm::dot(view.d, layer.n) * layer.n;
        sum += lobe.share * power_density(glm::dot(r, d), f.phong_size);
        break;
      }
      case LobeKind::specular: {
        const HalfWay half = half_way(view.d, d);
        if (half.cosine > 0) {
          sum += lobe.share * power_density(glm::dot(half.h, layer.n), f.specular_exponent) /
                 (4 * half.cosine);
        }
        break;
      }
      case LobeKind::mirror:
      case LobeKind::beyond: break;
    }
  }
  return sum;
}

dvec3 PathTracer::direction(const View& view, const Lobe& lobe) {
  const LayerPoint& layer = coats_[lobe.coat].layer;
  const Finish& f = *layer.finish;
  const dvec2 u = random_->next2();
  switch (lobe.kind) {
    case LobeKind::phong: {
      const dvec3 r = view.d - 2 * glm::dot(view.d, layer.n) * layer.n;
      return power_direction(glm::normalize(r), f.phong_size, u);
    }
    case LobeKind::specular: {
      const dvec3 h = power_direction(layer.n, f.specular_exponent, u);
      return glm::normalize(view.d - 2 * glm::dot(view.d, h) * h);
    }
    default: return power_direction(lobe.back ? -layer.n : layer.n, f.brilliance, u);
  }
}

/// The bodies that a ray from the surface in direction `d` is inside of.
Containment PathTracer::behind(const View& view, Containment inside, dvec3 d) {
  if (glm::dot(view.g, d) < 0) inside.toggle(view.interior);
  return inside;
}

}  // namespace durer::tracer
