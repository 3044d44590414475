#include "tracer/film/progressive.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "tracer/film/threads.h"

namespace durer::tracer {

std::vector<int> pass_ends(int samples) {
  constexpr int most_equal = 64;
  const int step = std::max(1, (samples + most_equal - 1) / most_equal);
  std::vector<int> ends;
  for (int end = 1; end < samples; end += std::min(end, step)) ends.push_back(end);
  ends.push_back(samples);
  return ends;
}

int fewest_samples(const RenderOptions& options, const Checkpoint::State& state) {
  if (state.done.empty()) return 0;
  const std::size_t passes = *std::min_element(state.done.begin(), state.done.end());
  return passes == 0 ? 0 : pass_ends(options.samples).at(passes - 1);
}

namespace {

// Takes samples on one thread.
class PassRenderer {
 public:
  PassRenderer(const Viewpoint& view, image::Image& image) : eye_(view), image_(&image) {}

  // Samples `first` to `end` - 1 of the block's pixels.
  void render(const Block& block, int first, int end) {
    means_.clear();
    for (int y = block.top; y < block.bottom; ++y) {
      for (int x = block.left; x < block.right; ++x) {
        Pixel sum = first == 0 ? Pixel(0.0F) : static_cast<float>(first) * read(x, y);
        for (int i = first; i < end; ++i) {
          sum += finite(eye_.sample(x, y, static_cast<std::uint32_t>(i)));
        }
        means_.push_back(sum / static_cast<float>(end));
      }
    }
  }
  void write(const Block& block) {
    auto mean = means_.begin();
    for (int y = block.top; y < block.bottom; ++y) {
      for (int x = block.left; x < block.right; ++x, ++mean) {
        const auto out = image_->at(x, y);
        for (int i = 0; i < 3; ++i) out[i] = (*mean)[i];
        out[3] = 1 - mean->w;
      }
    }
  }

  [[nodiscard]] std::uint64_t rays() const { return eye_.rays(); }

 private:
  // One path that met something degenerate must not cost the pixel.
  static Pixel finite(const Pixel& p) {
    const float sum = p.x + p.y + p.z + p.w;
    return std::isfinite(sum) ? p : Pixel(0.0F, 0.0F, 0.0F, 1.0F);
  }
  [[nodiscard]] Pixel read(int x, int y) const {
    const auto p = image_->at(x, y);
    return {p[0], p[1], p[2], 1 - p[3]};
  }

  Eye eye_;
  image::Image* image_;
  std::vector<Pixel> means_;
};

}  // namespace

void render_passes(const Viewpoint& view, const std::vector<Block>& blocks, int threads,
                   ProgressMeter& meter, Checkpoint& film) {
  std::vector<std::unique_ptr<PassRenderer>> renderers(static_cast<std::size_t>(threads));
  const std::vector<int> ends = pass_ends(view.options->samples);
  int first = 0;
  for (std::size_t pass = 0; pass < ends.size(); first = ends[pass++]) {
    std::atomic<std::size_t> next{0};
    on_threads(threads, [&](int thread) {
      auto& renderer = renderers[static_cast<std::size_t>(thread)];
      if (!renderer) renderer = std::make_unique<PassRenderer>(view, film.image);
      std::uint64_t counted = renderer->rays();
      for (std::size_t i = next++; i < blocks.size() && !meter.cancelled(); i = next++) {
        if (film.done[i] > pass) continue;
        const Block& block = blocks[i];
        renderer->render(block, first, ends[pass]);
        {
          const std::lock_guard lock(film.writing);
          renderer->write(block);
          film.done[i].store(static_cast<std::uint8_t>(pass + 1), std::memory_order_release);
        }
        meter.add(pixels_of(block) * static_cast<unsigned>(ends[pass] - first),
                  renderer->rays() - counted);
        counted = renderer->rays();
      }
    });
    if (meter.cancelled()) return;
  }
}

}  // namespace durer::tracer
