// Compiled scene → picture. Public.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "image/image.h"
#include "tracer/compile.h"

namespace durer::tracer {

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
  std::vector<std::atomic<bool>> done;  // by block, in the order of `render`

  struct State {
    std::vector<std::uint8_t> done;  // 0 or 1
    image::Image image;              // pixels of other blocks are 0
  };
  /// What is done by now.
  [[nodiscard]] State copy() const;
  /// Takes up where `state` left off. False if it was not made with the same options.
  [[nodiscard]] bool restore(State state);

 private:
  RenderOptions options_;
};

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
