#include <cmath>
#include <memory>
#include <utility>

#include "tracer/primitives/describe.h"
#include "tracer/primitives/shared_data.h"
#include "tracer/primitives/swept.h"

namespace durer::tracer {
namespace {

struct GlyphOutline : Outline {
  using Outline::Outline;
};

// One character of a text: an outline in the plane of x and y, with thickness along z from 0 on
// (objects §10.15). The whole `text` is a union of these.
struct Glyph {
  std::shared_ptr<const GlyphOutline> outline;
  double depth = 1;

  // A negative depth leaves the two faces, and nothing between them.
  [[nodiscard]] bool solid() const { return depth > 0; }

  [[nodiscard]] Bounds3 bounds() const {
    constexpr double pad = 1e-6;
    Bounds3 b;
    b.add({outline->lo().x, outline->lo().y, std::min(0.0, depth) - pad});
    b.add({outline->hi().x, outline->hi().y, std::max(0.0, depth) + pad});
    return b;
  }
  [[nodiscard]] bool contains(dvec3 p) const {
    return p.z >= 0 && p.z <= depth && solid() && outline->contains({p.x, p.y});
  }
  [[nodiscard]] dvec3 normal(dvec3 p, std::uint32_t part) const {
    if (part < swept::first_side) return {0, 0, part == swept::low_end ? -1 : 1};
    const Arc& arc = outline->arc(part - swept::first_side);
    const dvec2 slope = arc.slope_near({p.x, p.y});
    return {slope.y, -slope.x, 0};
  }

  template <typename F>
  void each_crossing(const Ray& ray, F&& f) const {
    if (!solid()) {
      for (const std::uint32_t end : {swept::low_end, swept::high_end}) {
        const double t = ((end == swept::low_end ? 0 : depth) - ray.o.z) / ray.d.z;
        const dvec3 p = ray.at(t);
        if (outline->contains({p.x, p.y})) f(Crossing{t, 0, end, Side::sheet, true});
      }
      return;
    }
    const auto piece = swept::between(ray.o.z, ray.d.z, 0, depth);
    if (!piece) return;
    auto& sides = swept::empty_sides();
    bool inside = false;
    const dvec2 o(ray.o.x, ray.o.y);
    const dvec2 d(ray.d.x, ray.d.y);
    const double d2 = glm::dot(d, d);
    if (d2 <= 1e-20 * ray.d.z * ray.d.z) {
      inside = outline->contains(o);
    } else {
      outline->each_crossing({d.y, -d.x, o.y * d.x - o.x * d.y}, [&](std::uint32_t i, double w) {
        sides.push_back({glm::dot(outline->arc(i).at(w) - o, d) / d2, i + swept::first_side});
      });
    }
    swept::each_crossing(sides, inside, *piece, true, f);
  }
  void crossings(const Ray& ray, Crossings& out) const {
    each_crossing(ray, [&](const Crossing& c) { out.push_back(c); });
  }
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const {
    if (solid()) {
      const auto piece = swept::between(ray.o.z, ray.d.z, 0, depth);
      if (!piece) return std::nullopt;
      const dvec2 d(ray.d.x, ray.d.y);
      const bool upright = glm::dot(d, d) <= 1e-20 * ray.d.z * ray.d.z;
      return swept::nearest(*outline, {ray.o.x, ray.o.y}, d, upright, *piece, true, t_from, t_to);
    }
    std::optional<Nearest> best;
    each_crossing(ray, [&](const Crossing& c) {
      if (!(c.t >= t_from) || !(c.t < t_to)) return;
      best = Nearest{c.t, c.part};
      t_to = c.t;
    });
    return best;
  }
};

constexpr std::array<scene::Param, 1> text_params = {
    scene::Param{"depth", scene::ArgKind::number, "thickness along z"}};

// After the depth: arcs, each as its degree and its points; they follow each other, and degree 0
// goes to the first point of the next contour.
std::vector<Arc> arcs_of(std::span<const double> list) {
  std::vector<Arc> arcs;
  dvec2 at(0.0);
  for (std::size_t i = 0; i < list.size();) {
    const auto degree = static_cast<std::size_t>(list[i++]);
    if (i + 2 * std::max<std::size_t>(degree, 1) > list.size() || degree > 3) break;
    const auto point = [&] {
      i += 2;
      return dvec2(list[i - 2], list[i - 1]);
    };
    if (degree == 0) {
      at = point();
      continue;
    }
    Arc arc{{at}, static_cast<int>(degree)};
    for (std::size_t k = 1; k <= degree; ++k) arc.c[k] = point();
    at = arc.end();
    arcs.push_back(arc);
  }
  return arcs;
}

std::optional<ShapeRef> place_text(TypeStores& stores, std::span<const double> args,
                                   const Transform& to_world, bool inverted) {
  auto outline = shared_data<GlyphOutline>(args.subspan(1), [](std::span<const double> list) {
    return std::make_shared<const GlyphOutline>(arcs_of(list));
  });
  if (outline->empty()) return std::nullopt;
  Glyph glyph{std::move(outline), args[0]};
  return place_shape(stores, std::move(glyph), to_world, inverted);
}

constexpr PrimitiveType describe_text() {
  PrimitiveType type;
  type.name = "text";
  type.doc = "Letters of a font, with thickness along z.";
  type.params = text_params;
  type.open_ended = true;
  type.sides_by_order = true;
  type.make_stores = [] { return make_type_stores<Glyph>(); };
  type.place = place_text;
  type.samples = [] {
    return std::vector<std::vector<double>>{
        // A lens, and a square with a round hole.
        {0.4, 0, 0, 0, 2, 0.5, -0.7, 1, 0, 2, 0.5, 0.6, 0, 0},
        {0.2, 0,   0,   0, 1,   1,   0,   1,   1,   1,   1, 0,   1,   1,   0,  0,
         0,   0.3, 0.5, 3, 0.3, 0.8, 0.7, 0.8, 0.7, 0.5, 2, 0.5, 0.2, 0.3, 0.5}};
  };
  return type;
}

}  // namespace

extern constinit const PrimitiveType text_primitive = describe_text();

}  // namespace durer::tracer
