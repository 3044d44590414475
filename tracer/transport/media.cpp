#include "tracer/transport/media.h"

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "tracer/random.h"

namespace durer::tracer {
namespace {

bool black(vec3 c) { return c == vec3(0.0F); }

// Depths beyond which nothing is left in single precision.
bool black_behind(vec3 depth) {
  constexpr float most = 104;
  return depth.x > most && depth.y > most && depth.z > most;
}

}  // namespace

MediaIntegrator::MediaIntegrator(Tracer& tracer, const Ray& ray, double depth,
                                 const Setting& setting)
    : tracer_(tracer),
      scene_(*tracer.scene_),
      scratch_(*tracer.scratch_),
      ray_(ray),
      length_(depth),
      setting_(setting),
      first_(static_cast<std::uint32_t>(scratch_.media.size())),
      end_(first_) {}

MediaIntegrator::~MediaIntegrator() { scratch_.media.resize(first_); }

void MediaIntegrator::add(MediaRange range) {
  for (std::uint32_t i = range.first; i < range.end; ++i) scratch_.media.push_back(i);
  end_ = static_cast<std::uint32_t>(scratch_.media.size());
}

const MediaProgram& MediaIntegrator::media(std::uint32_t i) const {
  return scene_.media[scratch_.media[i]];
}

MediaEffect MediaIntegrator::integrate() {
  MediaEffect effect;
  if (first_ == end_) return effect;
  find_leader();
  if (setting_.shadow && !dims_) return effect;
  each_interval([&](const Interval& interval) {
    integrate(interval, effect);
    return !black_behind(effect.depth);
  });
  effect.kept = glm::exp(-effect.depth);
  return effect;
}

// The stretches that are sampled on their own, front to back (participating-and-global §1.6).
template <typename Visit>
void MediaIntegrator::each_interval(Visit visit) {
  const auto divide = [&](const LitPart& part, int count) {
    const double length = (part.to - part.from) / count;
    for (int i = 0; i < count; ++i) {
      if (!visit(Interval{part.from + i * length, length, part.lit})) return false;
    }
    return true;
  };
  if (setting_.shadow) {
    divide({0, length_, false}, leader_->has_density ? leader_->intervals : 1);
    return;
  }
  find_parts();
  const std::vector<LitPart>& parts = scratch_.lit_parts;
  const auto n = static_cast<int>(parts.size());
  const int wanted = std::max(leader_->intervals, n);
  if (n == 1) {
    const bool whole = !parts[0].lit && !leader_->has_density;
    divide(parts[0], whole ? 1 : wanted);
    return;
  }
  double sum = 0;
  const auto weight = [&](const LitPart& p) { return p.lit ? leader_->ratio : 1 - leader_->ratio; };
  for (const LitPart& p : parts) sum += weight(p);
  int left = wanted;
  for (int i = 0; i < n; ++i) {
    const LitPart part = parts[static_cast<std::size_t>(i)];
    const int share = static_cast<int>(weight(part) / sum * wanted) + 1;
    const int count = std::min(share, left - n + i + 1);
    if (!divide(part, count)) return;
    left -= count;
  }
}

void MediaIntegrator::find_stretches(std::vector<Interval>& out) {
  out.clear();
  if (first_ == end_) return;
  find_leader();
  if (!scatters_ || !collects_) return;
  each_interval([&](const Interval& interval) {
    out.push_back(interval);
    return true;
  });
}

void MediaIntegrator::find_leader() {
  leader_ = &media(first_);
  aa_threshold_ = static_cast<float>(leader_->aa_threshold);
  for (std::uint32_t i = first_; i < end_; ++i) {
    const MediaProgram& m = media(i);
    if (m.intervals > leader_->intervals) leader_ = &m;
    aa_threshold_ = std::min(aa_threshold_, static_cast<float>(m.aa_threshold));
    constant_ = constant_ && m.constant;
    varies_ = varies_ || m.varies;
    scatters_ = scatters_ || m.scatters;
    dims_ = dims_ || m.dims;
    collects_ = collects_ || m.collects;
    isotropic_ = isotropic_ && m.phase == scene::Phase::isotropic;
  }
  matter_ = {};
  for (std::uint32_t i = first_; i < end_ && !varies_; ++i) {
    if (!setting_.shadow || media(i).dims) matter_.add(media(i), media(i).density);
  }
  has_photons_ = !setting_.shadow && scatters_ && collects_ && scratch_.photons != nullptr &&
                 !scratch_.photons->media.empty();
}

void MediaIntegrator::find_parts() {
  scratch_.lamp_spans.clear();
  scratch_.lit_parts.clear();
  find_lit_parts(scene_.lights, setting_.lamps, ray_, length_, scratch_.lamp_spans,
                 scratch_.lit_parts);
}

void MediaIntegrator::integrate(const Interval& interval, MediaEffect& effect) {
  Sample s;
  const bool lit = (interval.lit && scatters_) || has_photons_;
  if (!varies_ && !lit && leader_->method == 3) {
    s = uniform(interval);
  } else if (leader_->method != 3 || (setting_.shadow && constant_)) {
    s = sampled(interval);
  } else {
    s = adaptive(interval);
  }
  effect.added += s.colour * glm::exp(-effect.depth);
  effect.depth += s.depth;
}

// Methods 1 and 2 (participating-and-global §1.8): samples at random, or one in each of so many
// equal parts; then more at random, until the mean is known well enough.
MediaIntegrator::Sample MediaIntegrator::sampled(const Interval& interval) {
  const MediaProgram& m = *leader_;
  const int first = setting_.shadow && constant_ ? 1 : m.min_samples;
  Sample sum;
  vec3 squares(0.0F);
  const auto take = [&](double u) {
    const Sample s = dimmed(interval, u);
    sum.colour += s.colour;
    sum.depth += s.depth;
    squares += s.colour * s.colour;
  };
  for (int j = 0; j < first; ++j) {
    const double r = random();
    take(m.method == 1 ? r : (j + 0.5 + r * m.jitter) / m.min_samples);
  }
  int n = first;
  const auto uncertain = [&] {
    const auto count = static_cast<float>(n);
    const vec3 mean = sum.colour / count;
    const vec3 v = (squares / count - mean * mean) / count;
    const auto most = static_cast<float>(m.thresholds[static_cast<std::size_t>(n - 1)]);
    return v.x >= most || v.y >= most || v.z >= most;
  };
  if (!setting_.shadow && n < m.max_samples) {
    while (n <= m.max_samples && uncertain()) {
      take(random());
      ++n;
    }
  }
  const auto count = static_cast<float>(n);
  return {0, sum.colour / count, sum.depth / count};
}

// As methods 1 and 2 have it: seen through the interval's own depth before it.
MediaIntegrator::Sample MediaIntegrator::dimmed(const Interval& interval, double u) {
  Sample s = at(interval, u);
  if (!black(s.colour)) s.colour *= glm::exp(s.depth * static_cast<float>(-u));
  return s;
}

double MediaIntegrator::random() { return next_random(scratch_.noise); }

// ---- the tracer's questions

MediaEffect Tracer::media_along(const Path& path, double depth, const Hit* hit) {
  const std::uint32_t set =
      hit == nullptr ? 0 : scene_->surfaces[scene_->geometry.leaves()[hit->leaf].surface].lamps;
  const MediaIntegrator::Setting setting{.inside = path.inside,
                                         .lamps = scene_->geometry.lamp_sets()[set],
                                         .gathering = path.bounce > 0};
  MediaEffect effect;
  if (!scene_->air_media.empty()) {
    MediaIntegrator air(*this, path.ray, depth, setting);
    air.add(scene_->air_media);
    effect = air.integrate();
  }
  if (hit == nullptr || path.inside.empty()) return effect;
  MediaIntegrator bodies(*this, path.ray, depth, setting);
  for (const std::uint32_t id : path.inside.ids()) bodies.add(scene_->interiors[id].media);
  const MediaEffect inner = bodies.integrate();
  effect.added += effect.kept * inner.added;
  effect.kept *= inner.kept;
  return effect;
}

vec3 Tracer::light_through_bodies(const Ray& ray, double depth, const Containment& inside) {
  if (inside.empty() || !in_the_open(inside)) return vec3(1.0F);
  MediaIntegrator bodies(*this, ray, depth, {.inside = inside, .shadow = true});
  for (const std::uint32_t id : inside.ids()) bodies.add(scene_->interiors[id].media);
  return bodies.integrate().kept;
}

vec3 Tracer::light_through_air(const Ray& ray, double depth, const Containment& inside) {
  MediaIntegrator air(*this, ray, depth, {.inside = inside, .shadow = true});
  air.add(scene_->air_media);
  return air.integrate().kept;
}

}  // namespace durer::tracer
