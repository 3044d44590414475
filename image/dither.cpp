#include "image/dither.h"

#include <utility>

namespace durer::image {
namespace {

// Bayer's matrices, by column, then row.
constexpr float bayer2[2][2] = {{1, 3}, {4, 2}};
constexpr float bayer3[3][3] = {{3, 7, 4}, {6, 1, 9}, {2, 8, 5}};
constexpr float bayer4[4][4] = {{1, 9, 3, 11}, {13, 5, 15, 7}, {4, 12, 2, 10}, {16, 8, 14, 6}};

}  // namespace

Ditherer::Ditherer(Dither method, int width) : method_(method), width_(width) {
  if (two_rows()) {
    here_.assign(static_cast<std::size_t>(width), {});
    below_ = here_;
  }
}

void Ditherer::enter(int x, int y) {
  x_ = x;
  switch (method_) {
    case Dither::none: return;
    case Dither::b2: threshold_ = bayer2[x % 2][y % 2] / 4 - 0.5F; return;
    case Dither::b3: threshold_ = bayer3[x % 3][y % 3] / 9 - 0.5F; return;
    case Dither::b4: threshold_ = bayer4[x % 4][y % 4] / 16 - 0.5F; return;
    case Dither::d1: offsets_ = last_; return;
    case Dither::d2:
    case Dither::fs: break;
  }
  // The rows change only after the first pixel has been looked up: as the oracle does it.
  offsets_ = here_[static_cast<std::size_t>(x)];
  if (x == 0 && y > 0) {
    std::swap(here_, below_);
    below_.assign(below_.size(), {});
  }
}

void Ditherer::add(std::vector<Errors>& row, int x, int channel, float error) {
  if (x < 0 || x >= width_) return;
  row[static_cast<std::size_t>(x)][static_cast<std::size_t>(channel)] += error;
}

void Ditherer::spread(int channel, float error) {
  switch (method_) {
    case Dither::d1: last_[static_cast<std::size_t>(channel)] = error; return;
    case Dither::d2:
      add(here_, x_ + 1, channel, error / 2);
      add(below_, x_, channel, error / 4);
      add(below_, x_ + 1, channel, error / 4);
      return;
    case Dither::fs:
      add(here_, x_ + 1, channel, error * (7 / 16.0F));
      add(below_, x_ - 1, channel, error * (3 / 16.0F));
      add(below_, x_, channel, error * (5 / 16.0F));
      add(below_, x_ + 1, channel, error * (1 / 16.0F));
      return;
    default: return;
  }
}

}  // namespace durer::image
