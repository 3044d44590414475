// How a pattern is described: one struct with defaulted members, evidence and a call operator
// becomes the language's description and the tracer's evaluator.
#pragma once

#include <array>
#include <span>

#include "functions/noise.h"
#include "functions/tape.h"
#include "tracer/patterns/operand.h"

namespace durer::scene {
struct Voxels;
}

namespace durer::tracer {

/// Evidence: the value of a pattern with default operands at one point.
struct PatternSample {
  dvec3 p;
  double value;
};

struct InnerPigment;
class ImageSampler;

/// What patterns may have to know beside their operands. Spans and pointers outlive the pattern.
struct PatternContext {
  functions::NoiseGenerator noise_generator = 2;
  std::span<const functions::WaveSource> waves;
  float frequency = 1;
  float phase = 0;
  dvec3 turbulence{0.0};         // of `turbulence` outside of any warp
  functions::Octaves octaves;    // of the same
  const functions::Function* function = nullptr;  // for the patterns `function` and `object`
  const InnerPigment* pigment = nullptr;          // what `pigment_pattern` looks at
  const ImageSampler* image = nullptr;            // what `image_map` and its like show
  const scene::Voxels* voxels = nullptr;          // what `density_file` looks up
};

/// A surface as a ray meets it, for patterns that depend on more than the place.
struct SurfaceView {
  dvec3 p{0.0};  // world point
  dvec3 d{0.0};  // unit direction of the ray
  dvec3 n{0.0};  // the normal so far, towards the viewer
  dvec3 uv{0.0};  // (u, v, 0), if anything in the texture is looked up there
};

/// A pattern as the tracer runs it. `evaluate` is the raw value before frequency, phase and wave
/// (textures §3, step 2); `view` is null away from surfaces.
struct PatternType : scene::PatternInfo {
  void (*prepare)(std::span<const double> args, const PatternContext& context,
                  PatternState& state) = nullptr;
  double (*evaluate)(const PatternState& state, const dvec3& p, const SurfaceView* view) = nullptr;
  /// The same at several points, away from surfaces.
  void (*evaluate_all)(const PatternState& state, std::span<const dvec3> points,
                       double* values) = nullptr;
  /// Bumps of a kind of their own: what becomes of the normal `n` at `p`. Null: the slope of
  /// `evaluate` makes the bumps.
  dvec3 (*perturb)(const PatternState& state, const dvec3& p, const dvec3& n, double amount) = nullptr;
  /// The same at several points, for a normal each, in place.
  void (*perturb_all)(const PatternState& state, std::span<const dvec3> points, dvec3* normals,
                      double amount) = nullptr;
  /// Colours of a pattern that has some instead of a value. Null: it has a value.
  Colour (*colour)(const PatternState& state, const dvec3& p) = nullptr;
  /// False where such a pattern shows nothing; null: it shows something everywhere.
  bool (*covers)(const PatternState& state, const dvec3& p) = nullptr;
  /// True if the colours of such a pattern never let light through.
  bool (*opaque)(const PatternState& state) = nullptr;
  bool asks_view = false;       // its value depends on more than the place
  bool own_turbulence = false;  // does itself what `turbulence` outside of any warp asks for
  std::span<const PatternSample> samples;
};

namespace patterns {

using Sample = PatternSample;

namespace detail {

template <typename P>
void prepare(std::span<const double> args, const PatternContext& context, PatternState& state) {
  P& pattern = load_all<P>(args, state);
  if constexpr (requires { pattern.prepare(context); }) {
    pattern.prepare(context);
  } else if constexpr (requires { pattern.prepare(); }) {
    pattern.prepare();
  }
}

template <typename P>
concept AsksView = requires(const P& pattern, const SurfaceView* view) { pattern(dvec3(), view); };

template <typename P>
double evaluate(const PatternState& state, const dvec3& p,
                [[maybe_unused]] const SurfaceView* view) {
  if constexpr (AsksView<P>) {
    return state.as<P>()(p, view);
  } else {
    return state.as<P>()(p);
  }
}

template <typename P>
void evaluate_all(const PatternState& state, std::span<const dvec3> points, double* values) {
  const P& pattern = state.as<P>();
  if constexpr (requires { pattern.evaluate(points, values); }) {
    pattern.evaluate(points, values);
  } else {
    for (std::size_t i = 0; i < points.size(); ++i) {
      values[i] = evaluate<P>(state, points[i], nullptr);
    }
  }
}

template <typename P>
concept Paints = requires(const P& pattern) { pattern.colour(dvec3()); };

template <typename P>
Colour colour(const PatternState& state, const dvec3& p) {
  return state.as<P>().colour(p);
}
template <typename P>
bool opaque(const PatternState& state) {
  return state.as<P>().opaque();
}
template <typename P>
bool covers(const PatternState& state, const dvec3& p) {
  return state.as<P>().covers(p);
}

template <typename P>
concept Perturbs = requires(const P& pattern) { pattern.perturb(dvec3(), dvec3(), 0.0); };

template <typename P>
dvec3 perturb(const PatternState& state, const dvec3& p, const dvec3& n, double amount) {
  return state.as<P>().perturb(p, n, amount);
}
template <typename P>
void perturb_all(const PatternState& state, std::span<const dvec3> points, dvec3* normals,
                 double amount) {
  const P& pattern = state.as<P>();
  if constexpr (requires { pattern.perturb(points, normals, amount); }) {
    pattern.perturb(points, normals, amount);
  } else {
    for (std::size_t i = 0; i < points.size(); ++i) {
      normals[i] = pattern.perturb(points[i], normals[i], amount);
    }
  }
}

}  // namespace detail

/// Options of a description beyond name and words.
struct PatternTraits {
  scene::Wave wave = scene::Wave::ramp;
  int list_size = 0;
  std::span<const scene::MapEntry> default_map;
  bool unwrapped = false;
  bool own_turbulence = false;
  bool averages = false;
  bool takes_function = false;
  bool takes_pigment = false;
  bool takes_image = false;
  bool takes_voxels = false;
  bool takes_object = false;
  bool only_pigment = false;
  bool only_normal = false;
  bool only_texture = false;
};

/// Describes the pattern P: default members, `operands` (optional), `samples`, an optional
/// `prepare()` for what depends on operands alone (or `prepare(context)`), and
/// `double operator()(dvec3) const`, which may take a `const SurfaceView*` too. An optional
/// `dvec3 perturb(dvec3 p, dvec3 n, double amount) const` is its form as a normal. Faster forms for
/// several points are optional: `void evaluate(std::span<const dvec3>, double*) const` and
/// `void perturb(std::span<const dvec3>, dvec3* normals, double amount) const`.
template <typename P>
constexpr PatternType describe_pattern(std::string_view name, std::string_view doc,
                                       PatternTraits traits) {
  static_assert(P::samples.size() > 0, "a pattern brings its own evidence");
  PatternType type;
  type.name = name;
  type.doc = doc;
  type.params = detail::params<P>;
  type.wave = traits.wave;
  type.list_size = traits.list_size;
  type.default_map = traits.default_map;
  type.unwrapped = traits.unwrapped || traits.list_size > 0;
  type.own_turbulence = traits.own_turbulence;
  type.averages = traits.averages;
  type.takes_function = traits.takes_function;
  type.takes_pigment = traits.takes_pigment;
  type.takes_image = traits.takes_image;
  type.takes_voxels = traits.takes_voxels;
  type.takes_object = traits.takes_object;
  type.only_pigment = traits.only_pigment;
  type.only_normal = traits.only_normal;
  type.only_texture = traits.only_texture;
  type.asks_view = detail::AsksView<P>;
  if constexpr (detail::Perturbs<P>) {
    type.perturb = &detail::perturb<P>;
    type.perturb_all = &detail::perturb_all<P>;
  }
  if constexpr (detail::Paints<P>) {
    type.colour = &detail::colour<P>;
    type.covers = &detail::covers<P>;
    type.opaque = &detail::opaque<P>;
  }
  type.prepare = &detail::prepare<P>;
  type.evaluate = &detail::evaluate<P>;
  type.evaluate_all = &detail::evaluate_all<P>;
  type.samples = P::samples;
  return type;
}

/// Colours of the default maps and lists (textures §11.4, §11.5).
[[nodiscard]] constexpr scene::MapEntry entry(float key, float r, float g, float b) {
  return {key, Colour{{r, g, b}, 0, 0}};
}
inline constexpr std::array black_to_white{entry(0, 0, 0, 0), entry(1, 1, 1, 1)};

}  // namespace patterns
}  // namespace durer::tracer
