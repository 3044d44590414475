// Rows of a PNG → the compressed stream of its IDAT chunks.
#pragma once

#include <zlib.h>

#include <array>
#include <span>
#include <vector>

namespace durer::image {

/// Filters each row as suits it, then compresses it. Rendered surfaces are grainy: once filtered,
/// they hold hardly any repetitions, and searching for some took longer than rendering many a
/// scene. So a stretch of rows is searched only where a sample of it says that this is worth it.
class PngRows {
 public:
  /// `pixel_bytes`: distance to the same sample of the next pixel. `level`: 0…9 as zlib has it,
  /// or -1 for what suits the rows.
  PngRows(std::size_t row_bytes, std::size_t pixel_bytes, int level);
  ~PngRows();
  PngRows(const PngRows&) = delete;
  PngRows& operator=(const PngRows&) = delete;

  /// The next row, of `row_bytes`.
  void add(std::span<const unsigned char> row);
  /// The whole stream, after the last row; empty if memory ran out.
  [[nodiscard]] std::vector<unsigned char> finish();

 private:
  void filter();
  void compress(bool last);
  void run(int flush);
  [[nodiscard]] bool repetitive(std::span<unsigned char> part);
  [[nodiscard]] std::size_t size_of(std::span<unsigned char> part, int level, int strategy);

  std::size_t pixel_bytes_;
  int level_;
  int strategy_;
  // `pixel_bytes` zeros before each row stand for what lies left of it.
  std::vector<unsigned char> row_, above_;
  std::array<std::vector<unsigned char>, 5> filtered_;  // the row, by each filter
  std::vector<unsigned char> waiting_;                  // filtered rows
  std::vector<unsigned char> out_, sample_;
  z_stream stream_{}, sampler_{};
  bool fine_ = true;
};

}  // namespace durer::image
