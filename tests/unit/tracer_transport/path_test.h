// What the tests of random paths share.
#pragma once

#include "tests/unit/tracer_shading/shading_test.h"

namespace durer::test {

inline tracer::CompiledScenePtr compiled_for_paths(const scene::Scene& scene) {
  const SourceMap sources;
  Diagnostics diagnostics(sources);
  auto result = tracer::compile(scene, diagnostics, 9, tracer::Integrator::path);
  for (const Diagnostic& d : diagnostics.all()) UNSCOPED_INFO(d.message);
  REQUIRE(result != nullptr);
  return result;
}

inline tracer::RenderOptions small_picture(int size, int samples) {
  tracer::RenderOptions options;
  options.width = options.height = size;
  options.samples = samples;
  options.threads = 2;
  return options;
}

inline vec3 mean_of(const image::Image& image) {
  dvec3 sum(0.0);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const auto p = image.at(x, y);
      sum += dvec3(p[0], p[1], p[2]);
    }
  }
  return vec3(sum / (static_cast<double>(image.width) * image.height));
}

/// The mean of a small picture.
inline vec3 along_paths(const scene::Scene& scene, int samples = 256, tracer::PathRules rules = {}) {
  const auto c = compiled_for_paths(scene);
  tracer::RenderOptions options = small_picture(8, samples);
  options.paths = rules;
  return mean_of(tracer::render(*c, options).image);
}

/// The same by the ordinary tracer.
inline vec3 as_ever(const scene::Scene& scene) {
  return mean_of(tracer::render(*compiled(scene), small_picture(8, 1)).image);
}

inline void check_near(vec3 found, vec3 expected, double margin) {
  CAPTURE(found.x, found.y, found.z, expected.x, expected.y, expected.z);
  for (int i = 0; i < 3; ++i) CHECK(found[i] == Approx(expected[i]).margin(margin).epsilon(0));
}

inline scene::Finish matte(float diffuse) {
  scene::Finish f = dull();
  f.diffuse = f.indirect = diffuse;
  return f;
}

}  // namespace durer::test
