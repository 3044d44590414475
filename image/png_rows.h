// Rows of a PNG → the compressed stream of its IDAT chunks.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/large_array.h"

namespace durer::image {

/// Filters each row as suits it, then compresses it. Rendered surfaces are grainy: once filtered,
/// they hold hardly any repetitions, and searching for some took longer than rendering many a
/// scene. So a stretch of rows is searched only where a sample of it says that this is worth it.
///
/// Stretches are compressed side by side, each with the end of the one before as its dictionary,
/// and joined at byte boundaries, as pigz does it. The stream is the same for any number of
/// threads.
class PngRows {
 public:
  /// `row_bytes`: of each of `count` rows. `pixel_bytes`: distance to the same sample of the next
  /// pixel. `level`: 0…9 as zlib has it, or -1 for what suits the rows.
  PngRows(std::size_t row_bytes, std::size_t pixel_bytes, std::size_t count, int level);

  /// Where row `y` goes.
  [[nodiscard]] std::span<unsigned char> row(std::size_t y) {
    return {rows_.data() + begin_of(y + 1), row_bytes_};
  }
  /// The whole stream, after all rows are there; empty if memory ran out. `threads` work on it; 0:
  /// one per processor.
  [[nodiscard]] std::vector<unsigned char> finish(int threads);

 private:
  struct Stretch {
    std::size_t first_row, end_row;
    std::vector<unsigned char> compressed;
    std::uint32_t checksum;
    bool fine;
  };
  /// Of row `y`, the first being 1; 0 is the one of zeros.
  [[nodiscard]] std::size_t begin_of(std::size_t y) const {
    return y * (row_bytes_ + pixel_bytes_) + pixel_bytes_;
  }
  void filter(const Stretch& stretch);
  void compress(Stretch& stretch) const;

  std::size_t row_bytes_;
  std::size_t pixel_bytes_;
  std::size_t count_;
  int level_;
  // A row of zeros, then the rows; `pixel_bytes` zeros before each stand for what lies left of it.
  LargeArray<unsigned char> rows_;
  LargeArray<unsigned char> filtered_;  // with the number of the filter before each row
};

}  // namespace durer::image
