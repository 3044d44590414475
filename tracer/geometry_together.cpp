// Rays that go side by side: each goes through the hierarchy on its own, but puts off those objects
// that answer several rays faster together; then each of these is asked once.
#include <algorithm>
#include <bit>
#include <new>
#include <utility>

#include "tracer/accel/lanes.h"
#include "tracer/geometry_state.h"

namespace durer::tracer {
namespace {

static_assert(most_in_packet <= 32);  // sets of rays are bits of PutOff::Object::rays

/// Places of hits, those of the rays that met something one after the other.
void find_points(const PacketRays& rays, const PacketHits& hits, PacketMeeting& out) {
  PacketPoints& points = out.points;
  if (hits.met == all_of_packet) {  // in order already
    points.count = most_in_packet;
    points.part = hits.part;
    out.t = hits.t;
    for (std::size_t k = 0; k < 3; ++k) {
      const double* const o = rays.o.of[k].data();
      const double* const d = rays.d.of[k].data();
      double* const p = points.p.of[k].data();
      for (std::size_t i = 0; i < most_in_packet; ++i) p[i] = o[i] + hits.t[i] * d[i];
    }
    return;
  }
  points.count = 0;
  wide::each_bit(hits.met, [&](std::size_t i) {
    out.t[points.count] = hits.t[i];
    points.add(rays.ray(i).at(hits.t[i]), hits.part[i]);
  });
  points.fill_up();
}

bool is_answered(const RayQuery& query) {
  return (query.any && query.found.store != nullptr) || !(query.t_from < query.t_to);
}

void ask(const PutOff::Object& object, Packet<RayQuery>& queries) {
  std::array<RayQuery*, most_in_packet> open;
  std::size_t count = 0;
  for (std::uint32_t left = object.rays; left != 0; left &= left - 1) {
    RayQuery& query = queries[static_cast<std::size_t>(std::countr_zero(left))];
    if (!is_answered(query)) open[count++] = &query;
  }
  // One that is left alone, too: its answer does not depend on who goes with it.
  const Targets& targets = *object.targets;
  if (count > 0) targets.nearest_together(targets, object.index, std::span(open).first(count));
}

/// Of `count` rays, at least one.
void ask_put_off(const Accel& accel, std::size_t count, GeometryScratch& scratch) {
  const PutOff& list = scratch.put_off;
  for (std::uint32_t i = 0; i < list.count; ++i) ask(list.objects[i], scratch.queries);
  const auto [targets, index] = accel.companion();
  if (targets == nullptr) return;
  if ((targets->tags[index].mask & scratch.queries[0].mask) == 0) return;
  ask({targets, index, (2U << (count - 1)) - 1}, scratch.queries);
}

}  // namespace

void ask_now(RayQuery& query) {
  PutOff& list = *std::exchange(query.later, nullptr);
  for (std::uint32_t i = 0; i < list.count; ++i) {
    PutOff::Object& object = list.objects[i];
    if ((object.rays & list.ray) == 0) continue;
    object.rays &= ~list.ray;
    if (!is_answered(query)) object.targets->nearest(*object.targets, object.index, query);
  }
}

void Geometry::closest(std::span<MeetingRay> rays, RayKind kind, GeometryScratch& scratch) const {
  if (rays.empty()) return;
  if (const auto one = state_->only_companion(); one.targets != nullptr) {
    PacketRays packet;
    for (const MeetingRay& r : rays) packet.add(*r.ray, r.t_from, r.t_to);
    packet.fill_up();
    PacketMeeting meeting;
    state_->closest_on(one, packet, kind, meeting);
    for (std::size_t i = 0; i < rays.size(); ++i) rays[i].met = (meeting.met >> i & 1) != 0;
    std::size_t number = 0;
    wide::each_bit(meeting.met, [&](std::size_t i) { meeting.fill_in(number++, rays[i].hit); });
    return;
  }
  if (!state_->answers_together) {
    for (MeetingRay& r : rays) r.met = closest(*r.ray, r.t_from, r.t_to, kind, r.hit, scratch);
    return;
  }
  scratch.put_off.count = 0;
  const bool others = !state_->accel->companion_only();
  for (std::uint32_t i = 0; i < rays.size(); ++i) {
    const MeetingRay& r = rays[i];
    RayQuery& query = *::new (&scratch.queries[i])
                          RayQuery(state_->query(*r.ray, r.t_from, r.t_to, kind, scratch));
    query.later = &scratch.put_off;
    scratch.put_off.begin(i);
    if (others) state_->accel->closest(query);
  }
  ask_put_off(*state_->accel, rays.size(), scratch);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    MeetingRay& r = rays[i];
    const RayQuery& query = scratch.queries[i];
    r.met = query.found.store != nullptr;
    if (!r.met) continue;
    state_->fill_in(query, r.hit);
    if (r.hit.depth > 0) state_->resolve_path(query.path, r.hit);
  }
  state_->add_normals(rays);
}

