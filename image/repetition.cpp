#include "image/repetition.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "image/bytes.h"

namespace durer::image {
namespace {

constexpr double reference = 26;  // bits that a place and a length take, about
constexpr int index_bits = 12;

}  // namespace

double repeated_bytes(std::span<const unsigned char> part, std::size_t size) {
  if (part.empty() || size == 0) return 0;
  const double byte_bits = 8.0 * static_cast<double>(size) / static_cast<double>(part.size());
  // What is shorter costs less as it is.
  const auto shortest = static_cast<std::size_t>(std::clamp(reference / byte_bits + 2, 4.0, 40.0));
  const std::size_t known = std::min<std::size_t>(shortest, 8);  // bytes that are looked up
  std::array<std::uint16_t, 1U << index_bits> last{};  // where such bytes have stood
  double bits = 0;
  for (std::size_t i = 1; i + 8 <= part.size();) {
    const std::uint64_t here = load64(&part[i]) << (64 - 8 * known);
    std::uint16_t& entry = last[here * 0x9E3779B97F4A7C15U >> (64 - index_bits)];
    const std::size_t before = entry;
    entry = static_cast<std::uint16_t>(i);
    std::size_t n = 0;
    // Runs, which repeat the byte before, are not counted.
    if (before + 1 < i && load64(&part[before]) << (64 - 8 * known) == here) {
      n = known;
      while (i + n < part.size() && part[before + n] == part[i + n]) ++n;
    }
    if (n < shortest) {
      ++i;
      continue;
    }
    bits += static_cast<double>(n) * byte_bits - reference;
    i += n;
  }
  return bits / 8;
}

}  // namespace durer::image
