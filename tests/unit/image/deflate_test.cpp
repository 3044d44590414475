#include <zlib.h>

#include "image/png_filters.h"
#include "image/prefix_code.h"
#include "image/repetition.h"
#include "image/run_deflate.h"
#include "tests/support/catch.h"

namespace durer::image {
namespace {

using Bytes = std::vector<unsigned char>;

/// What zlib makes of a raw stream; empty if it is broken or does not end.
Bytes inflated(const Bytes& stream, std::size_t size) {
  Bytes out(size + 1);
  z_stream z{};
  REQUIRE(inflateInit2(&z, -15) == Z_OK);
  z.next_in = const_cast<unsigned char*>(stream.data());
  z.avail_in = static_cast<uInt>(stream.size());
  z.next_out = out.data();
  z.avail_out = static_cast<uInt>(out.size());
  const bool whole = inflate(&z, Z_FINISH) == Z_STREAM_END && z.avail_in == 0;
  out.resize(whole ? z.total_out : 0);
  inflateEnd(&z);
  return out;
}

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

TEST_CASE("deflate: what was written by frequencies and runs comes back", "[image][deflate]") {
  const std::size_t size = GENERATE(1, 2, 7, 8, 300, 32768, 32769, 100000);
  const std::uint32_t kinds = GENERATE(1, 2, 30, 256);
  const std::uint32_t repeats = GENERATE(1, 9, 700);
  CAPTURE(size, kinds, repeats);
  const Bytes bytes = noise(size, kinds, repeats);
  Bytes stream;
  deflate_runs(bytes, true, stream);
  CHECK(inflated(stream, size) == bytes);
  const std::size_t half = size / 2;
  if (half == 0) return;
  Bytes joined;
  deflate_runs(std::span(bytes).first(half), false, joined);
  deflate_runs(std::span(bytes).subspan(half), true, joined);
  CHECK(inflated(joined, size) == bytes);
}

TEST_CASE("deflate: no code is longer than allowed, and every code is taken", "[image][deflate]") {
  const int most = GENERATE(7, 15);
  std::vector<std::uint32_t> counts{1, 1};
  while (counts.size() < 40) counts.push_back(counts[counts.size() - 1] + counts[counts.size() - 2]);
  counts.resize(most == 7 ? 19 : 40);  // Fibonacci's numbers make the deepest trees
  counts[3] = 0;
  std::vector<std::uint8_t> lengths(counts.size());
  find_lengths(counts, most, lengths);
  unsigned taken = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    CHECK((lengths[i] == 0) == (counts[i] == 0));
    CHECK(lengths[i] <= most);
    if (lengths[i] > 0) taken += 1U << (most - lengths[i]);
  }
  CHECK(taken == 1U << most);
}

TEST_CASE("deflate: repetitions are seen where there are some, and runs are none", "[image][deflate]") {
  const Bytes grain = noise(16384, 256, 1);
  CHECK(repeated_bytes(grain, 15000) < 100);
  CHECK(repeated_bytes(noise(16384, 256, 2000), 200) < 20);
  Bytes twice(grain.begin(), grain.begin() + 8192);
  twice.insert(twice.end(), grain.begin(), grain.begin() + 8192);
  CHECK(repeated_bytes(twice, 15000) > 5000);
  CHECK(repeated_bytes({}, 0) == 0);
}

TEST_CASE("filters: a row comes back", "[image][deflate]") {
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
TEST_CASE("filters: of three neighbours the nearest is the guess, wherever they lie",
          "[image][deflate]") {
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
