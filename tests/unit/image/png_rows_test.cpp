#include "image/png_filters.h"
#include "image/repetition.h"
#include "tests/support/catch.h"

namespace durer::image {
namespace {

using Bytes = std::vector<unsigned char>;

/// Bytes of `kinds` values, the small ones being more frequent, each repeated up to `repeats` times.
Bytes noise(std::size_t size, std::uint32_t kinds, std::uint32_t repeats) {
  std::uint32_t state = 7;
  const auto next = [&](std::uint32_t end) {
    state = state * 1664525U + 1013904223U;
    return static_cast<std::uint32_t>(std::uint64_t{state} * end >> 32);
  };
  Bytes out;
  while (out.size() < size) {
    const auto byte = static_cast<unsigned char>(next(next(kinds) + 1));
    out.insert(out.end(), std::min<std::size_t>(size - out.size(), 1 + next(repeats)), byte);
  }
  return out;
}

int paeth(int left, int above, int corner) {
  const int guess = left + above - corner;
  const int a = std::abs(guess - left);
  const int b = std::abs(guess - above);
  const int c = std::abs(guess - corner);
  return a <= b && a <= c ? left : b <= c ? above : corner;
}

/// The row before filter number `type` was applied.
Bytes restored(const FilterRows& rows, const unsigned char* differences, int type) {
  Bytes row(rows.pixel_bytes);
  for (std::size_t i = 0; i < rows.bytes; ++i) {
    const int left = row[i];
    const int above = rows.above[i];
    const int corner = rows.above[i - rows.pixel_bytes];
    const int guesses[] = {0, left, above, (left + above) / 2, paeth(left, above, corner)};
    row.push_back(static_cast<unsigned char>(differences[i] + guesses[type]));
  }
  row.erase(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(rows.pixel_bytes));
  return row;
}

}  // namespace

TEST_CASE("png: repetitions are seen where there are some, and runs are none", "[image][png]") {
  const Bytes grain = noise(16384, 256, 1);
  CHECK(repeated_bytes(grain, 15000) < 100);
  CHECK(repeated_bytes(noise(16384, 256, 2000), 200) < 20);
  Bytes twice(grain.begin(), grain.begin() + 8192);
  twice.insert(twice.end(), grain.begin(), grain.begin() + 8192);
  CHECK(repeated_bytes(twice, 15000) > 5000);
  CHECK(repeated_bytes({}, 0) == 0);
}

TEST_CASE("png filters: a row comes back", "[image][png]") {
  constexpr std::size_t pixel = 3;
  const std::size_t size = GENERATE(3, 15, 48, 999);
  const std::uint32_t kinds = GENERATE(3, 256);
  CAPTURE(size, kinds);
  Bytes above(pixel), here(pixel);
  const Bytes content = noise(2 * size, kinds, 4);
  above.insert(above.end(), content.begin(), content.begin() + static_cast<std::ptrdiff_t>(size));
  here.insert(here.end(), content.begin() + static_cast<std::ptrdiff_t>(size), content.end());
  const FilterRows rows{here.data() + pixel, above.data() + pixel, size, pixel};
  PngFilters filters(size);
  Bytes out(size + 1);
  filters.apply(rows, out.data());
  REQUIRE(out[0] < 5);
  CHECK(restored(rows, out.data() + 1, out[0]) == Bytes(here.begin() + pixel, here.end()));
}

// Five bytes at which every other filter does worse make sure of the fourth.
TEST_CASE("png filters: of three neighbours the nearest is the guess, wherever they lie",
          "[image][png]") {
  constexpr std::size_t pixel = 8;
  constexpr std::size_t size = 6;
  Bytes above(pixel + size, 255), here(pixel + size, 100);
  std::fill_n(above.begin(), 5, static_cast<unsigned char>(100));
  std::fill_n(here.begin(), 5, static_cast<unsigned char>(0));
  PngFilters filters(size);
  Bytes out(size + 1);
  int wrong = 0;
  for (int corner = 0; corner < 256; corner += 3) {
    for (int left = 0; left < 256; ++left) {
      for (int upper = 0; upper < 256; ++upper) {
        above[5] = static_cast<unsigned char>(corner);
        above.back() = static_cast<unsigned char>(upper);
        here[5] = static_cast<unsigned char>(left);
        here.back() = static_cast<unsigned char>(paeth(left, upper, corner));
        filters.apply({here.data() + pixel, above.data() + pixel, size, pixel}, out.data());
        if (out != Bytes{4, 0, 0, 0, 0, 0, 0}) ++wrong;
      }
    }
  }
  CHECK(wrong == 0);
}

}  // namespace durer::image
