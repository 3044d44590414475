#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "base/roots/bernstein.h"
#include "tracer/primitives/blob_line.h"
#include "tracer/primitives/describe.h"
#include "tracer/primitives/shared_data.h"

namespace durer::tracer {
namespace {

// The surface where the fields of all components add up to the threshold (objects §10.6).
struct Blob {
  std::shared_ptr<const BlobData> data;

  static constexpr double far = t_far;
  static constexpr double nearest_seen = 1e-2;  // in world units (objects §3)

  [[nodiscard]] Bounds3 bounds() const { return data->seen; }
  [[nodiscard]] Bounds3 inside_bounds() const {
    return data->threshold < 1e-6 ? Bounds3::everything() : data->seen;
  }
  [[nodiscard]] bool begins_inside(const Ray& /*ray*/) const { return data->threshold < 1e-6; }
  [[nodiscard]] bool contains(dvec3 p) const {
    double sum = 0;
    data->each_near(p, [&](const BlobComponent& c) { sum += c.field(p); });
    return sum > data->threshold - 1e-6;
  }
  [[nodiscard]] dvec3 normal(dvec3 p, std::uint32_t /*part*/) const {
    const dvec3 sum = data->fall(p);
    return sum == dvec3(0.0) ? dvec3(1, 0, 0) : sum;
  }
  // Components that have no texture look like the blob.
  [[nodiscard]] TextureBlend textures(dvec3 p, std::uint32_t /*part*/) const {
    TextureBlend blend;
    if (!data->textured) return blend;
    double sum = 0;
    data->each_near(p, [&](const BlobComponent& c) {
      const double weight = std::abs(c.field(p));
      if (weight == 0) return;
      sum += weight;
      for (std::uint32_t k = 0; k < blend.count; ++k) {
        if (blend.parts[k].texture != c.texture) continue;
        blend.parts[k].weight += static_cast<float>(weight);
        return;
      }
      blend.add(c.texture, static_cast<float>(weight));
    });
    for (std::uint32_t k = 0; k < blend.count; ++k) {
      blend.parts[k].weight /= static_cast<float>(sum);
    }
    return blend;
  }

  void crossings(const Ray& ray, Crossings& out) const {
    BlobLine& line = BlobLine::of_thread(-no_hit_depth, no_hit_depth);
    data->gather(ray, BlobReach::whole, line);
    bool inside = begins_inside(ray);
    each_crossing(line, [&](double t) {
      inside = !inside;
      out.push_back({t, 0, 0, inside ? Side::enter : Side::exit, true});
      return true;
    });
  }
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const {
    BlobLine& line = line_up(ray, std::max(t_from, nearest_seen), t_to);
    std::optional<Nearest> first;
    each_crossing(line, [&](double t) {
      if (t < t_to) first = Nearest{t, 0};
      return false;
    });
    return first;
  }
  [[nodiscard]] std::optional<Nearest> any(const Ray& ray, double t_from, double t_to) const {
    t_from = std::max(t_from, nearest_seen);
    if (!(t_from < t_to)) return std::nullopt;
    // Who is inside somewhere and ends outside has crossed the surface.
    const bool ends_outside = !data->bounds().contains(ray.at(t_to));
    bool found = false;
    if (ends_outside) {
      BlobLine& line = BlobLine::of_thread(t_from, t_to);
      found = data->gather(ray, BlobReach::any_full, line) || crosses(line);
    } else {
      found = crosses(line_up(ray, t_from, t_to));
    }
    if (!found) return std::nullopt;
    return Nearest{t_from, 0};
  }

 private:
  /// The line as far as its first crossing.
  [[nodiscard]] BlobLine& line_up(const Ray& ray, double t_from, double t_to) const {
    BlobLine& line = BlobLine::of_thread(t_from, t_to);
    data->gather(ray, BlobReach::to_first, line);
    if (line.t_to < t_to && line.field_at_begin() >= data->threshold) {
      // It begins inside, and so may go through full places before it comes out.
      BlobLine::of_thread(t_from, t_to);
      data->gather(ray, BlobReach::whole, line);
    }
    return line;
  }

  /// Calls f(t) for every crossing, ascending, until it returns false.
  template <typename F>
  void each_crossing(BlobLine& line, F&& f) const {
    sweep(
        line,
        [&](const Bernstein<4>& excess, double at, double end) {
          for (const double w : sign_changes<4>(excess)) {
            if (!f(at + (end - at) * w)) return false;
          }
          return true;
        },
        f);
  }
  [[nodiscard]] bool crosses(BlobLine& line) const {
    bool found = false;
    sweep(
        line,
        [&](const Bernstein<4>& excess, double, double) {
          found = has_sign_change<4>(excess);
          return !found;
        },
        [&](double) {
          found = true;
          return false;
        });
    return found;
  }

