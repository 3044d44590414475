#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "base/roots/bernstein.h"
#include "tracer/primitives/blob_field.h"
#include "tracer/primitives/describe.h"
#include "tracer/primitives/shared_data.h"

namespace durer::tracer {
namespace {

/// What all objects that show one blob share.
struct BlobData {
  double threshold = 1;
  std::vector<BlobComponent> components;
  BoxTree tree;
  Bounds3 bounds;
  bool textured = false;
};

/// Stretches of this thread's present line.
struct LineBuffers {
  std::vector<BlobStretch> stretches;
  std::vector<const BlobStretch*> active;
};
LineBuffers& line_buffers() {
  thread_local LineBuffers buffers;
  buffers.stretches.clear();
  buffers.active.clear();
  return buffers;
}

// The surface where the fields of all components add up to the threshold (objects §10.6).
struct Blob {
  std::shared_ptr<const BlobData> data;

  static constexpr double far = t_far;
  static constexpr double nearest_seen = 1e-2;  // in world units (objects §3)

  [[nodiscard]] Bounds3 bounds() const { return data->bounds; }
  [[nodiscard]] Bounds3 inside_bounds() const {
    return data->threshold < 1e-6 ? Bounds3::everything() : data->bounds;
  }
  [[nodiscard]] bool begins_inside(const Ray& /*ray*/) const { return data->threshold < 1e-6; }
  [[nodiscard]] bool contains(dvec3 p) const {
    double sum = 0;
    data->tree.at(p, [&](std::uint32_t i) { sum += data->components[i].field(p); });
    return sum > data->threshold - 1e-6;
  }
  [[nodiscard]] dvec3 normal(dvec3 p, std::uint32_t /*part*/) const {
    dvec3 sum(0.0);
    data->tree.at(p, [&](std::uint32_t i) { sum += data->components[i].fall(p); });
    return sum == dvec3(0.0) ? dvec3(1, 0, 0) : sum;
  }
  // Components that have no texture look like the blob.
  [[nodiscard]] TextureBlend textures(dvec3 p, std::uint32_t /*part*/) const {
    TextureBlend blend;
    if (!data->textured) return blend;
    double sum = 0;
    data->tree.at(p, [&](std::uint32_t i) {
      const BlobComponent& c = data->components[i];
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

  /// Calls f(t) for every crossing from t_from on, ascending, until it returns false; earlier ones
  /// may be among them.
  template <typename F>
  void each_crossing(const Ray& ray, double t_from, double t_to, F&& f) const {
    LineBuffers& buffers = line_buffers();
    std::vector<BlobStretch>& stretches = buffers.stretches;
    std::vector<const BlobStretch*>& active = buffers.active;
    // Not up to t_to: where pieces end, and so the last bits of a root, must not depend on it.
    data->tree.along(ray, t_from, no_hit_depth, [&](std::uint32_t i) {
      data->components[i].append_stretches(ray, stretches);
    });
    std::sort(stretches.begin(), stretches.end(),
              [](const BlobStretch& a, const BlobStretch& b) { return a.begin < b.begin; });
    double before = -data->threshold;  // field less threshold, where the last piece ended
    double at = -std::numeric_limits<double>::infinity();
    for (std::size_t next = 0; next < stretches.size() || !active.empty();) {
      if (active.empty() && stretches[next].begin > at) {
        at = stretches[next].begin;
        before = -data->threshold;
      }
      while (next < stretches.size() && stretches[next].begin <= at)
        active.push_back(&stretches[next++]);
      double end =
          next < stretches.size() ? stretches[next].begin : std::numeric_limits<double>::infinity();
      for (const BlobStretch* s : active) end = std::min(end, s->end);
      if (end > at) {
        Bernstein<4> sum = excess(active, at, end);
        sum[0] = before;  // what the piece before it ended with: both must agree about the side
        for (const double w : sign_changes<4>(sum)) {
          if (!f(at + (end - at) * w)) return;
        }
        before = sum[4];
        at = end;
        if (at > t_to) return;
      }
      std::erase_if(active, [at](const BlobStretch* s) { return s->end <= at; });
      // A gap follows, unless a rod goes on where its round end stops.
      const bool gap = active.empty() && !(next < stretches.size() && stretches[next].begin <= at);
      if (gap && (before < 0) != (-data->threshold < 0) && !f(at)) return;
    }
  }
  void crossings(const Ray& ray, Crossings& out) const {
    bool inside = begins_inside(ray);
    each_crossing(ray, -no_hit_depth, no_hit_depth, [&](double t) {
      inside = !inside;
      out.push_back({t, 0, 0, inside ? Side::enter : Side::exit, true});
      return true;
    });
  }
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const {
    std::optional<Nearest> best;
    t_from = std::max(t_from, nearest_seen);
    each_crossing(ray, t_from, t_to, [&](double t) {
      if (t >= t_from && t < t_to) best = Nearest{t, 0};
      return t < t_from;
    });
    return best;
  }

 private:
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
  auto data = std::make_shared<BlobData>();
  data->threshold = args[threshold_at];
  data->components = blob_components(args.subspan(components_at));
  std::vector<Bounds3> boxes;
  for (const BlobComponent& c : data->components) {
    boxes.push_back(c.reach);
    data->bounds.add(c.seen);
    data->textured = data->textured || c.texture != scene::none;
  }
  data->tree = BoxTree(boxes);
  return data;
}

std::optional<ShapeRef> place_blob(TypeStores& stores, std::span<const double> args,
                                   const Transform& to_world, bool inverted) {
  auto data = shared_data<BlobData>(args, blob_of);
  if (data->bounds.empty()) return std::nullopt;
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
