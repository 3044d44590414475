#include "image/png_rows.h"

#include <algorithm>
#include <cstdlib>

namespace durer::image {
namespace {

constexpr std::size_t stretch_size = 1 << 17;  // rows are compressed in pieces of about so much …
constexpr std::size_t sample_size = 1 << 14;   // … after a look at so much of it
constexpr int careful = 6;                     // zlib's levels
constexpr int quick = 4;

/// What the neighbours say that a byte is: the nearest of left, above and upper left (PNG §9.4).
unsigned char paeth(int left, int above, int corner) {
  const int to_left = std::abs(above - corner);
  const int to_above = std::abs(left - corner);
  const int to_corner = std::abs(left + above - 2 * corner);
  // Selections rather than returns: these the compiler can do for many bytes at once.
  const int upper = to_above <= to_corner ? above : corner;
  const bool take_left = (to_left <= to_above) & (to_left <= to_corner);
  return static_cast<unsigned char>(take_left ? left : upper);
}

/// One filter over a row; the sum of the differences' sizes, for the smallest compress best.
template <typename Predict>
std::size_t differences(std::span<unsigned char> out, Predict predict) {
  unsigned sum = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto d = static_cast<unsigned char>(predict(i));
    out[i] = d;
    sum += d < 128 ? d : 256U - d;
  }
  return sum;
}

}  // namespace

PngRows::PngRows(std::size_t row_bytes, std::size_t pixel_bytes, int level)
    : pixel_bytes_(pixel_bytes),
      level_(level),
      strategy_(level < 0 ? Z_RLE : Z_FILTERED),
      row_(row_bytes + pixel_bytes),
      above_(row_bytes + pixel_bytes),
      sample_(2 * sample_size) {
  for (std::size_t i = 0; i < filtered_.size(); ++i) {
    filtered_[i].resize(row_bytes + 1);
    filtered_[i][0] = static_cast<unsigned char>(i);
  }
  waiting_.reserve(stretch_size + row_bytes + 1);
  const auto start = [this](z_stream& stream) {
    const int window = 15;
    const int memory = 8;
    fine_ = deflateInit2(&stream, level_ < 0 ? careful : level_, Z_DEFLATED, window, memory,
                         strategy_) == Z_OK && fine_;
  };
  start(stream_);
  start(sampler_);
}

PngRows::~PngRows() {
  deflateEnd(&stream_);
  deflateEnd(&sampler_);
}

void PngRows::add(std::span<const unsigned char> row) {
  std::copy(row.begin(), row.end(), row_.begin() + static_cast<std::ptrdiff_t>(pixel_bytes_));
  filter();
  std::swap(row_, above_);
  if (waiting_.size() >= stretch_size) compress(false);
}

void PngRows::filter() {
  const unsigned char* const here = row_.data() + pixel_bytes_;
  const unsigned char* const left = row_.data();
  const unsigned char* const above = above_.data() + pixel_bytes_;
  const unsigned char* const corner = above_.data();
  const auto out = [this](std::size_t i) { return std::span(filtered_[i]).subspan(1); };
  const std::array<std::size_t, 5> sums{
      differences(out(0), [=](std::size_t i) { return here[i]; }),
      differences(out(1), [=](std::size_t i) { return here[i] - left[i]; }),
      differences(out(2), [=](std::size_t i) { return here[i] - above[i]; }),
      differences(out(3), [=](std::size_t i) { return here[i] - (left[i] + above[i]) / 2; }),
      differences(out(4), [=](std::size_t i) {
        return here[i] - paeth(left[i], above[i], corner[i]);
      }),
  };
  const auto best = std::min_element(sums.begin(), sums.end()) - sums.begin();
  const auto& chosen = filtered_[static_cast<std::size_t>(best)];
  waiting_.insert(waiting_.end(), chosen.begin(), chosen.end());
}

/// True if searching for repetitions would make it smaller by a tenth.
bool PngRows::repetitive(std::span<unsigned char> part) {
  const std::size_t size = std::min(part.size(), sample_size);
  part = part.subspan((part.size() - size) / 2, size);
  return size_of(part, quick, Z_FILTERED) * 10 < size_of(part, quick, Z_RLE) * 9;
}

std::size_t PngRows::size_of(std::span<unsigned char> part, int level, int strategy) {
  deflateReset(&sampler_);
  deflateParams(&sampler_, level, strategy);
  sampler_.next_in = part.data();
  sampler_.avail_in = static_cast<uInt>(part.size());
  sampler_.next_out = sample_.data();
  sampler_.avail_out = static_cast<uInt>(sample_.size());
  deflate(&sampler_, Z_FINISH);
  return sampler_.total_out;
}

void PngRows::compress(bool last) {
  if (level_ < 0) {
    const int strategy = repetitive(waiting_) ? Z_FILTERED : Z_RLE;
    if (strategy != strategy_) {
      run(Z_BLOCK);
      deflateParams(&stream_, careful, strategy);
      strategy_ = strategy;
    }
  }
  stream_.next_in = waiting_.data();
  stream_.avail_in = static_cast<uInt>(waiting_.size());
  run(last ? Z_FINISH : Z_NO_FLUSH);
  waiting_.clear();
}

/// Lets zlib work until it has no more to write.
void PngRows::run(int flush) {
  constexpr std::size_t room = 1 << 16;
  do {
    if (!fine_) return;
    const std::size_t before = out_.size();
    out_.resize(before + room);
    stream_.next_out = out_.data() + before;
    stream_.avail_out = room;
    const int result = deflate(&stream_, flush);
    fine_ = result != Z_STREAM_ERROR;
    out_.resize(before + room - stream_.avail_out);
  } while (stream_.avail_out == 0);
}

std::vector<unsigned char> PngRows::finish() {
  compress(true);
  if (!fine_) out_.clear();
  return std::move(out_);
}

}  // namespace durer::image
