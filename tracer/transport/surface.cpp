// One surface: its layers, its reflections, and how light goes on behind it (shading §4, §5.2, §8).
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "functions/simd/inline.h"
#include "tracer/shading/spectrum.h"
#include "tracer/transport/layers.h"

namespace durer::tracer {
namespace {

float greatest_size(vec3 c) { return std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z)}); }

}  // namespace

bool refracted(dvec3 d, dvec3 normal, double eta, dvec3& out) {
  double n = glm::dot(d, normal);
  if (n <= 0) {
    n = -n;
  } else {
    normal = -normal;
  }
  const double k = 1 + eta * eta * (n * n - 1);
  if (k < 0) return false;
  out = eta * d + (eta * n - std::sqrt(k)) * normal;
  return true;
}

bool Tracer::same_direction(dvec3 a, dvec3 b) {
  const dvec3 e = glm::abs(a - b);
  return e.x < epsilon && e.y < epsilon && e.z < epsilon;
}

double Tracer::Crossing::eta(double wavelength) const {
  return disperses ? ratio.ior * index_factor(ratio.dispersion, wavelength) : ratio.ior;
}

dvec3 mirror(dvec3 d, dvec3 n, dvec3 g) {
  dvec3 r = d - 2 * glm::dot(d, n) * n;
  if (glm::dot(r, g) < 0) {
    r = glm::dot(r, n) < 0 ? d - 2 * glm::dot(d, g) * g : r - 2 * glm::dot(r, g) * g;
  }
  return glm::normalize(r);
}

Tracer::Step Tracer::surface(const View& view, Path& path) {
  Step step;
  if (is_plain(view)) {
    plain_light(view, path.inside, step.colour);
    step.left = scratch_->left_normal;
    return step;
  }
  const std::size_t first = scratch_->reflections.size();
  const LayerSum layers = sum_layers(view, path);
  step.left = scratch_->left_normal;
  step.colour = layers.colour;
  // Reflections need the path as it arrived; transmission turns it into the one behind.
  const bool see_through = quality_.transparency && layers.sigma > limits(path).adc;
  if (scratch_->reflections.size() == first) {
    if (see_through) transmit(view, layers, path, step);
    return step;
  }
  Path arrived = path;
  if (see_through) transmit(view, layers, path, step);
  step.colour += reflect(view, layers, arrived, first, step.tir);
  scratch_->reflections.resize(first);
  return step;
}

float Tracer::opacity(const Colour& c) const {
  if (!legacy_opacity_) return c.opacity();
  return 1 - (c.filter * std::max({c.rgb.x, c.rgb.y, c.rgb.z}) + c.transmit);
}

// A finish of which light that falls in goes elsewhere.
Finish Tracer::without_diffuse(const Finish& finish) const {
  Finish f = finish;
  f.diffuse = f.diffuse_back = 0;
  if (scene_->subsurface->settings.radiosity) f.indirect = f.indirect_back = 0;
  f.lit = f.highlights;
  return f;
}

// What one layer sends out by itself, which is `light`, and of the light that falls onto it.
DURER_INLINE vec3 Tracer::light_of(const View& view, const Path& path, const LayerPoint& layer,
                                   const vec3& through, vec3 light, LayersLight& so_far) {
  const Finish& f = *layer.finish;
  if (f.lit) {
    light += illuminate(view, path, layer, so_far.first_lit);
    if (so_far.photons) {
      if (so_far.first_lit) find_photons(view, layer.n);
      light += caustics(view, layer);
    }
    so_far.first_lit = false;
  }
  if (so_far.gathers && (f.indirect != 0 || f.indirect_back != 0)) {
    light += indirect_part(view, path, layer, through, so_far.around);
    so_far.first_lit = true;  // gathering lights other surfaces
  }
  return light;
}

Tracer::LayerSum Tracer::sum_layers(const View& view, const Path& path) {
  LayersLight so_far;
  so_far.gathers = scene_->radiosity && path.bounce < scene_->radiosity->bounces.size();
  so_far.photons = view.collects && has_caustics();
  return walk_layers(view, limits(path).adc, [&](const LayerPoint& layer, LayerSum& sum) {
    if (!quality_.lights) {
      sum.colour = layer.pigment;
      return vec3(0.0F);
    }
    const vec3 glow = layer.pigment * layer.finish->glow_pigment * layer.opacity;
    vec3 rho(0.0F);
    if (layer.finish->reflects) rho = remember_reflection(view, path, layer, sum.sigma);
    const vec3 light = scene_->subsurface && is_translucent(view, *layer.finish)
                           ? light_of_translucent(view, path, layer, sum.through, glow, so_far)
                           : light_of(view, path, layer, sum.through, glow, so_far);
    sum.colour += light * sum.through;
    return rho;
  });
}

