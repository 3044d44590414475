// The short way for several points: lamp by lamp, so that objects which answer rays together are
// asked once for all points that a lamp may light.
#include <bit>

#include "tracer/accel/lanes.h"
#include "tracer/transport/plain.h"
#include "tracer/transport/plain_lanes.h"

namespace durer::tracer {

using wide::each_bit;

namespace {

using Mask = PlainPoints::Mask;

template <typename Number, typename Vector>
DURER_INLINE void put(const Vector& from, PlainPoints::Vectors<Number>& to, std::size_t i) {
  to[0][i] = from.x;
  to[1][i] = from.y;
  to[2][i] = from.z;
}
template <typename Number>
DURER_INLINE auto at(const PlainPoints::Vectors<Number>& v, std::size_t i) {
  return glm::vec<3, Number>(v[0][i], v[1][i], v[2][i]);
}

}  // namespace

/// What points share that are lit together.
struct Tracer::PlainKind {
  const TextureProgram* texture;
  std::uint32_t lamps;
  bool double_illuminate;
  bool collects;
  friend bool operator==(const PlainKind&, const PlainKind&) = default;
};

/// Points on their way to be lit.
struct Tracer::PlainGroup {
  PlainKind kind;
  std::array<Sample*, most_together> samples;
  PlainPoints points;

  explicit PlainGroup(const PlainKind& k) : kind(k) { points.count = 0; }
  void add(Sample& sample, const dvec3& p, const dvec3& n, const vec3& pigment) {
    const std::size_t i = points.count++;
    samples[i] = &sample;
    put(p, points.p, i);
    put(sample.path.ray.d, points.d, i);
    put(n, points.n, i);
    put(pigment, points.pigment, i);
    points.noise[i] = sample.noise;
  }
};

/// Calls visit(kind, who) for those of each kind.
template <typename Kinds, typename Visit>
DURER_INLINE void each_kind(const Kinds& kinds, Mask open, const Visit& visit) {
  while (open != 0) {
    const auto& kind = kinds[static_cast<std::size_t>(std::countr_zero(open))];
    Mask same = 0;
    each_bit(open, [&](std::size_t i)
                       DURER_LAMBDA_INLINE { same |= (kinds[i] == kind ? Mask{1} : 0) << i; });
    open &= ~same;
    visit(kind, same);
  }
}

/// Lights what rays have met and goes the short way, without looking at it any closer; returns a
/// bit for each of those.
std::uint32_t Tracer::light_met(std::span<Sample> samples) {
  std::array<PlainKind, most_together> kinds;
  Mask lit = 0;
  Mask from_inside = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const MeetingRay& ray = scratch_->meeting[i];
    if (!ray.met) continue;
    const bool inside = glm::dot(ray.hit.n, samples[i].path.ray.d) > 0;
    if (!is_plain(ray.hit, inside, kinds[i])) continue;
    lit |= Mask{1} << i;
    from_inside |= Mask{inside} << i;
  }
  each_kind(kinds, lit,
            [&](const PlainKind& kind, Mask same) { light_met(samples, kind, same, from_inside); });
  return lit;
}

