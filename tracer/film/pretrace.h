// The passes before the picture, which fill the cache of indirect light: points at ever finer
// spacing, tile by tile (participating-and-global §2.8).
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "tracer/film/progress.h"
#include "tracer/film/threads.h"
#include "tracer/transport/radiosity.h"

namespace durer::tracer {

/// Part of the picture that is worked on at a time.
struct PretraceTile {
  std::uint32_t index = 0;
  /// In pixels; right and bottom are exclusive.
  struct Patch {
    double left, top, right, bottom;
  };
  std::vector<Patch> open;  // what wants more samples; all, unless radiosity is adaptive
};

/// Spacing of the points of pass `pass`, in pixels.
[[nodiscard]] double pretrace_spacing(const scene::Radiosity& settings, int longer_side, int pass);
[[nodiscard]] int pretrace_passes(const scene::Radiosity& settings, int longer_side);

/// Points of a patch in one pass: multiples of the spacing, moved about a little, the same way in
/// every run. Calls `visit(x, y)` in pixels.
void pretrace_points(const PretraceTile::Patch& patch, double spacing, std::uint32_t seed,
                     const std::function<void(double, double)>& visit);

/// Divides a patch as long as its parts keep at least 4×4 points.
[[nodiscard]] std::vector<PretraceTile::Patch> divided(const PretraceTile::Patch& patch,
                                                       double spacing);

/// One thread's means: a camera and a tracer. `Prober` has
///   RadiosityState& radiosity();          of the thread's scratch
///   void probe(double x, double y);       traces the ray through a point of the picture
///   std::uint64_t rays() const;           traced so far
template <typename Prober>
class Pretrace {
 public:
  Pretrace(const RadiosityProgram& program, std::vector<PretraceTile> tiles, int longer_side)
      : program_(&program), tiles_(std::move(tiles)), longer_side_(longer_side) {}

  /// Runs all passes. `make()` makes a unique_ptr<Prober>, once per thread.
  template <typename Make>
  void run(int threads, const Make& make, ProgressMeter& meter) {
    std::vector<std::unique_ptr<Prober>> probers(static_cast<std::size_t>(threads));
    const int passes = pretrace_passes(program_->settings, longer_side_);
    for (int pass = 0; pass < passes; ++pass) {
      // Tiles of one wave do not see each other's samples. What is found at later bounces would
      // serve all of them, so the first waves are small, however many threads there are.
      std::size_t size = 1;
      for (std::size_t begin = 0; begin < tiles_.size() && !meter.cancelled(); begin += size / 2) {
        const std::size_t end = std::min(begin + size, tiles_.size());
        std::vector<std::vector<IrradianceSample>> found(end - begin);
        std::atomic<std::size_t> next{begin};
        on_threads(threads, [&](int thread) {
          std::unique_ptr<Prober>& own = probers[static_cast<std::size_t>(thread)];
          if (!own) own = make();
          for (std::size_t i = next++; i < end && !meter.cancelled(); i = next++) {
            const std::uint64_t before = own->rays();
            found[i - begin] = visit(*own, tiles_[i], pass);
            meter.add(0, own->rays() - before);
          }
        });
        // In the order of tiles, whoever traced them.
        for (const auto& samples : found) {
          for (const IrradianceSample& s : samples) cache_.add(s, program_->reach(s));
        }
        size *= 2;
      }
    }
  }

  /// What is known already.
  void begin_with(std::span<const IrradianceSample> samples) {
    for (const IrradianceSample& s : samples) cache_.add(s, program_->reach(s));
  }
  [[nodiscard]] IrradianceCache cache() && { return std::move(cache_); }

 private:
  std::vector<IrradianceSample> visit(Prober& prober, PretraceTile& tile, int pass) {
    RadiosityState& state = prober.radiosity();
    const std::uint32_t seed = tile.index * 64 + static_cast<std::uint32_t>(pass);
    state.begin(&cache_, false, seed, static_cast<std::uint32_t>(program_->directions.size()));
    const double spacing = pretrace_spacing(program_->settings, longer_side_, pass);
    const bool adaptive = program_->settings.adaptive_count > 0;
    std::vector<PretraceTile::Patch> open;
    for (const PretraceTile::Patch& whole : tile.open) {
      for (const PretraceTile::Patch& patch :
           adaptive ? divided(whole, spacing) : std::vector{whole}) {
        state.top_weight = 0;
        state.top_queries = 0;
        int points = 0;
        pretrace_points(patch, spacing, seed, [&](double x, double y) {
          prober.probe(x, y);
          ++points;
        });
        const bool well_known =
            state.top_queries == 0 ||
            state.top_weight >= 1.0 * program_->settings.adaptive_count * state.top_queries;
        if (!(adaptive && points >= 9 && well_known)) open.push_back(patch);
      }
    }
    tile.open = std::move(open);
    return state.fresh.samples();
  }

  const RadiosityProgram* program_;
  std::vector<PretraceTile> tiles_;
  int longer_side_;
  IrradianceCache cache_;
};

}  // namespace durer::tracer
