// The filters of PNG (§9): what is left of a row after a guess at it.
#pragma once

#include <cstddef>
#include <vector>

namespace durer::image {

/// Where a row and the one above it begin; before both stand `pixel_bytes` zeros, for what lies left
/// of them.
struct FilterRows {
  const unsigned char* here;
  const unsigned char* above;
  std::size_t bytes;        // of a row
  std::size_t pixel_bytes;  // distance to the same sample of the next pixel
};

/// Chooses filters for one row after another.
class PngFilters {
 public:
  explicit PngFilters(std::size_t row_bytes);

  /// Writes the number of the filter whose differences are the smallest, for these compress best,
  /// and the differences: a byte more than the row has.
  void apply(const FilterRows& rows, unsigned char* out);

 private:
  static constexpr std::size_t count = 5;
  std::vector<unsigned char> filtered_[count];  // the row, by each filter
  unsigned char centre_ = 128;                  // not to be known when this is compiled
};

}  // namespace durer::image