/// The same for those of one kind.
void Tracer::light_met(std::span<Sample> samples, const PlainKind& kind, std::uint32_t same,
                       std::uint32_t from_inside) {
  dvec3* const normals = scratch_->found_layers.front().normals.data();
  Colour* const colours = scratch_->found_layers.front().colours.data();
  std::array<dvec3, most_together> places;
  std::size_t count = 0;
  each_bit(same, [&](std::size_t i) DURER_LAMBDA_INLINE {
    const Hit& hit = scratch_->meeting[i].hit;
    places[count] = hit.p;
    normals[count++] = (from_inside >> i & 1) != 0 ? -hit.n : hit.n;
  });
  const LayerProgram& layer = scene_->textures.layer(kind.texture->first_layer);
  const auto points = std::span(places).first(count);
  scene_->textures.pigments().at(layer.pigment, points, colours);
  if (layer.normal != scene::none) {
    std::size_t k = 0;
    each_bit(same, [&](std::size_t i) DURER_LAMBDA_INLINE {
      places[k++] = scratch_->meeting[i].hit.p;  // pigments have moved them
    });
    scene_->textures.normals().at(layer.normal, points, normals);
    for (std::size_t i = 0; i < count; ++i) normals[i] = glm::normalize(normals[i]);
  }
  PlainGroup group(kind);
  std::size_t k = 0;
  each_bit(same, [&](std::size_t i) DURER_LAMBDA_INLINE {
    group.add(samples[i], scratch_->meeting[i].hit.p, normals[k], colours[k].rgb);
    ++k;
  });
  light(group);
}

/// True if a hit is lit the short way, and looks the same without its View.
bool Tracer::is_plain(const Hit& hit, bool from_inside, PlainKind& kind) const {
  const SurfaceProgram& s = scene_->surfaces[leaves_[hit.leaf].surface];
  if (!s.bare || hit.depth > 0) return false;
  const TextureProgram& texture = scene_->textures.program(from_inside ? s.inside : s.outside);
  if (!texture.plain || texture.uses_uv || texture.asks_view) return false;
  const bool collects = s.photons.collects();
  if (collects && has_caustics()) return false;
  kind = {&texture, s.lamps, s.double_illuminate, collects};
  return true;
}

/// Lights those samples that go the short way and have been looked up; they wait no longer. Asks
/// the same rays as if they were lit one by one.
void Tracer::light_together(std::span<Sample> samples) {
  std::array<PlainKind, most_together> kinds;
  Mask open = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    FoundSurface& found = scratch_->found[i];
    const View& view = found.look.view;
    if (!found.waits || !is_plain(view) || view.known.empty()) continue;
    found.waits = false;
    kinds[i] = {view.texture, view.lamps, view.double_illuminate, view.collects};
    open |= Mask{1} << i;
  }
  each_kind(kinds, open, [&](const PlainKind& kind, Mask same) {
    PlainGroup group(kind);
    each_bit(same, [&](std::size_t i) DURER_LAMBDA_INLINE {
      const View& view = scratch_->found[i].look.view;
      const LayerLook& own = view.known.front();
      group.add(samples[i], view.p, *own.n, own.colour->rgb);
    });
    light(group);
  });
}

void Tracer::light(PlainGroup& group) {
  PlainPoints& points = group.points;
  const Finish& finish = finish_of_plain(*group.kind.texture);
  points.finish = &finish;
  for (auto& lit : points.lit) lit.fill(0);
  // Registers are full: of points that are there already.
  for (std::size_t i = points.count; i % PlainPoints::group != 0; ++i) {
    put(at(points.p, 0), points.p, i);
    put(at(points.d, 0), points.d, i);
    put(at(points.n, 0), points.n, i);
  }
  if (finish.lit) {
    for (const std::uint32_t lamp : lamp_sets_[group.kind.lamps]) {
      if (scene_->lights[lamp].plain) {
        add_lamp(lamp, group);
      } else {
        add_wide_lamp(lamp, group);
      }
    }
  }
  for (std::size_t i = 0; i < points.count; ++i) {
    Sample& sample = *group.samples[i];
    add_glow(finish, at(points.pigment, i), at(points.lit, i), sample.seen.colour);
    sample.seen.transmittance = 0;
    sample.noise = points.noise[i];
  }
}

