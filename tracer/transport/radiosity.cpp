#include "tracer/transport/radiosity.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "tracer/random.h"
#include "tracer/transport/trace.h"

namespace durer::tracer {
std::vector<dvec3> cosine_directions(int count) {
  std::vector<dvec3> all;
  all.reserve(static_cast<std::size_t>(count));
  for (std::uint32_t i = 1; i <= static_cast<std::uint32_t>(count); ++i) {
    const double a = radical_inverse(i, 2);
    const double phi = 2 * std::numbers::pi * radical_inverse(i, 3);
    const double r = std::sqrt(a);
    all.push_back({r * std::cos(phi), std::sqrt(1 - a), r * std::sin(phi)});
  }
  return all;
}

RadiosityProgram::RadiosityProgram(const scene::Scene& scene)
    : settings(*scene.settings.radiosity),
      camera(scene.camera.location),
      directions(cosine_directions(settings.pool)) {
  const float least = static_cast<float>(settings.adc_bailout + epsilon);
  int max_level = std::clamp(scene.settings.max_trace_level, 1, 256);
  for (int depth = 0; depth < settings.recursion_limit; ++depth) {
    Bounce b;
    b.error_factor = std::ldexp(1.0, depth);
    b.rays = std::min(std::max(5, static_cast<int>(settings.count / b.error_factor)), settings.pool);
    b.needed = depth == 0   ? settings.nearest_count
               : depth == 1 ? std::min(2, settings.nearest_count)
                            : 1;
    b.first_level = static_cast<int>(1.5 * (depth + 1));
    max_level = b.max_level = std::max(max_level, b.first_level + 1);
    b.weight = std::max(least, static_cast<float>(std::pow(settings.brightness / 2, depth + 1)));
    bounces.push_back(b);
  }
}

vec3 RadiosityProgram::finished(dvec3 light) const {
  const auto gray = static_cast<float>(settings.gray_threshold);
  const vec3 c(light);
  return static_cast<float>(settings.brightness) * ((1 - gray) * c + gray * grey(c));
}

double RadiosityProgram::reach(const IrradianceSample& s) const {
  // Later bounces have so many samples that looking at all costs more than gathering now and then
  // what somebody farther away might have told.
  constexpr double found_later = 0.25;
  return s.radius * settings.error_bound * std::max(1.0, settings.low_error_factor) *
         bounces[s.depth].error_factor * (s.depth == 0 ? 1 : found_later);
}

Hemisphere::Hemisphere(dvec3 n) : x_(1, 0, 0), y_(0, 1, 0), z_(0, 0, 1) {
  if (n.y > 0.999) return;
  if (n.y < -0.999) {
    x_ = -x_;
    y_ = -y_;
    z_ = -z_;
    return;
  }
  const dvec3 beside = std::abs(n.z) > 0.9 ? dvec3(0, 1, 0) : dvec3(0, 0, 1);
  x_ = glm::normalize(glm::cross(n, beside));
  y_ = n;
  z_ = glm::normalize(glm::cross(x_, n));
}

void RadiosityState::begin(const IrradianceCache* all, bool final, std::uint32_t seed,
                           std::uint32_t pool) {
  known = all;
  fresh.clear();
  final_pass = final;
  for (std::uint32_t d = 0; d < next_direction.size(); ++d) {
    next_direction[d] = mixed(seed + 0x9E3779B9U * d) % pool;
  }
  ray_quality = 1;
  top_weight = 0;
  top_queries = 0;
}

// Light of the surroundings that a layer throws back (participating-and-global §2.2).
vec3 Tracer::indirect_part(const View& view, const Path& path, const LayerPoint& layer,
                           vec3 through, Indirect& known) {
  const Finish& f = *layer.finish;
  const float seen = grey(through * layer.pigment) * layer.opacity;
  const auto side = [&](float share, bool back, vec3& light, bool& is_known) {
    if (share == 0 || !(seen * share > limits(path).adc)) return vec3(0.0F);
    if (!is_known) {
      View turned = view;
      if (back) turned.g = -turned.g;
      light = indirect(turned, back ? -layer.n : layer.n, path.weight * seen * share, path.bounce);
      is_known = true;
    }
    return share * light;
  };
  const vec3 front = side(f.indirect, false, known.front, known.front_known);
  const vec3 back = side(f.indirect_back, true, known.back, known.back_known);
  return layer.opacity * layer.pigment * (front + back);
}

// What reaches one side of a surface from all around, by reflection from other surfaces
// (participating-and-global §2.4).
vec3 Tracer::indirect(const View& view, dvec3 layer_normal, float weight, std::uint32_t depth) {
  // Weight, in samples needed, at which later bounces stop to look for more samples.
  constexpr double plenty = 1;
  const RadiosityProgram& program = *scene_->radiosity;
  const scene::Radiosity& settings = program.settings;
  const Bounce& bounce = program.bounces[depth];
  RadiosityState& state = scratch_->radiosity;

  double error = settings.error_bound * (state.final_pass ? 1 : settings.low_error_factor);
  if (weight < 0.25) error += 0.25 - weight;
  const IrradianceQuery query{view.p, settings.normal ? layer_normal : view.g,
                              error * bounce.error_factor, depth, state.final_pass && depth == 0,
                              depth == 0 ? HUGE_VAL : plenty * bounce.needed};
  IrradianceSum sum;
  if (state.known != nullptr) state.known->look_up(query, sum);
  state.fresh.look_up(query, sum);
  const bool enough = 4 * sum.weight >= bounce.needed ||
                      (state.final_pass && !settings.always_sample && sum.weight > 0);
  if (!enough) {
    const Gathered g = gather(query.p, view.g, query.n, depth);
    if (sum.weight > 0) {
      sum.light += g.quality * g.light;
      sum.weight += g.quality;
    } else {
      sum = {g.light, g.quality};
      if (g.quality > 0) sum.light *= g.quality;
    }
  }
  state.ray_quality = std::min(state.ray_quality, 4 * sum.weight / bounce.needed);
  if (depth == 0) {
    state.top_weight += 4 * sum.weight;
    ++state.top_queries;
  }
  return program.finished(sum.weight > 0 ? sum.light / sum.weight : sum.light);
}

namespace {

// The distances that gather rays met.
struct Distances {
  double nearest = std::numeric_limits<double>::infinity();
  dvec3 to_nearest{0.0};
  double inverse_sum = 0;

