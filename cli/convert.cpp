#include "cli/convert.h"

#include <fmt/format.h>

#include "cli/limits.h"

namespace durer::cli {
namespace {

/// `Version=3.7` on the command line switches the encoding of the output on for scenes that do not
/// handle gamma themselves; their numbers then count as linear light (shading §1.2).
bool encodes_despite_scene(const Settings& s, const scene::Settings& scene) {
  return scene.gamma_mode == scene::GammaMode::off && s.version >= 370;
}

}  // namespace

interpreter::Options interpreter_options(const Settings& s, const FrameTask& task) {
  interpreter::Options o;
  o.include_paths = s.library_paths;
  o.declares = s.declares;
  o.width = s.width;
  o.height = s.height;
  o.clock = task.clock;
  o.clock_on = task.clock_on;
  if (task.animation) o.frame = task.animation->values(task.number);
  o.version = s.version;
  o.header_file = s.header_file;
  o.limits = limits_of(s).reading;
  o.confined = s.untrusted;  // and `writable` stays empty: scenes of strangers write nothing
  o.output_alpha = s.alpha;
  return o;
}

tracer::RenderOptions render_options(const Settings& s, const Window& window) {
  tracer::RenderOptions o;
  o.width = s.width;
  o.height = s.height;
  o.antialias = s.antialias && s.sampling_method != 0;
  o.aa_method = s.sampling_method;
  o.aa_threshold = static_cast<float>(s.aa_threshold);
  o.aa_depth = s.aa_depth;
  o.aa_jitter = s.jitter ? static_cast<float>(s.jitter_amount) : 0.0F;
  o.aa_gamma = static_cast<float>(s.aa_gamma);
  o.block_size = s.block_size;
  o.alpha = s.alpha;
  o.threads = s.threads;
  o.samples = s.paths ? s.path_samples : 0;
  o.paths.max_bounces = s.path_bounces;
  o.first_column = window.first_column;
  o.end_column = window.end_column;
  o.first_row = window.first_row;
  o.end_row = window.end_row;
  o.alpha = s.alpha;
  return o;
}

image::Encoding encoding_of(const Settings& s, const scene::Settings& scene) {
  image::Encoding e;
  e.working = scene.assumed_gamma;
  e.encode = scene.gamma_mode != scene::GammaMode::off || encodes_despite_scene(s, scene);
  if (encodes_despite_scene(s, scene)) e.working = GammaCurve();
  e.file = s.file_gamma;
  e.bits = s.bits;
  e.greyscale = s.greyscale;
  e.alpha = s.alpha;
  if (s.dither) e.dither = s.dither_method;
  e.compression = s.compressed_tga ? 1 : s.compression;
  e.threads = s.threads;
  return e;
}

std::string assumptions(const Settings& s, const scene::Settings& scene,
                        const std::string& of_the_scene) {
  if (!encodes_despite_scene(s, scene)) return of_the_scene;
  return of_the_scene.substr(0, of_the_scene.find(';')) +
         "; no assumed_gamma, 1 is taken because of Version=3.7";
}

}  // namespace durer::cli