  /// Calls piece(excess, begin, end) for the pieces of the line between beginnings and ends of
  /// stretches, ascending, and jump(t) where the side changes between two of them; both return
  /// false to stop.
  template <typename Piece, typename Jump>
  void sweep(BlobLine& line, Piece&& piece, Jump&& jump) const {
    const std::vector<const BlobStretch*>& order = line.order;
    std::vector<const BlobStretch*>& active = line.active;
    const double outside = -data->threshold;  // the field less the threshold, away from components
    double before = outside;  // where the last piece ended
    double at = -std::numeric_limits<double>::infinity();
    for (std::size_t next = 0; next < order.size() || !active.empty();) {
      bool cut = false;  // it begins within components
      if (active.empty() && order[next]->begin > at) {
        at = order[next]->begin;
        before = outside;
        cut = at <= line.t_from;
      }
      while (next < order.size() && order[next]->begin <= at) active.push_back(order[next++]);
      double end = next < order.size() ? order[next]->begin : line.t_to;
      for (const BlobStretch* s : active) end = std::min(end, s->end);
      end = std::min(end, line.t_to);
      if (end > at) {
        Bernstein<4> sum = excess(active, at, end);
        // What the piece before it ended with: both must agree about the side.
        if (!cut) sum[0] = before;
        if (!piece(sum, at, end)) return;
        before = sum[4];
        at = end;
      }
      if (at >= line.t_to) return;
      std::erase_if(active, [at](const BlobStretch* s) { return s->end <= at; });
      // A gap follows, unless a rod goes on where its round end stops.
      const bool gap = active.empty() && !(next < order.size() && order[next]->begin <= at);
      if (gap && (before < 0) != (outside < 0) && !jump(at)) return;
    }
  }

  /// The field of these, less the threshold, over [a, b].
  [[nodiscard]] Bernstein<4> excess(const std::vector<const BlobStretch*>& active, double a,
                                    double b) const {
    Bernstein<4> sum{};
    for (const BlobStretch* s : active) {
      const double u0 = s->root_at(a);
      const double u1 = s->root_between(a, b);
      const double u2 = s->root_at(b);
      sum[0] += s->strength * (u0 * u0);
      sum[1] += s->strength * (u0 * u1);
      sum[2] += s->strength * ((u0 * u2 + 2 * (u1 * u1)) / 3);
      sum[3] += s->strength * (u1 * u2);
      sum[4] += s->strength * (u2 * u2);
    }
    for (double& x : sum) x -= data->threshold;
    return sum;
  }
};

enum : std::size_t { threshold_at, components_at };

constexpr std::array<scene::Param, components_at> blob_params = {
    scene::Param{"threshold", scene::ArgKind::number, "the sum of the fields at the surface"}};

std::shared_ptr<const BlobData> blob_of(std::span<const double> args) {
  auto data = std::make_shared<BlobData>(args[threshold_at], args.subspan(components_at));
  return data;
}

std::optional<ShapeRef> place_blob(TypeStores& stores, std::span<const double> args,
                                   const Transform& to_world, bool inverted) {
  auto data = shared_data<BlobData>(args, blob_of);
  if (data->seen.empty()) return std::nullopt;
  return place_shape(stores, Blob{std::move(data)}, to_world, inverted);
}

constexpr PrimitiveType describe_blob() {
  PrimitiveType type;
  type.name = "blob";
  type.doc = "Balls and rods that melt together.";
  type.params = blob_params;
  type.open_ended = true;
  type.validate = [](std::span<const double> args) -> std::optional<std::string> {
    if (blob_component_size(args.subspan(components_at)) > 0) return std::nullopt;
    return "a blob takes one component or more";
  };
  type.make_stores = [] { return make_type_stores<Blob>(); };
  type.place = place_blob;
  type.samples = [] {
    constexpr double own = scene::none;
    return std::vector<std::vector<double>>{{0.6, 0,   -0.5, 0, 0,  1, 1, own, 0, 0.5, 0,    0,  1,
                                             1,   own, 1,    0, -1, 0, 0, 1,   0, 0.5, -0.5, own},
                                            {0.5, 1, 0, 0, 0, 0, 1, 0, 1, 1, own},
                                            {0.3, 0, 0, 0, 0,   1, 1, own, 2, 0.3, 0.4, 0, 0.7, 2,
                                             own, 1, 0, 0, 0.4, 2, 0, 0,   0, 0.5, 0,   0, 0}};
  };
  return type;
}

}  // namespace

extern constinit const PrimitiveType blob_primitive = describe_blob();

}  // namespace durer::tracer
