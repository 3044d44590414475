#include "tracer/patterns/program.h"

#include <algorithm>
#include <cmath>

#include "tracer/patterns/image_sampler.h"
#include "tracer/patterns/patterns.h"
#include "tracer/patterns/pigment_pattern.h"
#include "tracer/warps/turbulence.h"
#include "tracer/warps/warps.h"

namespace durer::tracer {
namespace {

dvec3 transform_point(const PatternState& state, const dvec3& p) {
  return state.as<Affine>().point(p);
}

void transform_points(const PatternState& state, std::span<dvec3> points) {
  for (dvec3& p : points) p = transform_point(state, p);
}

}  // namespace

double shape_wave(scene::Wave wave, float exponent, double value) {
  switch (wave) {
    case scene::Wave::ramp: return value;
    case scene::Wave::sine: return (1 + functions::cycloidal(value)) / 2;
    case scene::Wave::triangle: return functions::triangle(value);
    case scene::Wave::scallop: return std::abs(functions::cycloidal(value / 2));
    case scene::Wave::cubic: return value * value * (3 - 2 * value);
    case scene::Wave::poly: return std::pow(value, static_cast<double>(exponent));
  }
  return value;
}

PatternStore::PatternStore(const scene::Settings& settings)
    : settings_(settings),
      waves_(std::make_shared<const std::vector<functions::WaveSource>>(
          functions::wave_sources(settings.number_of_waves))) {
  settings_.noise_generator = settings_.resolved_noise_generator();
}

PatternProgram PatternStore::compile(const scene::Pattern& pattern, const Transform& to_world) {
  PatternProgram out;
  if (!pattern.exists()) return out;
  out.type = pattern_types()[pattern.type];
  PatternContext context;
  context.noise_generator =
      pattern.noise_generator != 0 ? pattern.noise_generator : settings_.noise_generator;
  context.waves = *waves_;
  context.frequency = pattern.frequency;
  context.phase = pattern.phase;
  if (pattern.function) {
    context.function = pattern.function.get();
    functions_.push_back(pattern.function);
  }
  if (pattern.pigment) {
    auto inner = std::make_shared<InnerPigment>(settings_);
    inner->id = inner->store.add(*pattern.pigment, {});
    context.pigment = inner.get();
    pigments_.push_back(std::move(inner));
  }
  if (pattern.image) context.image = sampler(pattern.image);
  if (pattern.voxels) {
    context.voxels = pattern.voxels.get();
    voxels_.push_back(pattern.voxels);
  }

  out.first_step = static_cast<std::uint32_t>(steps_.size());
  for (std::size_t i = pattern.warps.size(); i-- > 0;) {
    const scene::Warp& warp = pattern.warps[i];
    if (warp.classic) {
      PatternState state;
      const auto& turbulence = patterns::detail::load_all<warps::Turbulence>(warp.args, state);
      context.turbulence = turbulence.amount;
      context.octaves = turbulence.octaves();
      if (out.type->own_turbulence || turbulence.amount == dvec3(0.0)) continue;
    }
    add_step(warp);
  }
  out.end_step = static_cast<std::uint32_t>(steps_.size());

  out.type->prepare(pattern.args, context, out.state);
  const Transform placed = pattern.transform.get().then(to_world);
  out.moved = !placed.is_identity();
  out.to_pattern = placed.backward;
  out.wave = pattern.wave;
  out.frequency = pattern.frequency;
  out.phase = pattern.phase;
  out.wave_exponent = pattern.wave_exponent;
  return out;
}

const ImageSampler* PatternStore::sampler(const std::shared_ptr<const scene::Image>& image) {
  std::shared_ptr<const ImageSampler>& known = images_[image];
  if (!known) known = std::make_shared<const ImageSampler>(*image);
  return known.get();
}

void PatternStore::add_step(const scene::Warp& warp) {
  Step step;
  if (warp.type == scene::none) {
    step.apply = &transform_point;
    step.apply_all = &transform_points;
    ::new (step.state.bytes.data()) Affine(warp.transform->backward);
  } else {
    const WarpType& type = *warp_types()[warp.type];
    type.prepare(warp.args, step.state);
    step.apply = type.apply;
    step.apply_all = type.apply_all;
  }
  steps_.push_back(step);
}

void PatternStore::warp(const PatternProgram& program, std::span<dvec3> points) const {
  if (program.moved) {
    for (dvec3& p : points) p = program.to_pattern.point(p);
  }
  for (std::uint32_t i = program.first_step; i < program.end_step; ++i) {
    steps_[i].apply_all(steps_[i].state, points);
  }
  for (dvec3& p : points) p = representable(p);
}

void PatternStore::values(const PatternProgram& program, std::span<const dvec3> warped,
                          double* out) {
  program.type->evaluate_all(program.state, warped, out);
  for (std::size_t i = 0; i < warped.size(); ++i) out[i] = shaped(program, out[i]);
}

}  // namespace durer::tracer
