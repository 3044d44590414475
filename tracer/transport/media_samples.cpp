// Samples of media along an interval (participating-and-global §1.9): many are looked at together.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/exponential.hpp>

#include "tracer/random.h"
#include "tracer/transport/media.h"

namespace durer::tracer {
namespace {

bool black(vec3 c) { return c == vec3(0.0F); }

float distance(vec3 a, vec3 b) {
  return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z);
}

// Steps of method 3, which leave out the last of `steps + 1` equal parts: as the oracle has it.
int steps_of(const MediaProgram& m) { return std::max(2, m.min_samples / 2 + 1); }

}  // namespace

// The share of an interval behind its last sample: half of the last part, for samples are shaken.
double MediaIntegrator::left_out() const { return 0.5 / (steps_of(*leader_) + 1); }

// What `adaptive` comes to where all samples are the same.
MediaIntegrator::Sample MediaIntegrator::uniform(const Interval& interval) {
  const int steps = steps_of(*leader_);
  const Sample s = at(interval, 0);
  if (black(s.colour)) return s;
  const vec3 dimming = glm::exp(-s.depth / static_cast<float>(steps));
  vec3 sum(0.0F);
  vec3 dim(1.0F);
  for (int j = 0; j < steps; ++j, dim *= dimming) sum += s.colour * dim;
  return {0, sum / static_cast<float>(steps), s.depth};
}

// Method 3: equal steps, each divided where samples differ.
MediaIntegrator::Sample MediaIntegrator::adaptive(const Interval& interval) {
  const MediaProgram& m = *leader_;
  MediaSamples& all = scratch_.media_samples[setting_.shadow ? 1 : 0];
  const auto steps = static_cast<std::uint32_t>(steps_of(m));
  const auto count = static_cast<float>(steps);
  const double step = 1.0 / (steps + 1);
  all.places.clear();
  all.stretches.clear();
  for (std::uint32_t j = 0; j <= steps; ++j) {
    const double shake = m.jitter == 0 ? 0 : step * m.jitter * (random() - 0.5);
    all.places.push_back({j * step + shake});
  }
  for (std::uint32_t j = 1; j <= steps; ++j) {
    all.stretches.push_back({.from = (j - 1) * step, .to = j * step, .first = j - 1, .last = j});
  }
  const std::size_t undivided = divide(interval, all);
  for (std::size_t i = all.stretches.size(); i-- > 0;) find_mean(all, i, i >= undivided);

  Sample sum;
  for (std::uint32_t j = 0; j < steps; ++j) {
    const MediaStretch& mean = all.stretches[j];
    sum.colour += mean.colour * glm::exp(-sum.depth / count);
    sum.depth += mean.depth;
  }
  return {0, sum.colour / count, sum.depth / count};
}

// Looks at the ends and the middle of every stretch, then at the middles of all halves whose ends
// differ, and so on. Returns the first of those that are not to be divided any more.
std::size_t MediaIntegrator::divide(const Interval& interval, MediaSamples& all) {
  const double jitter = leader_->jitter;
  std::size_t begin = 0;
  std::size_t known = 0;
  for (int level = leader_->aa_level - 1; begin < all.stretches.size(); --level) {
    const std::size_t end = all.stretches.size();
    for (std::size_t i = begin; i < end; ++i) {
      MediaStretch& s = all.stretches[i];
      const double mid = (s.from + s.to) / 2;
      s.middle = static_cast<std::uint32_t>(all.places.size());
      all.places.push_back({jitter == 0 ? mid : mid + jitter * (s.to - s.from) * (random() - 0.5)});
    }
    fill(interval, std::span(all.places).subspan(known));
    known = all.places.size();
    if (level <= 0) return begin;
    for (std::size_t i = begin; i < end; ++i) halve(all, i);
    begin = end;
  }
  return begin;
}

