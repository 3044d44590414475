#include "tracer/film/eye.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <new>
#include <utility>

#include "base/unit.h"
#include "functions/simd/inline.h"
#include "tracer/film/sample_seed.h"
#include "tracer/sobol.h"

namespace durer::tracer {
namespace {

constexpr Pixel nothing(0.0F, 0.0F, 0.0F, 1.0F);  // transparent black

/// False if it is all the same to light whether it is in a body or in the air.
bool are_bodies_felt(const CompiledScene& s) {
  if (!s.media.empty() || !s.atmosphere.empty()) return true;
  return std::any_of(s.interiors.begin(), s.interiors.end(),
                     [](const Interior& i) { return i.ior != 1 || i.dispersion != 1 || fades(i); });
}

}  // namespace

Viewpoint::Viewpoint(const CompiledScene& s, const RenderOptions& o)
    : scene(&s), options(&o), camera(s.scene->camera), lens(*s.scene), bumps(s.scene->settings) {
  const scene::Camera& c = s.scene->camera;
  if (c.normal->pattern->exists()) bump = bumps.add(*c.normal, {});
  const bool flat = c.kind == scene::Camera::Kind::perspective;
  one_origin = camera.type->one_origin && !(flat && lens.blurs());
  bodies_matter = are_bodies_felt(s);
  if (lens.blurs()) {
    lens_right = glm::normalize(glm::cross(c.up, c.direction));
    lens_up = glm::normalize(glm::cross(c.direction, lens_right));
    lens_scale = c.lens->focal_distance / glm::length(c.direction);
  }
  if (c.kind == scene::Camera::Kind::mesh_camera) {
    turns = c.mesh->rays;
    if (c.mesh->reach > 0) reach = c.mesh->reach;
  }
  direct = turns == 1 && !lens.blurs();
  if (flat && direct && bump == scene::none) pinhole = {&c, options->width, options->height};
}

Eye::Eye(const Viewpoint& view)
    : view_(&view),
      scratch_(*view.scene),
      tracer_(*view.scene, scratch_, view.options->alpha),
      paths_(*view.scene, scratch_, view.options->alpha, view.options->paths) {
  scratch_.photons = view.photons;
  samples_.resize(Tracer::most_together);
  start_.ray.o = view.camera.in->location;
  start_.reach = view.reach;
  if (view.one_origin) start_.inside = view.scene->around_camera;
  for (std::size_t i = 0; i < most_in_packet; ++i) {
    rays_.rays.add(start_.ray, Tracer::nearest_seen, start_.reach);
  }
}

void Eye::begin(const IrradianceCache* cache, std::uint32_t seed) {
  const std::optional<RadiosityProgram>& r = view_->scene->radiosity;
  if (!r) return;
  scratch_.radiosity.begin(cache, true, seed, static_cast<std::uint32_t>(r->directions.size()));
}

// What nearly every sample goes through.
Pixel Eye::see_directly(double x, double y, std::uint32_t index) {
  CameraRay ray;
  if (!camera_ray(x, y, 0, ray)) return nothing;
  return look_along(ray, x, y, index);
}

Pixel Eye::see_all(double x, double y, std::uint32_t index) {
  if (!view_->lens.blurs()) return plain(x, y, index);
  return view_->lens.blur([&](int n) {
    return through_lens(view_->lens.moved(x, y, n), {x, y}, index, n);
  });
}

void Eye::see(std::span<const Spot> spots, Pixel* out) {
  if (!view_->direct || view_->scene->quality.path) {
    for (const Spot& spot : spots) *out++ = see(spot.x, spot.y, spot.index);
    return;
  }
  const bool in_lanes = view_->pinhole.camera != nullptr;
  while (!spots.empty()) {
    const auto some = spots.first(std::min(spots.size(), Tracer::most_together));
    in_lanes ? see_through_pinhole(some, out) : see_some(some, out);
    spots = spots.subspan(some.size());
    out += some.size();
  }
}

/// Step by step for all, lest each ray waits for what it has to compute one after the other.
void Eye::see_some(std::span<const Spot> spots, Pixel* out) {
  Packet<CameraRay> rays;
  Packet<dvec3> directions;
  std::array<Pixel*, Tracer::most_together> pixels;
  std::size_t count = 0;
  for (const Spot& spot : spots) {
    Pixel& pixel = *out++;
    if (!camera_ray(spot.x, spot.y, 0, rays[count])) {
      pixel = nothing;
      continue;
    }
    directions[count] = rays[count].ray.d;
    samples_[count].noise = sample_seed(spot.x, spot.y, spot.index);
    pixels[count++] = &pixel;
  }
  normalize_all(directions.first(count));
  for (std::size_t i = 0; i < count; ++i) {
    start(rays[i], directions[i], *::new (&samples_[i].path) Path);  // made in place
  }
  tracer_.trace(std::span(samples_).first(count));
  for (std::size_t i = 0; i < count; ++i) {
    *pixels[i] = Pixel(samples_[i].seen.colour, samples_[i].seen.transmittance);
  }
}

/// The same without the ways of the other cameras.
void Eye::see_through_pinhole(std::span<const Spot> spots, Pixel* out) {
  for (std::size_t i = 0; i < most_in_packet; ++i) {
    const Spot& spot = spots[std::min(i, spots.size() - 1)];  // whatever is there beyond the last
    rays_.x[i] = spot.x;
    rays_.y[i] = spot.y;
    rays_.key[i] = spot.index;
  }
  see_through_pinhole(spots.size(), out);
}

void Eye::see_square(int left, int top, Pixel* out) {
  static_assert(square_edge * square_edge == most_in_packet);
  if (view_->pinhole.camera != nullptr) {
    for (std::size_t i = 0; i < most_in_packet; ++i) {
      rays_.x[i] = left + static_cast<int>(i % square_edge);
      rays_.y[i] = top + static_cast<int>(i / square_edge);
      rays_.key[i] = 0;
    }
    return see_through_pinhole(most_in_packet, out);
  }
  std::array<Spot, most_in_packet> spots;
  Spot* next = spots.data();
  in_rows({left, top, left + square_edge, top + square_edge}, [&](int x, int y) {
    *next++ = {double(x), double(y), 0};
  });
  see(spots, out);
}

DURER_INLINE void Eye::see_through_pinhole(std::size_t count, Pixel* out) {
  static const PinholeVersion look = pinhole_versions().back();
  look(view_->pinhole, rays_);
  rays_.rays.count = count;
  const std::span<Sample> samples = std::span(samples_).first(count);
  for (std::size_t i = 0; i < count; ++i) samples[i].noise = rays_.key[i];
  tracer_.trace(start_, rays_.rays, samples);
  for (const Sample& s : samples) *out++ = Pixel(s.seen.colour, s.seen.transmittance);
}

Pixel Eye::sample(int x, int y, std::uint32_t index) {
  const auto column = static_cast<std::uint32_t>(x);
  const auto row = static_cast<std::uint32_t>(y);
  random_ = SobolSampler(mixed(column) + 0x9E3779B9U * row, index);
  const dvec2 at = dvec2(x, y) + random_.next2() - 0.5;
  if (!view_->lens.blurs()) return plain(at.x, at.y, index);
  const int part = static_cast<int>(random_.next() * view_->lens.points());
  return through_lens(at, at, index, part);
}

DURER_INLINE bool Eye::camera_ray(double x, double y, int turn, CameraRay& out) {
  const RenderOptions& o = *view_->options;
  // Rows are counted from below, so that the last bits are the oracle's.
  const double from_below = o.height - 1 - y;
  const PictureSpot spot{(x + 0.5) / o.width - 0.5,
                         (from_below + 0.5) / o.height - 0.5,
                         x,
                         y,
                         o.width,
                         o.height,
                         turn};
  return view_->camera.ray(spot, workspace_, out);
}

/// The mean over the rays that there are.
Pixel Eye::plain(double x, double y, std::uint32_t index) {
  if (view_->turns == 1) return see_directly(x, y, index);
  CameraRay ray;
  Pixel sum(0.0F);
  int seen = 0;
  for (int turn = 0; turn < view_->turns; ++turn) {
    if (!camera_ray(x, y, turn, ray)) continue;
    ++seen;
    sum += look_along(ray, x, y, index);
  }
  return seen == 0 ? nothing : sum / static_cast<float>(seen);
}

// Rays through all parts of the lens meet again at the focal distance (shading §2.7).
Pixel Eye::through_lens(dvec2 at, dvec2 pixel, std::uint32_t index, int sample) {
  const scene::Camera& c = *view_->camera.in;
  CameraRay ray;
  if (!camera_ray(at.x, at.y, 0, ray)) return nothing;
  const dvec2 part = view_->lens.on_lens(at, sample);
  const dvec3 shift = part.x * view_->lens_right - part.y * view_->lens_up;
  ray.ray.o = c.location + shift;
  ray.ray.d = view_->lens_scale * ray.ray.d - shift;
  return look_along(ray, pixel.x, pixel.y, index * 4099 + static_cast<std::uint32_t>(sample));
}

Pixel Eye::look_along(const CameraRay& ray, double x, double y, std::uint32_t index) {
  scratch_.noise = sample_seed(x, y, index);
  Path path;
  start(ray, unit(ray.ray.d), path);
  const auto pixel = [](const Radiance& r) { return Pixel(r.colour, r.transmittance); };
  if (view_->scene->quality.path) return pixel(paths_.trace(path, random_));
  return pixel(tracer_.trace(std::move(path)));
}

/// A path as it leaves the camera. `d`: the direction of the ray, of unit length.
DURER_INLINE void Eye::start(const CameraRay& ray, const dvec3& d, Path& path) {
  path.ray = {ray.ray.o, d};
  if (view_->bump != scene::none) {
    const dvec3 place(ray.plane.x, ray.plane.y, 0);
    path.ray.d = glm::normalize(view_->bumps.at(view_->bump, place, path.ray.d, nullptr));
  }
  path.reach = view_->reach;
  if (view_->one_origin) {
    path.inside = view_->scene->around_camera;
  } else if (view_->bodies_matter) {
    find_around(path.ray.o, path.inside);
  }
}

/// Parallel rays follow each other, and a root and a division are what their pixels wait for.
dvec3 Eye::unit(const dvec3& d) {
  const auto differ = [](double a, double b) {  // also 0 and -0
    return std::bit_cast<std::uint64_t>(a) ^ std::bit_cast<std::uint64_t>(b);
  };
  if ((differ(d.x, last_d_.x) | differ(d.y, last_d_.y) | differ(d.z, last_d_.z)) != 0) {
    last_d_ = d;
    last_unit_ = glm::normalize(d);
  }
  return last_unit_;
}

/// Adds the bodies that hold `p`.
void Eye::find_around(const dvec3& p, Containment& inside) {
  scratch_.containing.clear();
  view_->scene->geometry.containing(p, scratch_.containing, *scratch_.geometry);
  for (const std::uint32_t id : scratch_.containing) inside.append(id);
}

}  // namespace durer::tracer
