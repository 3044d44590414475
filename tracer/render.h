// Compiled scene → picture. Public.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "image/image.h"
#include "tracer/compile.h"

namespace durer::tracer {

/// How far random paths go, and how they look for light.
struct PathRules {
  int max_bounces = 64;    // 0: only what glows; straight ways through surfaces do not count
  bool next_event = true;  // look for surfaces that glow; without, they are only met by chance
};

struct RenderOptions {
  int width = 160;
  int height = 120;
  bool antialias = false;
  int aa_method = 1;          // 1: refine pixels that differ, 2: divide pixels (shading §3.2, §3.3)
  float aa_threshold = 0.3F;  // 0…1
  int aa_depth = 3;           // 1…9; n: n·n + 1 samples, or n - 1 divisions
  float aa_jitter = 1.0F;     // 0…1; 0: off
  float aa_gamma = 2.5F;
  /// The alpha channel will be used: the background's filter and transmit count. Without it they
  /// are taken for 0, also by anti-aliasing (shading §7.2).
  bool alpha = false;
  int block_size = 32;  // pixels; anti-aliasing looks at blocks (shading §3.2)
  int threads = 0;      // 0: all
  // Of scenes that are compiled for random paths; these have no other anti-aliasing.
  int samples = 64;  // paths per pixel; others ignore it
  PathRules paths;
  // Part of the picture to render: 0-based, end exclusive; -1: to the edge.
  int first_column = 0;
  int end_column = -1;
  int first_row = 0;
  int end_row = -1;
};

struct Progress {
  std::uint64_t pixels_done = 0;
  std::uint64_t pixels_total = 0;
  std::uint64_t rays = 0;  // all kinds: camera, reflected, refracted, shadow
  double seconds = 0;
};

struct RenderResult {
  image::Image image;  // pixels outside the rendered part are 0
  Progress final;
  bool cancelled = false;
  std::string warning;  // why a file that the scene asks for could not be written; empty: all is well
};

/// A picture of which some blocks are done, so that a render can be interrupted and taken up again.
/// While a render runs, any thread may call `copy`.
struct Checkpoint {
  explicit Checkpoint(const RenderOptions& options);

  image::Image image;                   // pixels of blocks that are not done are undefined
  /// Passes that are done, by block, in the order of `render`: there is one, or several when light
  /// is followed along random paths; each makes the picture less noisy.
  std::vector<std::atomic<std::uint8_t>> done;
  mutable std::mutex writing;  // held while a block that was done once is done again

  struct State {
    std::vector<std::uint8_t> done;  // passes
    image::Image image;              // pixels of other blocks are 0
  };
  /// What is done by now.
  [[nodiscard]] State copy() const;
  /// Takes up where `state` left off. False if it was not made with the same options.
  [[nodiscard]] bool restore(State state);

 private:
  RenderOptions options_;
};

/// How many samples of random paths every pixel has at least, when `state` is what is done.
[[nodiscard]] int fewest_samples(const RenderOptions& options, const Checkpoint::State& state);

/// Renders on all cores; the picture is bit-equal for any thread count. `on_progress` is called now
/// and then from one thread at a time; `cancel` stops the render early when it becomes true. Blocks
/// that are done in `checkpoint` are not rendered again; those that have been are noted there.
[[nodiscard]] RenderResult render(const CompiledScene& scene, const RenderOptions& options,
                                  const std::function<void(const Progress&)>& on_progress = {},
                                  const std::atomic<bool>* cancel = nullptr,
                                  Checkpoint* checkpoint = nullptr);

/// Warns of what came to light while the scene was rendered, naming the objects: shapes whose
/// settings did not suit them.
void report_events(const CompiledScene& scene, Diagnostics& diagnostics);

}  // namespace durer::tracer