void Geometry::occluded(std::span<ShadowRay> rays, GeometryScratch& scratch) const {
  if (!state_->answers_together || rays.size() <= 1) {
    for (ShadowRay& r : rays) r.blocked = occluded(r.ray, r.t_from, r.t_to, scratch);
    return;
  }
  if (const auto one = state_->only_companion(); one.targets != nullptr) {
    PacketRays packet;
    for (const ShadowRay& r : rays) packet.add(r.ray, r.t_from, r.t_to);
    packet.fill_up();
    const RaySet blocked = state_->occluded_by(one, packet, (RaySet{2} << (rays.size() - 1)) - 1);
    for (std::size_t i = 0; i < rays.size(); ++i) rays[i].blocked = (blocked >> i & 1) != 0;
    return;
  }
  scratch.put_off.count = 0;
  const bool others = !state_->accel->companion_only();
  for (std::uint32_t i = 0; i < rays.size(); ++i) {
    const ShadowRay& r = rays[i];
    RayQuery& query = *::new (&scratch.queries[i])
                          RayQuery(state_->shadow_query(r.ray, r.t_from, r.t_to, scratch));
    query.later = &scratch.put_off;
    scratch.put_off.begin(i);
    if (others) state_->accel->any(query);
  }
  ask_put_off(*state_->accel, rays.size(), scratch);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    rays[i].blocked = scratch.queries[i].found.store != nullptr;
  }
}

RaySet Geometry::occluded(PacketRays& rays, RaySet asked, GeometryScratch& scratch) const {
  const auto one = state_->only_companion();
  if (one.targets != nullptr && std::popcount(asked) > 1) {
    return state_->occluded_by(one, rays, asked);
  }
  std::array<std::size_t, most_in_packet> numbers;
  std::size_t count = 0;
  wide::each_bit(asked, [&](std::size_t i) {
    ::new (&scratch.shadow_rays[count]) ShadowRay{rays.ray(i), rays.t_from[i], rays.t_to[i]};
    numbers[count++] = i;
  });
  const std::span<ShadowRay> each = scratch.shadow_rays.first(count);
  occluded(each, scratch);
  RaySet blocked = 0;
  for (std::size_t k = 0; k < count; ++k) blocked |= RaySet{each[k].blocked} << numbers[k];
  return blocked;
}

/// The object that is alone in the world, if it answers whole packets and nothing hides parts of
/// it.
Accel::Companion Geometry::State::only_companion() const {
  const Accel::Companion& one = accel->companion();
  if (!accel->companion_only() || one.targets->tags[one.index].gated) return {};
  return one;
}

bool Geometry::is_one_object() const { return state_->only_companion().targets != nullptr; }

void Geometry::closest(const PacketRays& rays, RayKind kind, PacketMeeting& out) const {
  state_->closest_on(state_->only_companion(), rays, kind, out);
}

void PacketMeeting::fill_in(std::size_t number, Hit& hit) const {
  hit.t = t[number];
  hit.leaf = leaf;
  hit.interior = interior;
  hit.p = points.p[number];
  hit.n = normals[number];
  hit.store = store;
  hit.shape = shape;
  hit.part = points.part[number];
  hit.depth = 0;
}

void Geometry::State::closest_on(const Accel::Companion& one, const PacketRays& rays, RayKind kind,
                                 PacketMeeting& out) const {
  const Tag& tag = one.targets->tags[one.index];
  out.met = 0;
  if ((tag.mask & mask_of(kind)) == 0) return;
  PacketHits hits;
  one.targets->packet(*one.targets, one.index, rays, false, hits);
  if (hits.met == 0) return;
  const auto& store = static_cast<const Store&>(*one.targets);
  out.met = hits.met;
  out.leaf = tag.leaf;
  out.interior = leaves[tag.leaf].inner_interior;
  out.shape = one.index;
  out.store = &store;
  find_points(rays, hits, out);
  store.normals(one.index, out.points, out.normals);
  if (leaf_inverted[tag.leaf] == 0) return;
  for (auto& n : out.normals.of) {
    for (double& x : n) x = -x;
  }
}

RaySet Geometry::State::occluded_by(const Accel::Companion& one, PacketRays& rays,
                                    RaySet asked) const {
  if ((one.targets->tags[one.index].mask & blocks_light) == 0) return 0;
  for (double& t : rays.t_from) t = after(t);
  wide::each_bit(~asked & all_of_packet, [&](std::size_t i) {
    rays.t_to[i] = rays.t_from[i];  // an empty range
  });
  PacketHits hits;
  one.targets->packet(*one.targets, one.index, rays, true, hits);
  return hits.met;
}

void Geometry::State::add_normals(std::span<MeetingRay> rays) const {
  std::array<Hit*, most_in_packet> waiting;
  std::size_t count = 0;
  for (MeetingRay& r : rays) {
    if (!r.met) continue;
    Hit& hit = r.hit;
    if (hit.depth > 0) {
      orient(hit);
    } else if (hit.store->nearest_together != nullptr) {
      waiting[count++] = &hit;
    } else {
      hit.n = hit.store->normal(hit.shape, hit.p, hit.part);
      orient(hit);
    }
  }
  std::span<Hit*> open = std::span(waiting).first(count);
  while (!open.empty()) {
    const Hit& one = *open.front();
    const auto others = std::partition(open.begin(), open.end(), [&](const Hit* hit) {
      return hit->store == one.store && hit->shape == one.shape;
    });
    const auto same = static_cast<std::size_t>(others - open.begin());
    add_normals_of_shape(open.first(same));
    open = open.subspan(same);
  }
}

void Geometry::State::add_normals_of_shape(std::span<Hit* const> hits) const {
  PacketPoints points;
  for (const Hit* hit : hits) points.add(hit->p, hit->part);
  points.fill_up();
  PacketVectors normals;
  hits.front()->store->normals(hits.front()->shape, points, normals);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    hits[i]->n = normals[i];
    orient(*hits[i]);
  }
}

}  // namespace durer::tracer
