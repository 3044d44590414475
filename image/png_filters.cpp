#include "image/png_filters.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace durer::image {
namespace {

using Byte = std::uint8_t;

// Everything below stays in bytes, so that the compiler can work on sixteen at once.

Byte distance(Byte a, Byte b) { return static_cast<Byte>(a > b ? a - b : b - a); }

/// The mean, rounded down: what both have, and half of what one has.
Byte mean(Byte a, Byte b) { return static_cast<Byte>((a & b) + ((a ^ b) >> 1)); }

/// What the neighbours say that a byte is: the nearest of left, above and corner to left + above -
/// corner (PNG §9.4). That is as far from left as above is from the corner, and as far from above
/// as left is; the corner can be nearer than these two only where it lies between them.
Byte paeth(Byte left, Byte above, Byte corner) {
  const Byte to_left = distance(above, corner);
  const Byte to_above = distance(left, corner);
  const Byte side = to_left <= to_above ? left : above;
  const Byte nearest = std::min(to_left, to_above);
  const Byte to_corner = distance(to_left, to_above);
  const Byte low = std::min(left, above);
  const Byte high = std::max(left, above);
  const Byte within = (corner < low ? Byte{0} : Byte{255}) & (corner > high ? Byte{0} : Byte{255});
  const Byte nearer = to_corner < nearest ? Byte{255} : Byte{0};
  const Byte take_corner = within & nearer;
  return static_cast<Byte>((corner & take_corner) | (side & ~take_corner));
}

template <typename Guess>
void differences(const FilterRows& rows, unsigned char* __restrict out, Guess guess) {
  const unsigned char* const here = rows.here;
  for (std::size_t i = 0; i < rows.bytes; ++i) out[i] = static_cast<Byte>(here[i] - guess(i));
}

/// The sum of the differences' sizes: how far each is from 0, on either side. As far as from
/// `centre`, which is 128, once both are moved there. Where the compiler does not know that, it
/// finds a sum of distances between bytes, for which processors have an instruction.
std::uint32_t total_size(const std::vector<unsigned char>& differences, Byte centre) {
  std::uint32_t sum = 0;
  for (std::size_t i = 1; i < differences.size(); ++i) {
    const int d = static_cast<Byte>(differences[i] ^ centre) - centre;
    sum += static_cast<std::uint32_t>(d < 0 ? -d : d);
  }
  return sum;
}

}  // namespace

PngFilters::PngFilters(std::size_t row_bytes) {
  for (std::size_t i = 0; i < count; ++i) {
    filtered_[i].resize(row_bytes + 1);
    filtered_[i][0] = static_cast<unsigned char>(i);
  }
}

void PngFilters::apply(const FilterRows& rows, unsigned char* out) {
  const unsigned char* const left = rows.here - rows.pixel_bytes;
  const unsigned char* const above = rows.above;
  const unsigned char* const corner = above - rows.pixel_bytes;
  const auto to = [this](std::size_t i) { return filtered_[i].data() + 1; };
  std::size_t best = 0;
  std::uint32_t least = std::numeric_limits<std::uint32_t>::max();
  // Nothing is smaller than nothing, and many a row is like the one above it: what is left is
  // spared.
  const auto try_next = [&](std::size_t i, auto guess) {
    if (least == 0) return;
    differences(rows, to(i), guess);
    const std::uint32_t size = total_size(filtered_[i], centre_);
    if (size < least) best = i, least = size;
  };
  try_next(0, [](std::size_t) { return Byte{0}; });
  try_next(1, [=](std::size_t i) { return left[i]; });
  try_next(2, [=](std::size_t i) { return above[i]; });
  try_next(3, [=](std::size_t i) { return mean(left[i], above[i]); });
  try_next(4, [=](std::size_t i) { return paeth(left[i], above[i], corner[i]); });
  std::copy(filtered_[best].begin(), filtered_[best].end(), out);
}

}  // namespace durer::image
