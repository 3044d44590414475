// Anti-aliasing method 2 (shading §3.3): a pixel is the mean of its corners; where they differ it is
// cut in four, and each quarter is treated likewise.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tracer/film/antialias.h"

namespace durer::tracer {

/// Buffers and rules for one block at a time. Pixels share nothing but the samples of their corners.
class AdaptiveAntialias {
 public:
  explicit AdaptiveAntialias(const AntialiasOptions& options)
      : compare_(options),
        depth_(options.depth),
        intervals_(1 << (options.depth - 1)),
        jitter_(static_cast<double>(options.jitter) / ((1 << options.depth) + 1)) {}

  /// See Antialias::render. Corners of pixels are sampled without jitter.
  template <typename Sample, typename Put>
  void render(const Block& block, const Sample& sample, const Put& put) {
    const int stride = block.right - block.left + 1;
    corners_.clear();
    for (int y = block.top; y <= block.bottom; ++y) {
      for (int x = block.left; x <= block.right; ++x) {
        corners_.push_back(compare_.sampled(sample(x - 0.5, y - 0.5, 0U)));
      }
    }
    for (int y = block.top; y < block.bottom; ++y) {
      for (int x = block.left; x < block.right; ++x) {
        const auto corner = static_cast<std::size_t>((y - block.top) * stride + x - block.left);
        const std::array four{corners_[corner], corners_[corner + 1],
                              corners_[corner + static_cast<std::size_t>(stride)],
                              corners_[corner + static_cast<std::size_t>(stride) + 1]};
        put(x, y, pixel(x, y, four, sample));
      }
    }
  }

 private:
  // A square of a pixel: its place in the pixel's lattice, and its corners: upper left, upper right,
  // lower left, lower right.
  struct Square {
    int x = 0;
    int y = 0;
    int size = 0;
    std::array<Sampled, 4> corners;
  };

  template <typename Sample>
  Pixel pixel(int x, int y, const std::array<Sampled, 4>& corners, const Sample& sample) {
    const Square whole{0, 0, intervals_, corners};
    if (depth_ == 1 || !differ(whole)) return mean(corners);
    const auto stride = static_cast<std::size_t>(intervals_ + 1);
    lattice_.assign(stride * stride, {});
    const auto take = [&](int i, int j) -> const Sampled& {
      Point& p = lattice_[static_cast<std::size_t>(j) * stride + static_cast<std::size_t>(i)];
      if (!p.known) {
        const dvec2 at(x - 0.5 + static_cast<double>(i) / intervals_,
                       y - 0.5 + static_cast<double>(j) / intervals_);
        const dvec2 moved = jitter_ > 0 ? at + jitter(at.x, at.y) * jitter_ : at;
        const auto index = static_cast<std::uint32_t>(&p - lattice_.data()) + 1;
        p = {compare_.sampled(sample(moved.x, moved.y, index)), true};
      }
      return p.seen;
    };
    return divide(whole, take);
  }

  template <typename Take>
  Pixel divide(const Square& s, const Take& take) {
    if (s.size == 1 || !differ(s)) return mean(s.corners);
    const int half = s.size / 2;
    const Sampled left = take(s.x, s.y + half);
    const Sampled top = take(s.x + half, s.y);
    const Sampled right = take(s.x + s.size, s.y + half);
    const Sampled bottom = take(s.x + half, s.y + s.size);
    const Sampled centre = take(s.x + half, s.y + half);
    const auto& c = s.corners;
    Pixel sum = divide({s.x, s.y, half, {c[0], top, left, centre}}, take);
    sum += divide({s.x, s.y + half, half, {left, centre, c[2], bottom}}, take);
    sum += divide({s.x + half, s.y, half, {top, c[1], centre, right}}, take);
    sum += divide({s.x + half, s.y + half, half, {centre, right, bottom, c[3]}}, take);
    return sum / 4.0F;
  }

  [[nodiscard]] bool differ(const Square& s) const {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = i + 1; k < 4; ++k) {
        if (compare_.differ(s.corners[i], s.corners[k])) return true;
      }
    }
    return false;
  }
  [[nodiscard]] static Pixel mean(const std::array<Sampled, 4>& c) {
    return (c[0].value + c[1].value + c[2].value + c[3].value) / 4.0F;
  }

  struct Point {
    Sampled seen;
    bool known = false;
  };

  Comparison compare_;
  int depth_;
  int intervals_;  // of the finest lattice, along one edge of a pixel
  double jitter_;
  std::vector<Sampled> corners_;  // of the block's pixels
  std::vector<Point> lattice_;    // of one pixel
};

}  // namespace durer::tracer
