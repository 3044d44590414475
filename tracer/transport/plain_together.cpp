// The short way for several points: lamp by lamp, so that objects which answer rays together are
// asked once for all points that a lamp may light.
#include <array>
#include <bit>
#include <glm/geometric.hpp>
#include <new>
#include <optional>

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
  const TextureProgram* texture = nullptr;
  std::uint32_t lamps = 0;
  bool double_illuminate = false;
  bool collects = false;
  friend bool operator==(const PlainKind&, const PlainKind&) = default;
};

/// Points on their way to be lit.
struct Tracer::PlainGroup {
  PlainKind kind;
  std::array<Sample*, most_together> samples;
  const Path* start;  // of all samples, if their paths are not made yet
  PlainPoints points;

  explicit PlainGroup(const PlainKind& k, const Path* begin = nullptr) : kind(k), start(begin) {
    points.count = 0;
  }
  void add(Sample& sample, const dvec3& p, const dvec3& d, const dvec3& n) {
    const std::size_t i = points.count++;
    samples[i] = &sample;
    put(p, points.p(), i);
    put(d, points.d, i);
    put(n, points.n, i);
    points.noise[i] = sample.noise;
  }
  /// The places of those in `who`, seen along `d`, and their normals, which turn if seen from
  /// inside.
  void place(const PacketMeeting& meeting, const PacketVectors& d, Mask who, Mask inside) {
    if (who == all_of_packet) {
      points.to_lamp.o = meeting.points.p;
      points.d = d.of;
      points.n = meeting.normals.of;
      return each_bit(inside, [&](std::size_t i) DURER_LAMBDA_INLINE {
        for (auto& n : points.n) n[i] = -n[i];
      });
    }
    std::size_t next = 0;
    each_bit(who, [&](std::size_t i) DURER_LAMBDA_INLINE {
      const dvec3 n = meeting.normals[i];
      put(meeting.points.p[i], points.p(), next);
      put(d[i], points.d, next);
      put((inside >> i & 1) != 0 ? -n : n, points.n, next++);
    });
  }
  /// The bodies around the view of a point.
  [[nodiscard]] const Containment& inside(std::size_t i) const {
    return start != nullptr ? start->inside : samples[i]->path.inside;
  }
};

/// Points by kind: nearly always there is one.
struct Tracer::PlainKinds {
  Packet<PlainKind> kinds;
  std::array<Mask, most_together> who;
  std::size_t count = 0;

  /// The place of a kind.
  [[nodiscard]] std::size_t find(const PlainKind& kind) {
    std::size_t i = 0;
    while (i < count && kinds[i] != kind) ++i;
    if (i == count) {
      ::new (&kinds[i]) PlainKind(kind);
      who[i] = 0;
      ++count;
    }
    return i;
  }
};

/// Lights what rays have met and goes the short way, without looking at it any closer; returns a
/// bit for each of those. `start`: of their paths, if these are not made yet.
std::uint32_t Tracer::light_met(std::span<Sample> samples, const Path* start) {
  PlainKinds found;
  Mask lit = 0;
  Mask from_inside = 0;
  // What the last one has shown: neighbours are alike.
  std::uint32_t last_leaf = scene::none;
  bool last_inside = false;
  std::optional<std::size_t> last;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const MeetingRay& ray = scratch_->meeting[i];
    if (!ray.met || ray.hit.depth > 0) continue;
    const bool inside = glm::dot(ray.hit.n, ray.ray->d) > 0;
    if (ray.hit.leaf != last_leaf || inside != last_inside) {
      last_leaf = ray.hit.leaf;
      last_inside = inside;
      const PlainKind kind = kind_of(last_leaf, inside);
      last = kind.texture != nullptr ? std::optional(found.find(kind)) : std::nullopt;
    }
    if (!last) continue;
    found.who[*last] |= Mask{1} << i;
    lit |= Mask{1} << i;
    from_inside |= Mask{inside} << i;
  }
  for (std::size_t k = 0; k < found.count; ++k) {
    PlainGroup group(found.kinds[k], start);
    each_bit(found.who[k], [&](std::size_t i) DURER_LAMBDA_INLINE {
      const auto& [ray, t_from, t_to, met, hit] = scratch_->meeting[i];
      group.add(samples[i], hit.p, ray->d, (from_inside >> i & 1) != 0 ? -hit.n : hit.n);
    });
    look_up(group);
    light(group);
  }
  return lit;
}

/// The same for those that all meet one object, and whose paths are not made yet.
std::uint32_t Tracer::light_met(const Path& start, const PacketRays& rays,
                                const PacketMeeting& meeting, std::span<Sample> samples) {
  std::array<std::uint8_t, most_together> numbers;  // of the samples
  PacketVectors packed;
  const bool all = meeting.met == all_of_packet;
  std::size_t count = 0;
  each_bit(meeting.met, [&](std::size_t i) DURER_LAMBDA_INLINE {
    if (!all) packed.set(count, rays.d[i]);
    numbers[count++] = static_cast<std::uint8_t>(i);
  });
  const PacketVectors& d = all ? rays.d : packed;
  const Mask inside = along(meeting.normals, d, count);
  const Mask outside = ~inside & ((Mask{2} << (count - 1)) - 1);
  std::array<PlainKind, 2> kinds;
  std::array<Mask, 2> who{outside, inside};
  for (std::size_t k = 0; k < 2; ++k) {
    if (who[k] != 0) kinds[k] = kind_of(meeting.leaf, k == 1);
  }
  if (who[0] != 0 && kinds[0] == kinds[1]) who = {inside | outside, 0};
  Mask lit = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    if (who[k] == 0 || kinds[k].texture == nullptr) continue;
    PlainGroup group(kinds[k], &start);
    group.place(meeting, d, who[k], inside);
    each_bit(who[k], [&](std::size_t i) DURER_LAMBDA_INLINE {
      Sample& sample = samples[numbers[i]];
      group.points.noise[group.points.count] = sample.noise;
      group.samples[group.points.count++] = &sample;
      lit |= Mask{1} << numbers[i];
    });
    look_up(group);
    light(group);
  }
  return lit;
}

