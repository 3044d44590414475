#include "tracer/shading/pigment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tracer/patterns/function.h"
#include "tracer/patterns/patterns.h"

namespace durer::tracer {
namespace {

// sin(2πv), odd by construction (textures §2.8).
double cycle(double v) {
  const double a = std::abs(v);
  return std::copysign(1.0, v) * std::sin(2 * std::numbers::pi * (a - std::floor(a)));
}

double triangle(double v) {
  const double o = v - std::floor(v);
  return o < 0.5 ? 2 * o : 2 * (1 - o);
}

// Keeps points representable for the patterns' whole-number arithmetic; NaN becomes a bound.
dvec3 clamp_point(dvec3 p) {
  constexpr double limit = 1e17;
  for (int i = 0; i < 3; ++i) p[i] = std::min(limit, std::max(-limit, p[i]));
  return p;
}

// Weights are double, differences and what is added are float: these are the oracle's last bits.
Colour mix(const Colour& a, const Colour& b, double t) {
  const auto between = [t](float from, float to) {
    return from + static_cast<float>(t * static_cast<double>(to - from));
  };
  return {{between(a.rgb.x, b.rgb.x), between(a.rgb.y, b.rgb.y), between(a.rgb.z, b.rgb.z)},
          between(a.filter, b.filter),
          between(a.transmit, b.transmit)};
}

bool opaque_colour(const Colour& c) { return c.filter == 0 && c.transmit == 0; }

}  // namespace

double shape_wave(scene::Wave wave, float exponent, double value) {
  switch (wave) {
    case scene::Wave::ramp: return value;
    case scene::Wave::sine: return (1 + cycle(value)) / 2;
    case scene::Wave::triangle: return triangle(value);
    case scene::Wave::scallop: return std::abs(cycle(value / 2));
    case scene::Wave::cubic: return value * value * (3 - 2 * value);
    case scene::Wave::poly: return std::pow(value, static_cast<double>(exponent));
  }
  return value;
}

PigmentId PigmentStore::add(const scene::Pigment& pigment, const Transform& to_world) {
  Node node;
  node.colour = pigment.colour;
  const auto id = static_cast<PigmentId>(nodes_.size());
  nodes_.push_back(node);
  if (pigment.pattern == scene::none) return id;

  const Transform placed = pigment.transform.then(to_world);
  std::vector<Entry> entries;
  for (const scene::PigmentEntry& e : pigment.entries) {
    // Entries see the point that the outer pattern sees, hence its transform too (textures §11.3).
    const bool nested = e.pigment != scene::none;
    const PigmentId child = nested ? add(pigment.children[e.pigment], placed) : scene::none;
    entries.push_back({e.key, child, e.colour});
  }
  node.pattern = pattern_types()[pigment.pattern];
  node.pattern->prepare(pigment.args, node.state);
  if (pigment.function) {
    patterns::bind_function(node.state, *pigment.function, 2);
    functions_.push_back(pigment.function);
  }
  node.moved = !placed.is_identity();
  node.to_pattern = placed.backward;
  node.wave = pigment.wave;
  node.frequency = pigment.frequency;
  node.phase = pigment.phase;
  node.wave_exponent = pigment.wave_exponent;
  node.first_entry = static_cast<std::uint32_t>(entries_.size());
  entries_.insert(entries_.end(), entries.begin(), entries.end());
  node.end_entry = static_cast<std::uint32_t>(entries_.size());
  if (entries.empty()) node.pattern = nullptr;
  nodes_[id] = node;
  return id;
}

Colour PigmentStore::at(PigmentId id, dvec3 p) const {
  const Node& node = nodes_[id];
  if (node.pattern == nullptr) return node.colour;
  return select(node, value(node, p), p);
}

double PigmentStore::pattern_value(PigmentId id, dvec3 p) const {
  const Node& node = nodes_[id];
  return node.pattern == nullptr ? 0 : value(node, p);
}

double PigmentStore::value(const Node& node, dvec3 p) const {
  const dvec3 q = clamp_point(node.moved ? node.to_pattern.point(p) : p);
  double v = node.pattern->evaluate(node.state, q);
  // The modulus is a little above 1 so that the value 1 stays 1 and finds the last entry.
  if (node.frequency != 0) v = std::fmod(v * node.frequency + node.phase, 1.00001);
  if (v < 0) v -= std::floor(v);
  return shape_wave(node.wave, node.wave_exponent, v);
}

// Entries are searched as written, never sorted (textures §11.1).
Colour PigmentStore::select(const Node& node, double value, dvec3 p) const {
  const Entry* const last = &entries_[node.end_entry - 1];
  if (!(value < last->key)) return entry_colour(*last, p);
  const Entry* lower = &entries_[node.first_entry];
  const Entry* upper = lower;
  while (value > upper->key) lower = upper++;
  if (value == upper->key || lower == upper) return entry_colour(*upper, p);
  const double span = static_cast<double>(upper->key) - lower->key;
  const double t = (value - lower->key) / span;
  return mix(entry_colour(*lower, p), entry_colour(*upper, p), t);
}

Colour PigmentStore::entry_colour(const Entry& entry, dvec3 p) const {
  return entry.child == scene::none ? entry.colour : at(entry.child, p);
}

bool PigmentStore::opaque(PigmentId id) const {
  const Node& node = nodes_[id];
  if (node.pattern == nullptr) return opaque_colour(node.colour);
  for (std::uint32_t i = node.first_entry; i < node.end_entry; ++i) {
    const Entry& e = entries_[i];
    if (!(e.child == scene::none ? opaque_colour(e.colour) : opaque(e.child))) return false;
  }
  return true;
}

}  // namespace durer::tracer
