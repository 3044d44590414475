#pragma once

#include <cmath>

#include "functions/evaluate.h"
#include "tracer/patterns/pattern_type.h"

namespace durer::tracer::patterns {

// The value of a user function at the point (textures §8.4). Unbound it is 0 everywhere.
struct FunctionPattern {
  const functions::Function* tape = nullptr;
  functions::NoiseGenerator noise_generator = 2;

  static constexpr std::array samples{Sample{{1, 2, 3}, 0}};

  void prepare(const PatternContext& context) {
    tape = context.function;
    noise_generator = context.noise_generator;
  }

  double operator()(dvec3 p) const {
    if (tape == nullptr) return 0;
    // Tapes need room for their registers. One for each thread, because points are looked at from
    // all of them; it grows once.
    thread_local functions::Workspace workspace;
    workspace.context.noise_generator = noise_generator;
    const double v = functions::evaluate(*tape, std::array{p.x, p.y, p.z}, workspace);
    return v > 1 ? std::fmod(v, 1) : v;
  }
};

}  // namespace durer::tracer::patterns
