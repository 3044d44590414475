// The picture: blocks to threads, samples to pixels (shading §2.3, §3).
#include "tracer/render.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <optional>
#include <thread>

#include "tracer/film/adaptive.h"
#include "tracer/film/eye.h"
#include "tracer/film/pretrace.h"
#include "tracer/film/progress.h"
#include "tracer/film/progressive.h"
#include "tracer/film/threads.h"
#include "tracer/transport/irradiance_file.h"
#include "tracer/transport/photon_shooting.h"

namespace durer::tracer {
namespace {

Block part_of(const RenderOptions& o) {
  const auto end = [](int wanted, int all) { return wanted < 0 ? all : std::min(wanted, all); };
  return {std::max(0, o.first_column), std::max(0, o.first_row), end(o.end_column, o.width),
          end(o.end_row, o.height)};
}

// Without anti-aliasing pixels are independent, and small blocks share the work out better.
int block_size_of(const RenderOptions& o) {
  constexpr int small_block = 16;
  return std::max(1, o.antialias ? o.block_size : std::min(o.block_size, small_block));
}

std::vector<Block> blocks_of(const RenderOptions& options) {
  const Block part = part_of(options);
  const int size = block_size_of(options);
  std::vector<Block> blocks;
  for (int y = part.top; y < part.bottom; y += size) {
    for (int x = part.left; x < part.right; x += size) {
      blocks.push_back({x, y, std::min(x + size, part.right), std::min(y + size, part.bottom)});
    }
  }
  return blocks;
}

AntialiasOptions antialias_options(const CompiledScene& scene, const RenderOptions& o) {
  // What radiosity finds depends on the order of samples.
  return {o.aa_threshold,  o.aa_depth, o.aa_jitter, o.aa_gamma, scene.scene->settings.assumed_gamma,
          !scene.radiosity};
}

// Renders blocks on one thread.
class BlockRenderer {
 public:
  BlockRenderer(const Viewpoint& view, image::Image& image)
      : options_(view.options),
        image_(&image),
        eye_(view),
        antialias_(antialias_options(*view.scene, *view.options)),
        adaptive_(antialias_options(*view.scene, *view.options)),
        ahead_(antialias_options(*view.scene, *view.options).ahead) {}

  /// Before each block: what is known of indirect light. `id` tells the blocks apart.
  void begin(const IrradianceCache& cache, std::uint32_t id) { eye_.begin(&cache, ~id); }

  void render(const Block& block) {
    const auto take = [this](double x, double y, std::uint32_t i) { return eye_.see(x, y, i); };
    const auto put = [this](int x, int y, const Pixel& p) { store(x, y, p); };
    if (options_->antialias) {
      if (options_->aa_method == 2) return adaptive_.render(block, take, put);
      const auto take_all = [this](std::span<const Spot> spots, Pixel* out) {
        eye_.see(spots, out);
      };
      return antialias_.render(block, take_all, put);
    }
    // The order of pixels matters where one adds to what others find.
    const int height = ahead_ ? block.bottom - block.top : 1;
    for (int y = block.top; y < block.bottom; y += height) {
      see_all({block.left, y, block.right, y + height});
    }
  }

  [[nodiscard]] std::uint64_t rays() const { return eye_.rays(); }

 private:
  // Whole squares first, then what is left of others.
  void see_all(const Block& part) {
    spots_.clear();
    each_square(part, [this](const Block& square) {
      if (pixels_of(square) == square_edge * square_edge) return see_square(square);
      in_rows(square, [this](int x, int y) { spots_.push_back({double(x), double(y), 0}); });
    });
    if (spots_.empty()) return;
    pixels_.resize(spots_.size());
    eye_.see(spots_, pixels_.data());
    for (std::size_t i = 0; i < spots_.size(); ++i) {
      store(static_cast<int>(spots_[i].x), static_cast<int>(spots_[i].y), pixels_[i]);
    }
  }
  void see_square(const Block& square) {
    for (int y = square.top; y < square.bottom; ++y) {  // else what is stored waits for memory
      __builtin_prefetch(image_->at(square.left, y).data(), 1);
      __builtin_prefetch(image_->at(square.right - 1, y).data(), 1);
    }
    std::array<Pixel, square_edge * square_edge> pixels;
    eye_.see_square(square.left, square.top, pixels.data());
    const Pixel* pixel = pixels.data();
    in_rows(square, [&](int x, int y) { store(x, y, *pixel++); });
  }
  void store(int x, int y, const Pixel& p) {
    const auto out = image_->at(x, y);
    std::memcpy(out.data(), &p, out.size_bytes());
    out[3] = 1 - p.w;
  }