// The same where light goes below the surface: only what is left of the finish counts above.
vec3 Tracer::light_of_translucent(const View& view, const Path& path, const LayerPoint& layer,
                                  const vec3& through, vec3 glow, LayersLight& so_far) {
  glow += subsurface(view, path, layer);
  so_far.first_lit = true;  // it lights other places
  const Finish above = without_diffuse(*layer.finish);
  LayerPoint rest = layer;
  rest.finish = &above;
  return light_of(view, path, rest, through, glow, so_far);
}

// The normal of a layer. Afterwards `seen` has it as patterns of the layer see it, which is inside
// of the patterned textures around it (textures §13.1, §13.5).
dvec3 Tracer::bend(const View& view, const LayerProgram& layer, SurfaceView& seen) const {
  const NormalStore& normals = scene_->textures.normals();
  if (view.places == 0 && view.frame_count == 0) {
    seen.n = normals.at(layer.normal, view.q, view.g, &seen);
    return glm::normalize(seen.n);
  }
  dvec3 n = view.g;
  for (std::uint32_t i = 0; i < view.places; ++i) {
    n = glm::normalize(view.spaces[i]->forward.covector(n));
  }
  for (std::uint32_t i = 0; i < view.frame_count; ++i) n = view.frames[i]->enter(n);
  n = normals.at(layer.normal, view.q, n, &seen);
  const auto back_to_world = [&view](dvec3 inner) {
    for (std::uint32_t i = view.places; i-- > 0;) {
      inner = glm::normalize(view.spaces[i]->backward.covector(inner));
    }
    return inner;
  };
  seen.n = view.frame_count == 0 ? back_to_world(n) : n;
  // Of unit length here, but not after a patterned texture that keeps lengths: as the oracle has it.
  n = glm::normalize(n);
  for (std::uint32_t i = view.frame_count; i-- > 0;) n = view.frames[i]->leave(n);
  return back_to_world(n);
}

Reflectivity Tracer::reflectivity_of(const View& view, const Containment& inside,
                                     const LayerPoint& layer) const {
  const Finish& f = *layer.finish;
  const double cosi = -glm::dot(view.d, layer.n);
  const double n = f.fresnel ? fresnel_index(scene_->interiors, view.interior, inside) : 1;
  return reflectivity(f, cosi, n, layer.pigment);
}

vec3 Tracer::remember_reflection(const View& view, const Path& path, const LayerPoint& layer,
                                 float sigma) {
  const Reflectivity r = reflectivity_of(view, path.inside, layer);
  if (quality_.reflection && r.rho != vec3(0.0F)) {
    // Made in place, and read member by member: as a whole it would be read before it is written.
    Reflection& kept = scratch_->reflections.emplace_back();
    kept.finish = layer.finish;
    kept.n = layer.n;
    kept.rho = r.rho;
    kept.weight = path.weight * sigma * r.weight;
  }
  return r.rho;
}

vec3 Tracer::attenuation(const View& view, const Path& path) const {
  const Interior& body = scene_->interiors[view.interior];
  vec3 a(body.refraction);
  if (fades(body) && path.inside.contains(view.interior)) a *= fade(body, view.depth);
  return a;
}

// The ray that a surface sends back by total internal reflection.
Path Tracer::inward(const View& view, const Path& path, dvec3 n, float weight) {
  Path back = path;
  back.ray = {view.p, mirror(view.d, n, view.g)};
  back.weight = weight;
  back.reflected = true;
  return back;
}

// What total internal reflection towards `r` is tinted with: the film of the outermost layer.
vec3 Tracer::film_tint(const View& view, dvec3 n, dvec3 r) const {
  const TextureStore& textures = scene_->textures;
  const Finish& f = textures.finish(textures.layer(view.texture->first_layer));
  if (!(f.irid > 0)) return vec3(1.0F);
  return iridescence(f, view.p, glm::dot(n, r), glm::dot(n, view.d));
}

// The path as it crosses a surface, before it is bent.
Tracer::Crossing Tracer::cross(const View& view, const LayerSum& layers, const Path& path) const {
  Crossing c;
  c.next.inside = path.inside;
  c.ratio = pass(scene_->interiors, view.interior, c.next.inside);
  c.next.ray = {view.p, view.d};
  c.next.weight = path.weight * greatest_size(layers.through);
  c.next.level = path.level;
  c.next.reflected = path.reflected;
  c.next.wavelength = path.wavelength;
  c.next.bounce = path.bounce;
  c.next.transmitted = true;
  c.disperses = !is_one(c.ratio.dispersion);
  c.straight = is_one(c.ratio.ior) && !c.disperses;
  return c;
}