  void add(double distance, dvec3 d) {
    inverse_sum += 1 / distance;
    if (distance >= nearest) return;
    nearest = distance;
    to_nearest = d;
  }
};

vec3 clamped(vec3 c, double most) {
  const float greatest = std::max({c.x, c.y, c.z});
  return most > 0 && greatest > most ? c * (static_cast<float>(most) / greatest) : c;
}

}  // namespace

// Directions for one sample from the pool, those below the surface left out
// (participating-and-global §2.6).
class GatherDirections {
 public:
  GatherDirections(const RadiosityProgram& program, std::uint32_t& next, dvec3 raw, dvec3 bent,
                   int rays)
      : pool_(&program.directions),
        next_(&next),
        raw_(raw),
        bumpy_(raw != bent),
        about_(bent),
        tries_(std::min(5 * rays, static_cast<int>(pool_->size()))) {}

  dvec3 next() {
    while (bumpy_ && tries_ > 0) {
      --tries_;
      const dvec3 d = about_.direction(take());
      if (glm::dot(d, raw_) > 0) return d;
    }
    if (bumpy_) {
      bumpy_ = false;
      about_ = Hemisphere(raw_);
      exhausted_ = true;
    }
    ++plain_;
    return about_.direction(take());
  }
  /// How many directions were about the raw normal because no others were left.
  [[nodiscard]] int about_raw() const { return exhausted_ ? plain_ : 0; }

 private:
  dvec3 take() {
    const dvec3 d = (*pool_)[*next_];
    if (++*next_ == pool_->size()) *next_ = 0;
    return d;
  }

  const std::vector<dvec3>* pool_;
  std::uint32_t* next_;
  dvec3 raw_;
  bool bumpy_;
  bool exhausted_ = false;
  Hemisphere about_;
  int tries_;
  int plain_ = 0;
};

// Sends rays out over the hemisphere, and stores what they find (participating-and-global §2.5).
Tracer::Gathered Tracer::gather(dvec3 p, dvec3 raw, dvec3 n, std::uint32_t depth) {
  const RadiosityProgram& program = *scene_->radiosity;
  const scene::Radiosity& settings = program.settings;
  const Bounce& bounce = program.bounces[depth];
  RadiosityState& state = scratch_->radiosity;

  GatherDirections directions(program, state.next_direction[depth], raw, n, bounce.rays);
  Distances distances;
  dvec3 sum(0.0);
  dvec3 plain_sum(0.0);
  double quality = 0;
  const auto last = static_cast<float>(bounce.rays - 1);
  const double outer_quality = state.ray_quality;
  for (int i = 0; i < bounce.rays; ++i) {
    const dvec3 d = directions.next();
    FirstHit first;
    first.least_importance = static_cast<float>(i) / last;
    first.importance = static_cast<float>(settings.background_importance);
    Path path;
    path.ray = {p, d};
    path.weight = bounce.weight;
    path.level = bounce.first_level;
    path.bounce = depth + 1;
    path.first = &first;
    state.ray_quality = 1;
    const vec3 light = clamped(trace(path).colour, settings.max_sample);
    distances.add(first.distance, d);
    if (first.importance < first.least_importance) continue;
    double factor = 1;
    if (first.importance < 1) {
      factor = bounce.rays / (std::floor(double{first.importance} * last) + 1);
    }
    const double q = state.ray_quality * factor;
    sum += q * dvec3(light);
    plain_sum += factor * dvec3(light);
    quality += q;
  }
  state.ray_quality = outer_quality;

  Gathered g;
  g.light = quality > 0 ? sum / quality : plain_sum / static_cast<double>(bounce.rays);
  g.quality = quality / bounce.rays;
  const double scale = bounce.error_factor * glm::length(p - program.camera);
  const double most = settings.maximum_reuse * scale;
  if (distances.nearest > 0.0001 * most) {
    IrradianceSample s;
    s.p = p;
    s.n = 2 * directions.about_raw() > bounce.rays ? raw : n;
    s.to_nearest = distances.to_nearest;
    s.nearest = std::min(distances.nearest, no_hit_depth);
    s.radius = std::clamp(bounce.rays / distances.inverse_sum, settings.minimum_reuse * scale, most);
    s.light = vec3(g.light);
    s.quality = static_cast<float>(g.quality);
    s.depth = depth;
    state.fresh.add(s, program.reach(s));
  }
  return g;
}

}  // namespace durer::tracer