void MediaIntegrator::halve(MediaSamples& all, std::size_t index) const {
  const MediaStretch s = all.stretches[index];
  const double mid = (s.from + s.to) / 2;
  const auto differ = [&](std::uint32_t a, std::uint32_t b) {
    return distance(all.places[a].colour, all.places[b].colour) > aa_threshold_;
  };
  const auto next = [&] { return static_cast<std::uint32_t>(all.stretches.size()); };
  if (differ(s.first, s.middle)) {
    all.stretches[index].left = next();
    all.stretches.push_back({.from = s.from, .to = mid, .first = s.first, .last = s.middle});
  }
  if (differ(s.middle, s.last)) {
    all.stretches[index].right = next();
    all.stretches.push_back({.from = mid, .to = s.to, .first = s.middle, .last = s.last});
  }
}

// By Simpson-like weights that the oracle has chosen; the means of halves are known.
void MediaIntegrator::find_mean(MediaSamples& all, std::size_t index, bool undivided) {
  MediaStretch& s = all.stretches[index];
  const Sample& first = all.places[s.first];
  const Sample& mid = all.places[s.middle];
  const Sample& last = all.places[s.last];
  if (undivided) {
    s.colour = (first.colour + mid.colour + last.colour) / 3.0F;
    s.depth = (first.depth + mid.depth + last.depth) / 3.0F;
    return;
  }
  const auto half = [&](std::uint32_t stretch, const Sample& outer) {
    if (stretch != 0) {
      const MediaStretch& r = all.stretches[stretch];
      return Sample{0, r.colour / 2.0F, r.depth / 2.0F};
    }
    return Sample{0, outer.colour / 3.0F + mid.colour / 6.0F,
                  outer.depth / 3.0F + mid.depth / 6.0F};
  };
  const Sample left = half(s.left, first);
  const Sample right = half(s.right, last);
  s.colour = left.colour + right.colour;
  s.depth = left.depth + right.depth;
}

MediaIntegrator::Sample MediaIntegrator::at(const Interval& interval, double u) {
  Sample s{u};
  fill(interval, {&s, 1});
  return s;
}

void MediaIntegrator::fill(const Interval& interval, std::span<Sample> samples) {
  constexpr std::size_t most = MediaStore::most_points;
  const auto length = static_cast<float>(interval.length);
  for (; !samples.empty(); samples = samples.subspan(std::min(most, samples.size()))) {
    const std::span some = samples.first(std::min(most, samples.size()));
    std::array<double, most> t;
    std::array<dvec3, most> points;
    for (std::size_t i = 0; i < some.size(); ++i) {
      t[i] = interval.t + some[i].u * interval.length;
      points[i] = ray_.at(t[i]);
    }
    std::array<Matter, most> matter;
    const auto some_points = std::span<const dvec3>(points).first(some.size());
    if (varies_) find_matter(some_points, matter.data());
    if (!varies_) std::fill_n(matter.data(), some.size(), matter_);
    if (interval.lit && scatters_) add_scattered(t.data(), some_points, matter.data());
    for (std::size_t i = 0; i < some.size(); ++i) {
      Matter& m = matter[i];
      some[i].depth = m.extinction * length;
      if (setting_.shadow) continue;
      if (has_photons_ && !black(m.scattering)) m.emission += m.scattering * photons_at(points[i]);
      some[i].colour = m.emission * length;
    }
  }
}

// Of at most MediaStore::most_points.
void MediaIntegrator::find_matter(std::span<const dvec3> points, Matter* out) const {
  std::fill_n(out, points.size(), Matter());
  for (std::uint32_t i = first_; i < end_; ++i) {
    const MediaProgram& m = media(i);
    if (setting_.shadow && !m.dims) continue;
    std::array<vec3, MediaStore::most_points> density;
    scene_.media.densities(m, points, density.data());
    for (std::size_t k = 0; k < points.size(); ++k) out[k].add(m, density[k]);
  }
}

}  // namespace durer::tracer
