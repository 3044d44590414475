#include "tracer/pigment_queries.h"

#include <fmt/format.h>

#include "tracer/patterns/inner_object.h"
#include "tracer/shading/pigment.h"

namespace durer::tracer {
namespace {

/// A pigment of its own, outside of any texture: its space is that of the arguments.
struct Compiled {
  explicit Compiled(const scene::Settings& settings) : store(settings) {}
  PigmentStore store;
  PigmentId id = 0;
};

functions::External make(const scene::Scene& scene, const scene::Pigment& pigment, std::string name, int components,
                         functions::External::Point point) {
  auto compiled = std::make_shared<Compiled>(scene.settings);
  compiled->id = compiled->store.add(pigment, {});
  functions::External e;
  e.name = std::move(name);
  e.components = components;
  e.self = std::move(compiled);
  e.point = point;
  return e;
}

void pattern_at(const void* self, const functions::Context&, const double* p, double* out) {
  const auto& c = *static_cast<const Compiled*>(self);
  *out = c.store.pattern_value(c.id, {p[0], p[1], p[2]});
}

void colour_at(const void* self, const functions::Context&, const double* p, double* out) {
  const auto& c = *static_cast<const Compiled*>(self);
  const Colour colour = c.store.at(c.id, {p[0], p[1], p[2]});
  out[0] = colour.rgb.x;
  out[1] = colour.rgb.y;
  out[2] = colour.rgb.z;
  out[3] = colour.filter;
  out[4] = colour.transmit;
}

void inside_at(const void* self, const functions::Context&, const double* p, double* out) {
  *out = static_cast<const InnerObject*>(self)->contains({p[0], p[1], p[2]}) ? 1 : 0;
}

class Queries final : public scene::PigmentQueries {
 public:
  functions::External pattern_function(const scene::Scene& scene,
                                       const scene::Pigment& pigment) override {
    return make(scene, pigment, "pattern", 1, &pattern_at);
  }
  functions::External pigment_function(const scene::Scene& scene,
                                       const scene::Pigment& pigment) override {
    return make(scene, pigment, "pigment", functions::max_components, &colour_at);
  }
  functions::External inside_function(const scene::Scene& scene, scene::ObjectId object) override {
    functions::External e;
    e.name = fmt::format("inside object {}", object);
    e.components = 1;
    e.self = std::make_shared<InnerObject>(scene, object);
    e.point = &inside_at;
    return e;
  }
};

}  // namespace

std::unique_ptr<scene::PigmentQueries> make_pigment_queries() {
  return std::make_unique<Queries>();
}

}  // namespace durer::tracer
