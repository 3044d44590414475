#include "image/png_rows.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <zlib.h>

#include <algorithm>
#include <cstdlib>

namespace durer::image {
namespace {

constexpr std::size_t stretch_size = 1 << 17;  // rows are compressed in pieces of about so much …
constexpr std::size_t sample_size = 1 << 14;   // … after a look at so much of it
constexpr std::size_t reach = 1 << 15;         // how far back zlib can look
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

/// A zlib stream without header and checksum.
class Deflate {
 public:
  Deflate(int level, int strategy) {
    constexpr int raw = -15;  // of the largest window
    constexpr int memory = 8;
    fine_ = deflateInit2(&stream_, level, Z_DEFLATED, raw, memory, strategy) == Z_OK;
  }
  ~Deflate() { deflateEnd(&stream_); }
  Deflate(const Deflate&) = delete;
  Deflate& operator=(const Deflate&) = delete;

  [[nodiscard]] bool fine() const { return fine_; }
  void know(std::span<const unsigned char> dictionary) {
    fine_ = fine_ && deflateSetDictionary(&stream_, dictionary.data(),
                                          static_cast<uInt>(dictionary.size())) == Z_OK;
  }
  /// Appends what becomes of `part`, up to a byte boundary.
  void run(std::span<const unsigned char> part, bool last, std::vector<unsigned char>& out) {
    if (!fine_) return;
    constexpr std::size_t room = 1 << 16;
    stream_.next_in = const_cast<unsigned char*>(part.data());
    stream_.avail_in = static_cast<uInt>(part.size());
    do {
      const std::size_t before = out.size();
      out.resize(before + room);
      stream_.next_out = out.data() + before;
      stream_.avail_out = room;
      fine_ = deflate(&stream_, last ? Z_FINISH : Z_SYNC_FLUSH) != Z_STREAM_ERROR && fine_;
      out.resize(before + room - stream_.avail_out);
    } while (fine_ && stream_.avail_out == 0);
  }

 private:
  z_stream stream_{};
  bool fine_ = false;
};

std::size_t size_of(std::span<const unsigned char> part, int level, int strategy) {
  std::vector<unsigned char> out;
  Deflate(level, strategy).run(part, true, out);
  return out.size();
}

/// True if searching for repetitions would make it smaller by a tenth.
bool repetitive(std::span<const unsigned char> part) {
  const std::size_t size = std::min(part.size(), sample_size);
  part = part.subspan((part.size() - size) / 2, size);
  return size_of(part, quick, Z_FILTERED) * 10 < size_of(part, quick, Z_RLE) * 9;
}

std::uint32_t checksum_of(std::span<const unsigned char> part) {
  return static_cast<std::uint32_t>(adler32_z(adler32(0, nullptr, 0), part.data(), part.size()));
}

}  // namespace

PngRows::PngRows(std::size_t row_bytes, std::size_t pixel_bytes, int level)
    : row_bytes_(row_bytes),
      pixel_bytes_(pixel_bytes),
      level_(level),
      rows_(row_bytes + pixel_bytes) {}

void PngRows::add(std::span<const unsigned char> row) {
  rows_.insert(rows_.end(), pixel_bytes_, 0);
  rows_.insert(rows_.end(), row.begin(), row.end());
  ++count_;
}

/// Row `y`, the first being 1; 0 is the one of zeros.
const unsigned char* PngRows::row(std::size_t y) const {
  return rows_.data() + y * (row_bytes_ + pixel_bytes_) + pixel_bytes_;
}

void PngRows::filter(Stretch& stretch) const {
  std::array<std::vector<unsigned char>, 5> filtered;  // the row, by each filter
  for (std::size_t i = 0; i < filtered.size(); ++i) {
    filtered[i].resize(row_bytes_ + 1);
    filtered[i][0] = static_cast<unsigned char>(i);
  }
  const auto out = [&](std::size_t i) { return std::span(filtered[i]).subspan(1); };
  stretch.filtered.reserve((stretch.end_row - stretch.first_row) * (row_bytes_ + 1));
  for (std::size_t y = stretch.first_row; y < stretch.end_row; ++y) {
    const unsigned char* const here = row(y + 1);
    const unsigned char* const left = here - pixel_bytes_;
    const unsigned char* const above = row(y);
    const unsigned char* const corner = above - pixel_bytes_;
    const std::array<std::size_t, 5> sums{
        differences(out(0), [=](std::size_t i) { return here[i]; }),
        differences(out(1), [=](std::size_t i) { return here[i] - left[i]; }),
        differences(out(2), [=](std::size_t i) { return here[i] - above[i]; }),
        differences(out(3), [=](std::size_t i) { return here[i] - (left[i] + above[i]) / 2; }),
        differences(out(4),
                    [=](std::size_t i) { return here[i] - paeth(left[i], above[i], corner[i]); }),
    };
    const auto best = std::min_element(sums.begin(), sums.end()) - sums.begin();
    const auto& chosen = filtered[static_cast<std::size_t>(best)];
    stretch.filtered.insert(stretch.filtered.end(), chosen.begin(), chosen.end());
  }
}

void PngRows::compress(const Stretch* before, Stretch& stretch, bool last) const {
  const std::span<const unsigned char> part = stretch.filtered;
  const int strategy = level_ >= 0 || repetitive(part) ? Z_FILTERED : Z_RLE;
  Deflate deflate(level_ < 0 ? careful : level_, strategy);
  if (before != nullptr && strategy == Z_FILTERED) {
    const std::span<const unsigned char> past = before->filtered;
    deflate.know(past.last(std::min(past.size(), reach)));
  }
  deflate.run(part, last, stretch.compressed);
  stretch.checksum = checksum_of(part);
  stretch.fine = deflate.fine();
}

std::vector<unsigned char> PngRows::finish(int threads) {
  const std::size_t rows_each = std::max<std::size_t>(1, stretch_size / (row_bytes_ + 1));
  std::vector<Stretch> stretches;
  for (std::size_t y = 0; y < count_; y += rows_each) {
    stretches.push_back({y, std::min(y + rows_each, count_), {}, {}, 0, true});
  }
  if (threads <= 0) threads = tbb::this_task_arena::max_concurrency();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  arena.execute([&] {
    // Two rounds, because a stretch looks back into the filtered rows before it.
    tbb::parallel_for(std::size_t{0}, stretches.size(),
                      [&](std::size_t i) { filter(stretches[i]); });
    tbb::parallel_for(std::size_t{0}, stretches.size(), [&](std::size_t i) {
      compress(i > 0 ? &stretches[i - 1] : nullptr, stretches[i], i + 1 == stretches.size());
    });
  });
  std::vector<unsigned char> out{0x78, 0x9C};  // zlib, a window of 32 KiB (RFC 1950 §2.2)
  uLong checksum = adler32(0, nullptr, 0);
  for (const Stretch& s : stretches) {
    if (!s.fine) return {};
    out.insert(out.end(), s.compressed.begin(), s.compressed.end());
    checksum = adler32_combine(checksum, s.checksum, static_cast<z_off_t>(s.filtered.size()));
  }
  for (int shift = 24; shift >= 0; shift -= 8) {
    out.push_back(static_cast<unsigned char>(checksum >> shift & 0xFF));
  }
  return out;
}

}  // namespace durer::image
