#include "image/png_rows.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <zlib.h>

#include <algorithm>

#include "image/png_filters.h"
#include "image/repetition.h"

namespace durer::image {
namespace {

constexpr std::size_t stretch_size = 1 << 17;  // rows are compressed in pieces of about so much …
constexpr std::size_t glimpse_size = 1 << 13;  // … after a quick look at so much of it
constexpr std::size_t sample_size = 1 << 14;   // … and if need be a thorough one at so much
constexpr std::size_t reach = 1 << 15;         // how far back zlib can look
constexpr int careful = 6;                     // zlib's levels
constexpr int quick = 4;

/// A zlib stream without header and checksum.
class Deflate {
 public:
  explicit Deflate(int level, int strategy = Z_FILTERED) {
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

std::span<const unsigned char> middle(std::span<const unsigned char> part, std::size_t size) {
  size = std::min(part.size(), size);
  return part.subspan((part.size() - size) / 2, size);
}

/// True if searching for repetitions would make it smaller by a tenth than the `size` that it has
/// without.
bool repetitive(std::span<const unsigned char> part, std::size_t size) {
  const auto glimpse = middle(part, glimpse_size);
  const std::size_t expected = size * glimpse.size() / part.size();
  if (repeated_bytes(glimpse, expected) * 12 < static_cast<double>(expected)) return false;
  const auto sample = middle(part, sample_size);
  std::vector<unsigned char> searched, runs;
  Deflate(quick).run(sample, true, searched);
  Deflate(quick, Z_RLE).run(sample, true, runs);
  return searched.size() * 10 < runs.size() * 9;
}

std::uint32_t checksum_of(std::span<const unsigned char> part) {
  return static_cast<std::uint32_t>(adler32_z(adler32(0, nullptr, 0), part.data(), part.size()));
}

}  // namespace

/// Filters and compresses one stretch after another, on one thread.
class PngRows::Worker {
 public:
  explicit Worker(const PngRows& rows)
      : rows_(rows),
        line_(rows.row_bytes_ + 1),
        filters_(rows.row_bytes_),
        above_(rows.pixel_bytes_ + rows.row_bytes_),
        here_(above_) {}

  void run(Stretch& stretch, const Source& source);

 private:
  std::span<unsigned char> row(std::vector<unsigned char>& v) const {
    return std::span(v).subspan(
        rows_.pixel_bytes_);  // zeros stand for what lies left of the picture
  }
  unsigned char* filtered(std::size_t y) { return &filtered_[(y - first_) * line_]; }
  void make_room(const Stretch& stretch);
  void filter(std::size_t from, std::size_t end, const Source& source);
  void compress(Stretch& stretch, std::span<const unsigned char> part, const Source& source);

  const PngRows& rows_;
  std::size_t line_;  // bytes of a filtered row, with the number of its filter
  PngFilters filters_;
  std::vector<unsigned char> above_, here_;
  // Rows from `first_` on: those that the stretch may look back at, and its own; `known_` to `end_`
  // are there.
  std::vector<unsigned char> filtered_;
  std::size_t first_ = 0;
  std::size_t known_ = 0;
  std::size_t end_ = 0;
  std::size_t after_above_ = 0;  // the row below that in `above_`
};

PngRows::PngRows(std::size_t row_bytes, std::size_t pixel_bytes, std::size_t count, int level)
    : row_bytes_(row_bytes), pixel_bytes_(pixel_bytes), count_(count), level_(level) {}

void PngRows::Worker::run(Stretch& stretch, const Source& source) {
  make_room(stretch);
  filter(stretch.first_row, stretch.end_row, source);
  end_ = stretch.end_row;
  const std::size_t bytes = (stretch.end_row - stretch.first_row) * line_;
  const std::span<const unsigned char> part(filtered(stretch.first_row), bytes);
  stretch.checksum = checksum_of(part);
  compress(stretch, part, source);
}

/// Keeps the end of the stretch before if that was the last one here.
void PngRows::Worker::make_room(const Stretch& stretch) {
  const std::size_t back = std::min(stretch.first_row, (reach + line_ - 1) / line_);
  const std::size_t first = stretch.first_row - back;
  const bool follows = end_ == stretch.first_row && known_ <= first;
  filtered_.resize(std::max(filtered_.size(), (stretch.end_row - first) * line_));
  if (follows) std::copy_n(filtered(first), back * line_, filtered_.begin());
  known_ = follows ? first : stretch.first_row;
  first_ = first;
}

void PngRows::Worker::filter(std::size_t from, std::size_t end, const Source& source) {
  if (from == 0) {
    std::fill(above_.begin(), above_.end(), 0);
  } else if (from != after_above_) {
    source(from - 1, row(above_));
  }
  for (std::size_t y = from; y < end; ++y) {
    source(y, row(here_));
    filters_.apply({row(here_).data(), row(above_).data(), rows_.row_bytes_, rows_.pixel_bytes_},
                   filtered(y));
    std::swap(here_, above_);
  }
  after_above_ = end;
}

void PngRows::Worker::compress(Stretch& stretch, std::span<const unsigned char> part,
                               const Source& source) {
  const bool last = stretch.end_row == rows_.count_;
  const int level = rows_.level_;
  if (level < 0) {
    Deflate runs(quick, Z_RLE);
    runs.run(part, last, stretch.compressed);
    stretch.fine = runs.fine();
    if (!stretch.fine || !repetitive(part, stretch.compressed.size())) return;
    stretch.compressed.clear();
  }
  Deflate deflate(level < 0 ? careful : level);
  const std::size_t before = (stretch.first_row - first_) * line_;
  if (before > 0) {
    if (first_ < known_) {
      filter(first_, known_, source);
      known_ = first_;
    }
    const std::size_t back = std::min(before, reach);
    deflate.know({part.data() - back, back});
  }
  deflate.run(part, last, stretch.compressed);
  stretch.fine = deflate.fine();
}

std::vector<unsigned char> PngRows::stream(const Source& source, int threads) {
  const std::size_t rows_each = std::max<std::size_t>(1, stretch_size / (row_bytes_ + 1));
  std::vector<Stretch> stretches;
  for (std::size_t y = 0; y < count_; y += rows_each) {
    stretches.push_back({y, std::min(y + rows_each, count_), {}, 0, true});
  }
  if (threads <= 0) threads = tbb::this_task_arena::max_concurrency();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  tbb::enumerable_thread_specific<Worker> workers([this] { return Worker(*this); });
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, stretches.size(),
                      [&](std::size_t i) { workers.local().run(stretches[i], source); });
  });
  std::vector<unsigned char> out{0x78, 0x9C};  // zlib, a window of 32 KiB (RFC 1950 §2.2)
  std::size_t size = out.size() + 4;
  for (const Stretch& s : stretches) size += s.compressed.size();
  out.reserve(size);
  uLong checksum = adler32(0, nullptr, 0);
  for (const Stretch& s : stretches) {
    if (!s.fine) return {};
    out.insert(out.end(), s.compressed.begin(), s.compressed.end());
    const std::size_t bytes = (s.end_row - s.first_row) * (row_bytes_ + 1);
    checksum = adler32_combine(checksum, s.checksum, static_cast<z_off_t>(bytes));
  }
  for (int shift = 24; shift >= 0; shift -= 8) {
    out.push_back(static_cast<unsigned char>(checksum >> shift & 0xFF));
  }
  return out;
}

}  // namespace durer::image