  const RenderOptions* options_;
  image::Image* image_;
  Eye eye_;
  Antialias antialias_;
  AdaptiveAntialias adaptive_;
  bool ahead_;
  std::vector<Spot> spots_;
  std::vector<Pixel> pixels_;
};

std::vector<PretraceTile> tiles_of(const Block& part) {
  constexpr int size = 32;
  std::vector<PretraceTile> tiles;
  for (int y = part.top; y < part.bottom; y += size) {
    for (int x = part.left; x < part.right; x += size) {
      tiles.push_back({static_cast<std::uint32_t>(tiles.size()),
                       {{double(x), double(y), double(std::min(x + size, part.right)),
                         double(std::min(y + size, part.bottom))}}});
    }
  }
  return tiles;
}

// The cache of indirect light, filled by the passes before the picture.
IrradianceCache gather_light(const Viewpoint& view, int threads, ProgressMeter& meter) {
  if (!view.scene->radiosity) return {};
  const RenderOptions& o = *view.options;
  Pretrace<Eye> pretrace(*view.scene->radiosity, tiles_of(part_of(o)), std::max(o.width, o.height));
  pretrace.begin_with(o.gathered);
  pretrace.run(
      threads, [&] { return std::make_unique<Eye>(view); }, meter);
  return std::move(pretrace).cache();
}

// Blocks in row-major order, several in a row at a time: neighbours use the same part of what is
// made where rays come by. Fewer towards the end, so that all threads end together.
class BlockRuns {
 public:
  struct Run {
    std::size_t first, end;
    [[nodiscard]] bool empty() const { return first == end; }
  };
  BlockRuns(std::size_t count, int threads)
      : count_(count), shares_(4 * static_cast<std::size_t>(std::max(1, threads))) {}

  [[nodiscard]] Run next() {
    std::size_t first = next_.load(std::memory_order_relaxed);
    std::size_t end = first;
    do {
      if (first >= count_) return {count_, count_};
      end = first + std::clamp<std::size_t>((count_ - first) / shares_, 1, most);
    } while (!next_.compare_exchange_weak(first, end, std::memory_order_relaxed));
    return {first, end};
  }

 private:
  static constexpr std::size_t most = 16;
  std::atomic<std::size_t> next_{0};
  std::size_t count_;
  std::size_t shares_;
};

// Memory of the picture, for one row of blocks ahead of those that are being rendered.
class PictureMemory {
 public:
  PictureMemory(image::Image& image, const Block& part)
      : image_(&image),
        end_(part.right - part.left == image.width ? part.bottom : part.top),
        next_(part.top) {}

  /// Before `block` is rendered. Does not wait for what another thread is at.
  void prepare_for(const Block& block) {
    const int rows = block.bottom - block.top;
    int from = next_.load(std::memory_order_relaxed);
    while (from < std::min(end_, block.bottom + rows)) {
      if (!next_.compare_exchange_weak(from, from + rows, std::memory_order_relaxed)) continue;
      const std::size_t row = std::size_t{4} * image_->width;
      image_->pixels.prepare(row * from, row * (std::min(end_, from + rows) - from));
      from += rows;
    }
  }

