// Rows of a PNG → the compressed stream of its IDAT chunks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace durer::image {

/// Filters each row as suits it, then compresses it. Rendered surfaces are grainy: once filtered,
/// they hold hardly any repetitions, and searching for some took longer than rendering many a
/// scene. So a stretch of rows is searched only where a sample of it says that this is worth it.
///
/// Stretches are compressed side by side, each with the end of the one before as its dictionary,
/// and joined at byte boundaries, as pigz does it. The stream is the same for any number of
/// threads. No more is kept of the filtered rows than a stretch and what it looks back at: that
/// fits into a processor's cache.
class PngRows {
 public:
  /// `row_bytes`: of each of `count` rows. `pixel_bytes`: distance to the same sample of the next
  /// pixel. `level`: 0…9 as zlib has it, or -1 for what suits the rows.
  PngRows(std::size_t row_bytes, std::size_t pixel_bytes, std::size_t count, int level);

  /// Writes row `y`; asked by several threads, and for some rows twice.
  using Source = std::function<void(std::size_t y, std::span<unsigned char> row)>;
  /// The whole stream; empty if memory ran out. `threads` work on it; 0: one per processor.
  [[nodiscard]] std::vector<unsigned char> stream(const Source& source, int threads);

 private:
  struct Stretch {
    std::size_t first_row, end_row;
    std::vector<unsigned char> compressed;
    std::uint32_t checksum;
    bool fine;
  };
  class Worker;

  std::size_t row_bytes_;
  std::size_t pixel_bytes_;
  std::size_t count_;
  int level_;
};

}  // namespace durer::image
