// What the shading tests share: the spec's set-up and one traced pixel (shading §10).
#pragma once

#include <glm/glm.hpp>

#include "base/source.h"
#include "tests/support/catch.h"
#include "tests/support/scene_builder.h"
#include "tracer/compile.h"
#include "tracer/render.h"

namespace durer::test {

inline tracer::CompiledScenePtr compiled(const scene::Scene& scene) {
  const SourceMap sources;
  Diagnostics diagnostics(sources);
  tracer::CompiledScenePtr result = tracer::compile(scene, diagnostics);
  for (const Diagnostic& d : diagnostics.all()) UNSCOPED_INFO(d.message);
  REQUIRE(result != nullptr);
  return result;
}

/// Red, green, blue, alpha of the picture's centre.
inline glm::vec4 pixel(const scene::Scene& scene, bool alpha = false) {
  const tracer::CompiledScenePtr c = compiled(scene);
  tracer::RenderOptions options;
  options.width = options.height = 1;
  options.threads = 1;
  options.alpha = alpha;
  const tracer::RenderResult r = tracer::render(*c, options);
  const auto p = r.image.at(0, 0);
  return {p[0], p[1], p[2], p[3]};
}

/// Operands of a pattern, as they are where none is written.
inline std::vector<double> default_args(const scene::TypeInfo& type) {
  std::vector<double> args;
  for (const scene::Param& p : type.params) {
    args.insert(args.end(), p.fallback.begin(), p.fallback.begin() + scene::width(p.kind));
  }
  return args;
}

/// The oracle's values are 16-bit steps; half of one on either side, and a little for float sums.
inline constexpr double oracle_step = 1.0 / 65535;

inline void check_pixel(const scene::Scene& scene, vec3 expected, double margin = oracle_step) {
  const glm::vec4 p = pixel(scene);
  CAPTURE(p.x, p.y, p.z, p.w);
  CHECK(p.x == Approx(expected.x).margin(margin).epsilon(0));
  CHECK(p.y == Approx(expected.y).margin(margin).epsilon(0));
  CHECK(p.z == Approx(expected.z).margin(margin).epsilon(0));
}

/// A plane z = 0 that faces the camera at z = -5, and a white lamp that it sees at 45 degrees.
struct Wall : SceneBuilder {
  Wall() : SceneBuilder(tracer::registry()) {
    look_straight({0, 0, -5}, {0, 0, 1});
    light({-30, 40, -50});
  }
  scene::Object& wall(const scene::Pigment& pigment, const scene::Finish& finish) {
    return add("plane", {0, 0, 1, 0}, texture(pigment, finish));
  }
};

/// A plane y = 0 seen from <0,5,-5>, in front of a background.
struct Floor : SceneBuilder {
  Floor() : SceneBuilder(tracer::registry()) {
    look({0, 5, -5}, {0, 0, 0}, 0.01);
    scene.background = rgbft(0.5F, 0.25F, 0.8F);
  }
  scene::Object& floor(const scene::Pigment& pigment, const scene::Finish& finish,
                       scene::InteriorId inside = scene::none) {
    return add("plane", {0, 1, 0, 0}, texture(pigment, finish), inside);
  }
};

}  // namespace durer::test