 private:
  image::Image* image_;
  int end_;  // there is no need beyond; nor anywhere, if not all of each row is rendered
  std::atomic<int> next_;
};

// Threads take the next blocks in row-major order until none is left, past those already done.
void render_blocks(const Viewpoint& view, const std::vector<Block>& blocks, int threads,
                   ProgressMeter& meter, Checkpoint& film, const IrradianceCache& cache) {
  BlockRuns runs(blocks.size(), threads);
  PictureMemory memory(film.image, part_of(*view.options));
  const auto work = [&](int) {
    BlockRenderer renderer(view, film.image);
    std::uint64_t counted = 0;
    for (auto run = runs.next(); !run.empty(); run = runs.next()) {
      memory.prepare_for(blocks[run.first]);
      for (std::size_t i = run.first; i < run.end && !meter.cancelled(); ++i) {
        if (film.done[i] > 0) continue;
        renderer.begin(cache, static_cast<std::uint32_t>(i));
        renderer.render(blocks[i]);
        film.done[i].store(1, std::memory_order_release);
        meter.add(pixels_of(blocks[i]), renderer.rays() - counted);
        counted = renderer.rays();
      }
    }
  };
  on_threads(threads, work);
}

// Pixels still to be made; where these are means of samples, samples.
std::uint64_t work_left(const CompiledScene& scene, const RenderOptions& options,
                        const std::vector<Block>& blocks, const Checkpoint& film) {
  std::vector<int> samples{0, 1};  // after so many passes
  if (scene.quality.path) {
    samples = pass_ends(options.samples);
    samples.insert(samples.begin(), 0);
  }
  std::uint64_t left = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const std::size_t passes = std::min<std::size_t>(film.done[i], samples.size() - 1);
    left += pixels_of(blocks[i]) * static_cast<unsigned>(samples.back() - samples[passes]);
  }
  return left;
}

}  // namespace

Checkpoint::Checkpoint(const RenderOptions& options)
    : image(options.width, options.height), done(blocks_of(options).size()), options_(options) {}

Checkpoint::State Checkpoint::copy() const {
  State state{std::vector<std::uint8_t>(done.size()), image::Image(image.width, image.height)};
  const std::vector<Block> blocks = blocks_of(options_);
  const std::lock_guard lock(writing);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    state.done[i] = done[i].load(std::memory_order_acquire);
    if (state.done[i] == 0) continue;
    const Block& b = blocks[i];
    for (int y = b.top; y < b.bottom; ++y) {
      const float* row = image.at(b.left, y).data();
      std::copy_n(row, std::size_t{4} * (b.right - b.left), state.image.at(b.left, y).data());
    }
  }
  return state;
}

bool Checkpoint::restore(State state) {
  const bool fits = state.done.size() == done.size() && state.image.width == image.width &&
                    state.image.height == image.height &&
                    state.image.pixels.size() == image.pixels.size();
  if (!fits) return false;
  image = std::move(state.image);
  for (std::size_t i = 0; i < done.size(); ++i) done[i] = state.done[i];
  return true;
}

bool take_gathered(RenderOptions& options, std::string_view file) {
  auto samples = decode_samples(file);
  if (samples) options.gathered = std::move(*samples);
  return samples.has_value();
}

RenderResult render(const CompiledScene& scene, const RenderOptions& options,
                    const std::function<void(const Progress&)>& on_progress,
                    const std::atomic<bool>* cancel, Checkpoint* checkpoint) {
  const std::vector<Block> blocks = blocks_of(options);
  const int hardware = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const int threads = options.threads > 0 ? options.threads : hardware;

  std::optional<Checkpoint> own;
  Checkpoint& film = checkpoint ? *checkpoint : own.emplace(options);
  ProgressMeter meter(work_left(scene, options, blocks, film), on_progress, cancel);
  RenderResult result;
  Viewpoint view(scene, options);
  if (scene.quality.path) {
    render_passes(view, blocks, threads, meter, film);
  } else {
    const PhotonMaps photons = shoot_photons(scene, threads, meter, result.warning);
    view.photons = &photons;
    const IrradianceCache cache = gather_light(view, threads, meter);
    render_blocks(view, blocks, threads, meter, film, cache);
    if (options.keep_gathered) result.gathered = encode_samples(cache.samples());
  }
  result.final = meter.now();
  result.cancelled = meter.cancelled();
  if (own || !result.cancelled) result.image = std::move(film.image);
  return result;
}

void report_events(const CompiledScene& scene, Diagnostics& diagnostics) {
  const auto& origins = scene.scene->origins;
  for (Geometry::Doubt& doubt : scene.geometry.doubts()) {
    Diagnostic d;
    d.severity = Severity::warning;
    d.code = Code::render;
    d.span = origins[doubt.origin].span;
    d.message = std::move(doubt.message);
    if (!doubt.remedy.empty()) d.help.push_back(std::move(doubt.remedy));
    for (auto at = origins[doubt.origin].parent; at != 0; at = origins[at].parent) {
      d.trace.push_back({origins[at].span, "expanded from here"});
    }
    diagnostics.report(std::move(d));
  }
}

}  // namespace durer::tracer