/// Colours and bumps of points whose normals are those of the surface.
void Tracer::look_up(PlainGroup& group) const {
  PlainPoints& points = group.points;
  const LayerProgram& layer = scene_->textures.layer(group.kind.texture->first_layer);
  const PigmentStore& pigments = scene_->textures.pigments();
  std::array<dvec3, most_together> places;
  const auto all_places = [&] {
    for (std::size_t i = 0; i < points.count; ++i) places[i] = at(points.p(), i);
    return std::span(places).first(points.count);
  };
  if (const Colour* colour = pigments.everywhere(layer.pigment); colour != nullptr) {
    points.pigment[0].fill(colour->rgb.x);
    points.pigment[1].fill(colour->rgb.y);
    points.pigment[2].fill(colour->rgb.z);
  } else {
    std::array<Colour, most_together> colours;
    pigments.at(layer.pigment, all_places(), colours.data());
    for (std::size_t i = 0; i < points.count; ++i) put(colours[i].rgb, points.pigment, i);
  }
  if (layer.normal == scene::none) return;
  std::array<dvec3, most_together> normals;
  for (std::size_t i = 0; i < points.count; ++i) normals[i] = at(points.n, i);
  scene_->textures.normals().at(layer.normal, all_places(), normals.data());
  for (std::size_t i = 0; i < points.count; ++i) put(glm::normalize(normals[i]), points.n, i);
}

/// The kind of points of a leaf that stands in no shared contents; without a texture, if they are
/// not lit the short way, or look different without their View.
Tracer::PlainKind Tracer::kind_of(std::uint32_t leaf, bool from_inside) const {
  const SurfaceProgram& s = scene_->surfaces[leaves_[leaf].surface];
  if (!s.bare) return {};
  const TextureProgram& texture = scene_->textures.program(from_inside ? s.inside : s.outside);
  if (!texture.plain || texture.uses_uv || texture.asks_view) return {};
  const bool collects = s.photons.collects();
  if (collects && has_caustics()) return {};
  return {&texture, s.lamps, s.double_illuminate, collects};
}

/// Lights those samples that go the short way and have been looked up; they wait no longer. Asks
/// the same rays as if they were lit one by one.
void Tracer::light_together(std::span<Sample> samples) {
  PlainKinds known;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    FoundSurface& found = scratch_->found[i];
    const View& view = found.look.view;
    if (!found.waits || !is_plain(view) || view.known.empty()) continue;
    found.waits = false;
    const std::size_t k =
        known.find({view.texture, view.lamps, view.double_illuminate, view.collects});
    known.who[k] |= Mask{1} << i;
  }
  for (std::size_t k = 0; k < known.count; ++k) {
    PlainGroup group(known.kinds[k]);
    each_bit(known.who[k], [&](std::size_t i) DURER_LAMBDA_INLINE {
      const View& view = scratch_->found[i].look.view;
      const LayerLook& own = view.known.front();
      put(own.colour->rgb, group.points.pigment, group.points.count);
      group.add(samples[i], view.p, view.d, *own.n);
    });
    light(group);
  }
}

void Tracer::light(PlainGroup& group) {
  PlainPoints& points = group.points;
  const Finish& finish = finish_of_plain(*group.kind.texture);
  points.finish = &finish;
  for (auto& lit : points.lit) lit.fill(0);
  // Registers are full: of points that are there already.
  for (std::size_t i = points.count; i < PlainPoints::size; ++i) {
    put(at(points.p(), 0), points.p(), i);
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
    const dvec3 p = at(points.p(), i);
    if (!reach.contains(p)) return;
    const Incidence in{at(points.l(), i), points.distance[i], lamp.colour};
    shares[i] = static_cast<float>(tracer::attenuation(lamp, in, p));
    if (!dark(lamp.colour * shares[i])) left |= Mask{1} << i;
  });
  return left;
}

/// Those points between which and the lamp nothing stands.
std::uint32_t Tracer::unblocked(PlainPoints& points, std::uint32_t open) {
  const Mask asked = open & points.shaded;
  scratch_->rays += static_cast<std::uint64_t>(std::popcount(asked));
  return open & ~scene_->geometry.occluded(points.to_lamp, asked, *scratch_->geometry);
}

/// Adds the light of a lamp that is more than a point, or casts no shadows: point by point.
void Tracer::add_wide_lamp(std::uint32_t number, PlainGroup& group) {
  PlainPoints& points = group.points;
  for (std::size_t i = 0; i < points.count; ++i) {
    View view;  // as far as lamps ask for it
    view.p = view.q = at(points.p(), i);
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
             add_light(view, group.inside(i), layer, lamp, kept, hidden, lit);
           });
    points.noise[i] = scratch_->noise;
    put(lit, points.lit, i);
  }
}

}  // namespace durer::tracer