/// Adds the light of one lamp that is a point, and which anything stops.
void Tracer::add_lamp(std::uint32_t number, PlainGroup& group) {
  const Light& lamp = scene_->lights[number];
  if (dark(lamp.colour)) return;
  PlainPoints& points = group.points;
  const Finish& finish = *points.finish;
  plain_lanes_->aim(points, lamp);
  if (group.kind.double_illuminate) points.facing = ~Mask{0};
  Mask open = points.apart & ((Mask{2} << (points.count - 1)) - 1);
  if (finish.diffuse_back == 0) open &= points.facing;
  PlainBeam beam{lamp.colour};
  alignas(64) PlainPoints::PerPoint<float> shares;
  if (lamp.weakened) {
    open = weaken(number, points, open, shares.data());
    beam.shares = shares.data();
  }
  const Mask lit = unblocked(points, open);
  if (const Mask front = lit & points.facing; front != 0) {
    beam.diffuse = finish.diffuse;
    plain_lanes_->shade(points, beam, front);
  }
  if (const Mask back = lit & ~points.facing; back != 0) {
    beam.diffuse = finish.diffuse_back;
    beam.highlights = false;
    plain_lanes_->shade(points, beam, back);
  }
}

/// Of a lamp whose light depends on the place: its share for each point, and who gets some of it.
std::uint32_t Tracer::weaken(std::uint32_t number, const PlainPoints& points, std::uint32_t open,
                             float* shares) const {
  const Light& lamp = scene_->lights[number];
  const Reach& reach = scene_->reaches[number];
  Mask left = 0;
  each_bit(open, [&](std::size_t i) DURER_LAMBDA_INLINE {
    const dvec3 p = at(points.p, i);
    if (!reach.contains(p)) return;
    const Incidence in{at(points.l, i), points.distance[i], lamp.colour};
    shares[i] = static_cast<float>(tracer::attenuation(lamp, in, p));
    if (!dark(lamp.colour * shares[i])) left |= Mask{1} << i;
  });
  return left;
}

/// Those points between which and the lamp nothing stands.
std::uint32_t Tracer::unblocked(const PlainPoints& points, std::uint32_t open) {
  std::array<std::uint8_t, most_together> asking;
  std::size_t count = 0;
  each_bit(open, [&](std::size_t i) DURER_LAMBDA_INLINE {
    if (!(points.distance[i] > 2 * t_shadow)) return;
    ShadowRay& ray = scratch_->shadow_rays[count];
    ray.ray.o = at(points.p, i);
    ray.ray.d = at(points.l, i);
    ray.t_from = t_shadow;
    ray.t_to = points.distance[i] - t_shadow;
    asking[count++] = static_cast<std::uint8_t>(i);
  });
  scratch_->rays += count;
  const auto rays = std::span(scratch_->shadow_rays).first(count);
  scene_->geometry.occluded(rays, *scratch_->geometry);
  for (std::size_t i = 0; i < count; ++i) {
    open &= ~((rays[i].blocked ? Mask{1} : 0) << asking[i]);
  }
  return open;
}

/// Adds the light of a lamp that is more than a point, or casts no shadows: point by point.
void Tracer::add_wide_lamp(std::uint32_t number, PlainGroup& group) {
  PlainPoints& points = group.points;
  for (std::size_t i = 0; i < points.count; ++i) {
    View view;  // as far as lamps ask for it
    view.p = view.q = at(points.p, i);
    view.d = at(points.d, i);
    view.g = view.seen = at(points.n, i);
    view.texture = group.kind.texture;
    view.lamps = group.kind.lamps;
    view.double_illuminate = group.kind.double_illuminate;
    view.collects = group.kind.collects;
    const LayerPoint layer{points.finish, 1, view.g, at(points.pigment, i)};
    vec3 lit = at(points.lit, i);
    scratch_->noise = points.noise[i];
    if_lit(number, view, layer,
           [&](const Light& lamp, const Incidence& in, bool hidden) DURER_LAMBDA_INLINE {
             const Incidence kept = in;  // `in` itself may stay in registers
             add_light(view, group.samples[i]->path.inside, layer, lamp, kept, hidden, lit);
           });
    points.noise[i] = scratch_->noise;
    put(lit, points.lit, i);
  }
}

}  // namespace durer::tracer
