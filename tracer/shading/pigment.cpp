#include "tracer/shading/pigment.h"

#include <algorithm>
#include <array>
#include <new>

#include "tracer/patterns/map_search.h"

namespace durer::tracer {
namespace {

// Weights are double, differences and what is added are float: these are the oracle's last bits.
Colour mix(const Colour& a, const Colour& b, double t) {
  const auto between = [t](float from, float to) {
    return from + static_cast<float>(t * static_cast<double>(to - from));
  };
  return {{between(a.rgb.x, b.rgb.x), between(a.rgb.y, b.rgb.y), between(a.rgb.z, b.rgb.z)},
           between(a.filter, b.filter),
           between(a.transmit, b.transmit)};
}

bool has_quick_colour(const scene::Pigment& pigment) {
  const vec3 c = pigment.quick_colour.rgb;
  return c.x != -1 && c.y != -1 && c.z != -1;
}

bool opaque_colour(const Colour& c) { return c.filter == 0 && c.transmit == 0; }

}  // namespace

PigmentId PigmentStore::add(const scene::Pigment& pigment, const Transform& to_world) {
  Node node;
  const bool quick = quick_ && has_quick_colour(pigment);
  node.colour = quick ? pigment.quick_colour : pigment.colour;
  const auto id = static_cast<PigmentId>(nodes_.size());
  nodes_.push_back(node);
  if (quick || !pigment.pattern->exists()) return id;
  if (pigment.entries.empty() && pigment.pattern->image == nullptr) return id;

  std::vector<Entry> entries;
  for (const scene::PigmentEntry& e : pigment.entries) {
    // Entries see the point as the outer pattern has warped it (textures §11.3).
    const bool nested = e.pigment != scene::none;
    const PigmentId child = nested ? add(pigment.children[e.pigment], {}) : scene::none;
    entries.push_back({e.key, child, e.colour});
  }
  node.by_uv = pigment.uv_mapping;
  node.pattern = patterns_.compile(*pigment.pattern, node.by_uv ? Transform{} : to_world);
  node.first_entry = static_cast<std::uint32_t>(entries_.size());
  entries_.insert(entries_.end(), entries.begin(), entries.end());
  node.end_entry = static_cast<std::uint32_t>(entries_.size());
  node.flat = !entries.empty() && !node.pattern.type->averages &&
              std::all_of(entries.begin(), entries.end(),
                          [](const Entry& e) { return e.child == scene::none; });
  nodes_[id] = node;
  return id;
}

Colour PigmentStore::at(PigmentId id, const dvec3& p, const SurfaceView* view) const {
  const Node& node = nodes_[id];
  if (node.pattern.type == nullptr) return node.colour;
  const dvec3 warped = patterns_.warp(node.pattern, place(node, p, view));
  if (node.pattern.type->colour != nullptr) {
    return node.pattern.type->colour(node.pattern.state, warped);
  }
  return select(node, PatternStore::value(node.pattern, warped, view), warped, view);
}

void PigmentStore::at(PigmentId id, std::span<dvec3> points, Colour* out) const {
  const Node& node = nodes_[id];
  if (node.pattern.type == nullptr) {
    std::fill_n(out, points.size(), node.colour);
    return;
  }
  patterns_.warp(node.pattern, points);
  if (node.pattern.type->colour != nullptr) {
    for (const dvec3& p : points) *out++ = node.pattern.type->colour(node.pattern.state, p);
    return;
  }
  std::array<double, most_points> values;
  PatternStore::values(node.pattern, points, values.data());
  if (node.flat) {
    const std::span entries(&entries_[node.first_entry], node.end_entry - node.first_entry);
    for (std::size_t i = 0; i < points.size(); ++i) blend(entries, values[i], out[i]);
    return;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    ::new (out + i) Colour(select(node, values[i], points[i], nullptr));  // made in place
  }
}

bool PigmentStore::covers(PigmentId id, const dvec3& p, const SurfaceView* view) const {
  const Node& node = nodes_[id];
  if (node.pattern.type == nullptr) return true;
  const dvec3 warped = patterns_.warp(node.pattern, place(node, p, view));
  if (node.pattern.type->covers != nullptr) {
    return node.pattern.type->covers(node.pattern.state, warped);
  }
  // A blend shows something where any of its parts does.
  const std::span entries(&entries_[node.first_entry], node.end_entry - node.first_entry);
  const auto shows = [&](const Entry& e) {
    return e.child == scene::none || covers(e.child, warped, view);
  };
  if (node.pattern.type->averages) return std::any_of(entries.begin(), entries.end(), shows);
  const auto found = find_neighbours(entries, PatternStore::value(node.pattern, warped, view));
  return shows(*found.lower) || (!found.single() && shows(*found.upper));
}

double PigmentStore::pattern_value(PigmentId id, dvec3 p) const {
  const Node& node = nodes_[id];
  if (node.pattern.type == nullptr) return 0;
  return PatternStore::value(node.pattern, patterns_.warp(node.pattern, p));
}

void PigmentStore::blend(std::span<const Entry> entries, double value, Colour& out) {
  const auto found = find_neighbours(entries, value);
  if (found.single()) {
    ::new (&out) Colour(found.lower->colour);
  } else {
    ::new (&out) Colour(mix(found.lower->colour, found.upper->colour, found.t));
  }
}

Colour PigmentStore::select(const Node& node, double value, const dvec3& p,
                            const SurfaceView* view) const {
  const std::span entries(&entries_[node.first_entry], node.end_entry - node.first_entry);
  if (node.pattern.type->averages) return average(entries, p, view);
  const auto found = find_neighbours(entries, value);
  const Colour lower = entry_colour(*found.lower, p, view);
  if (found.single()) return lower;
  return mix(lower, entry_colour(*found.upper, p, view), found.t);
}

Colour PigmentStore::average(std::span<const Entry> entries, const dvec3& p,
                             const SurfaceView* view) const {
  Colour sum;
  float total = 0;
  for (const Entry& e : entries) {
    const Colour c = entry_colour(e, p, view);
    sum.rgb += e.key * c.rgb;
    sum.filter += e.key * c.filter;
    sum.transmit += e.key * c.transmit;
    total += e.key;
  }
  return {sum.rgb / total, sum.filter / total, sum.transmit / total};
}

Colour PigmentStore::entry_colour(const Entry& entry, const dvec3& p,
                                  const SurfaceView* view) const {
  return entry.child == scene::none ? entry.colour : at(entry.child, p, view);
}

bool PigmentStore::opaque(PigmentId id) const {
  const Node& node = nodes_[id];
  if (node.pattern.type == nullptr) return opaque_colour(node.colour);
  if (node.pattern.type->colour != nullptr) return node.pattern.type->opaque(node.pattern.state);
  for (std::uint32_t i = node.first_entry; i < node.end_entry; ++i) {
    const Entry& e = entries_[i];
    if (!(e.child == scene::none ? opaque_colour(e.colour) : opaque(e.child))) return false;
  }
  return true;
}

}  // namespace durer::tracer
