// Anti-aliasing, block by block; every block stands alone. Method 1 (shading §3.2) refines pixels
// that differ from their neighbours; method 2 is in adaptive.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "base/gamma.h"
#include "tracer/film/jitter.h"

namespace durer::tracer {

/// Red, green, blue, transmittance.
using Pixel = glm::vec4;

/// Pixels of the full picture; ends are exclusive.
struct Block {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
};
[[nodiscard]] inline std::uint64_t pixels_of(const Block& b) {
  return static_cast<std::uint64_t>(b.right - b.left) * static_cast<unsigned>(b.bottom - b.top);
}

/// Edge of the squares that blocks are sampled in: the sixteen pixels of one are near to each other
/// in both directions, and so are their rays, which go side by side.
inline constexpr int square_edge = 4;

/// Calls f(square) for every square of a block; those at its edges may be smaller.
template <typename F>
void each_square(const Block& block, const F& f) {
  for (int y = block.top; y < block.bottom; y += square_edge) {
    for (int x = block.left; x < block.right; x += square_edge) {
      f(Block{x, y, std::min(x + square_edge, block.right),
              std::min(y + square_edge, block.bottom)});
    }
  }
}

/// Calls f(x, y) for every pixel of a block, row by row …
template <typename F>
void in_rows(const Block& block, const F& f) {
  for (int y = block.top; y < block.bottom; ++y) {
    for (int x = block.left; x < block.right; ++x) f(x, y);
  }
}
/// … or square by square.
template <typename F>
void in_squares(const Block& block, const F& f) {
  each_square(block, [&](const Block& square) { in_rows(square, f); });
}

/// Where a sample is taken. Whole numbers are centres of pixels; `index` tells the samples of a
/// pixel apart: 0 is its centre.
struct Spot {
  double x = 0;
  double y = 0;
  std::uint32_t index = 0;
};

struct AntialiasOptions {
  float threshold = 0.3F;
  int depth = 3;
  float jitter = 1;
  float gamma = 2.5F;
  GammaCurve working;  // of the scene's numbers
  bool ahead = true;   // all pixels may be sampled before they are compared
};

/// A sample, or several, and how comparisons see it.
struct Sampled {
  Pixel value{0.0F};
  Pixel metric{0.0F};
};

/// When colours differ so much that more samples are worth their time (shading §3.1).
class Comparison {
 public:
  explicit Comparison(const AntialiasOptions& options)
      : threshold_(options.threshold), gamma_(options.gamma), working_(options.working) {}

  [[nodiscard]] Sampled sampled(const Pixel& value) const;
  [[nodiscard]] bool differ(const Sampled& a, const Sampled& b) const;

 private:
  float threshold_;
  float gamma_;
  GammaCurve working_;
};

/// Buffers and rules for one block at a time.
class Antialias {
 public:
  explicit Antialias(const AntialiasOptions& options) : options_(options), compare_(options) {}

  /// Renders `block`. `take(spots, out)` sets out[i] to the picture at spots[i]; `put(x, y, pixel)`
  /// takes the results.
  template <typename Take, typename Put>
  void render(const Block& block, const Take& take, const Put& put) {
    start(block);
    const auto [left, top, right, bottom] = block;
    take_centres({left, top - 1, right, top}, take);
    for (int x = left; x < right; ++x) cell(x, top - 1).done = true;
    if (options_.ahead) {
      take_centres({left - 1, top, left, bottom}, take);
      take_centres(block, take);
    }
    for (int y = top; y < bottom; ++y) {
      if (!options_.ahead) take_centres({left - 1, y, left, y + 1}, take);
      cell(left - 1, y).done = true;
      for (int x = left; x < right; ++x) {
        if (!options_.ahead) take_centres({x, y, x + 1, y + 1}, take);
        visit(x, y, take);
      }
    }
    for (int y = block.top; y < block.bottom; ++y) {
      for (int x = block.left; x < block.right; ++x) put(x, y, cell(x, y).seen.value);
    }
  }

 private:
  struct Cell {
    Sampled seen;
    bool done = false;  // refined, or not to be
  };

  void start(const Block& block);
  Cell& cell(int x, int y) {
    return cells_[static_cast<std::size_t>(y - top_) * stride_ + (x - left_)];
  }

  template <typename Take>
  void take_spots(const Take& take) {
    values_.resize(spots_.size());
    take(std::span<const Spot>(spots_), values_.data());
  }
  template <typename Take>
  void take_centres(const Block& part, const Take& take) {
    spots_.clear();
    in_squares(part, [&](int x, int y) { spots_.push_back({double(x), double(y), 0}); });
    take_spots(take);
    const Pixel* value = values_.data();
    in_squares(part, [&](int x, int y) { cell(x, y).seen = compare_.sampled(*value++); });
  }

  // Compares before any refinement; a neighbour that differs is refined as well, once.
  template <typename Take>
  void visit(int x, int y, const Take& take) {
    const Cell& here = cell(x, y);
    const bool left = compare_.differ(here.seen, cell(x - 1, y).seen);
    const bool above = compare_.differ(here.seen, cell(x, y - 1).seen);
    if (left) refine(x - 1, y, take);
    if (above) refine(x, y - 1, take);
    if (left || above) refine(x, y, take);
  }

  template <typename Take>
  void refine(int x, int y, const Take& take) {
    Cell& c = cell(x, y);
    if (c.done) return;
    const int n = options_.depth;
    const double step = 1.0 / n;
    const double start = -(0.5 - step / 2);
    spots_.clear();
    std::uint32_t index = 0;
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        // Offsets first: the hash below sees the last bit of a position.
        dvec2 at(x + (start + i * step), y + (start + j * step));
        if (options_.jitter > 0) {
          at += jitter(at.x, at.y) * (static_cast<double>(options_.jitter) / n);
        }
        spots_.push_back({at.x, at.y, ++index});
      }
    }
    take_spots(take);
    Pixel sum = c.seen.value;
    for (const Pixel& value : values_) sum += value;
    c.seen = compare_.sampled(sum / static_cast<float>(n * n + 1));
    c.done = true;
  }

  AntialiasOptions options_;
  Comparison compare_;
  std::vector<Cell> cells_;
  std::vector<Spot> spots_;    // that are being sampled …
  std::vector<Pixel> values_;  // … and what is seen there
  int left_ = 0;
  int top_ = 0;
  int stride_ = 0;
};

}  // namespace durer::tracer