// Bends light of one wavelength; `eta` is n before over n behind the surface. Where it is totally
// reflected instead, `next` is the reflected path, and the film of the surface tints it.
std::optional<vec3> Tracer::bend_path(const View& view, const LayerSum& layers, const Path& path,
                                      double eta, Path& next) const {
  if (refracted(view.d, layers.top, eta, next.ray.d)) return std::nullopt;
  next = inward(view, path, layers.top, next.weight);
  return film_tint(view, layers.top, next.ray.d);
}

void Tracer::transmit(const View& view, const LayerSum& layers, Path& path, Step& step) {
  const vec3 a = attenuation(view, path);
  const IndexRatio ratio = index_ratio(scene_->interiors, view.interior, path.inside);
  const bool disperses = !is_one(ratio.dispersion);
  step.through = a * layers.through;
  step.transmittance = grey(a) * layers.sigma;
  step.straight = is_one(ratio.ior) && !disperses;
  if (disperses && path.wavelength == 0) {
    const Radiance r = disperse(view, layers, path, cross(view, layers, path));
    step.colour += step.through * r.colour;
    step.transmittance *= r.transmittance;
    return;
  }
  // The same as `cross` and `bend_path`, but the path is not copied: this is done at every surface.
  step.continues = true;
  path.weight *= greatest_size(layers.through);
  path.ray = {view.p, view.d};
  const double eta =
      disperses ? ratio.ior * index_factor(ratio.dispersion, path.wavelength) : ratio.ior;
  if (step.straight || refracted(view.d, layers.top, eta, path.ray.d)) {
    path.inside.toggle(view.interior);
    path.reach = no_hit_depth;
    path.first = nullptr;
    path.transmitted = true;
    return;
  }
  path.ray.d = mirror(view.d, layers.top, view.g);
  path.reflected = true;
  step.through = a * film_tint(view, layers.top, path.ray.d);
  step.transmittance = 0;
  step.tir = true;
}

// How many bands light is split into.
int Tracer::bands(const View& view, const Crossing& c) const {
  const auto samples_of = [&](std::uint32_t id) {
    return scene_->interiors[id].dispersion_samples;
  };
  const int samples = samples_of(view.interior);
  if (c.next.inside.empty()) return samples;
  return std::max(samples, samples_of(c.next.inside.innermost()));
}

// White light splits into bands; each goes on as light of one wavelength.
Radiance Tracer::disperse(const View& view, const LayerSum& layers, const Path& path,
                          const Crossing& c) {
  const int samples = bands(view, c);
  Radiance sum;
  for (int i = 0; i < samples; ++i) {
    const Band band = spectral_band(i, samples);
    Path ray = c.next;
    vec3 tint = band.hue;
    if (const auto film = bend_path(view, layers, path, c.eta(band.wavelength), ray)) tint *= *film;
    ray.wavelength = band.wavelength;
    const Radiance r = trace(std::move(ray));
    sum.colour += tint * r.colour;
    sum.transmittance += r.transmittance;
  }
  const auto n = static_cast<float>(samples);
  return {sum.colour / n, sum.transmittance / n};
}

// The last reflection uses `arrived` up.
vec3 Tracer::reflect(const View& view, const LayerSum& layers, Path& arrived,
                     std::size_t first, bool tir) {
  vec3 sum(0.0F);
  const std::size_t end = scratch_->reflections.size();
  for (std::size_t i = first; i < end; ++i) {
    // Copies: tracing moves the stack.
    const Finish& f = *scratch_->reflections[i].finish;
    const dvec3 n = scratch_->reflections[i].n;
    const vec3 rho = scratch_->reflections[i].rho;
    if (tir && same_direction(n, layers.top)) continue;
    const dvec3 d = mirror(view.d, n, view.g);
    const auto along = [&](Path& path) {
      path.ray = {view.p, d};
      path.weight = scratch_->reflections[i].weight;
      path.reflected = true;
      return trace(std::move(path)).colour;
    };
    Path path;
    vec3 light = i + 1 < end ? along(path = arrived) : along(arrived);
    if (f.irid > 0) light *= iridescence(f, view.p, glm::dot(n, d), glm::dot(n, view.d));
    if (f.reflection_power != 1) light = glm::pow(light, vec3(f.reflection_power));
    sum += rho * light;
  }
  return sum;
}

}  // namespace durer::tracer
