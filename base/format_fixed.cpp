#include "base/format_fixed.h"

#include <bit>
#include <charconv>
#include <cstdint>

namespace durer {
namespace {

__extension__ using Wide = unsigned __int128;

constexpr int most_places = 15;
constexpr std::uint64_t powers_of_ten[most_places + 1] = {1,
                                                          10,
                                                          100,
                                                          1000,
                                                          10000,
                                                          100000,
                                                          1000000,
                                                          10000000,
                                                          100000000,
                                                          1000000000,
                                                          10000000000,
                                                          100000000000,
                                                          1000000000000,
                                                          10000000000000,
                                                          100000000000000,
                                                          1000000000000000};

/// |value|·10^places, rounded half to even; false if it does not fit.
bool scaled(std::uint64_t bits, int places, std::uint64_t& out) {
  const int exponent = static_cast<int>(bits >> 52 & 0x7FF);
  if (exponent == 0) {  // zero; or so tiny that the general way may have it
    out = 0;
    return (bits << 1) == 0;
  }
  const std::uint64_t mantissa = (bits & 0xFFFFFFFFFFFFF) | std::uint64_t{1} << 52;
  const int shift = 1075 - exponent;  // value = mantissa / 2^shift
  if (shift < 0 || shift > 120) return false;
  const Wide product = Wide{mantissa} * powers_of_ten[places];  // < 2^53 · 2^50
  const Wide whole = product >> shift;
  if (whole >> 63 != 0) return false;
  out = static_cast<std::uint64_t>(whole);
  if (shift == 0) return true;
  const Wide rest = product - (whole << shift);
  const Wide half = Wide{1} << (shift - 1);
  if (rest > half || (rest == half && (out & 1) != 0)) ++out;
  return true;
}

/// Writes at least `least` digits before `at`, two with every division.
void put_digits(std::uint64_t digits, int least, char*& at) {
  static constexpr char pairs[] =
      "00010203040506070809101112131415161718192021222324252627282930313233343536373839404142434445"
      "46474849505152535455565758596061626364656667686970717273747576777879808182838485868788899091"
      "9293949596979899";
  char* const stop = at - least;
  while (digits >= 10) {
    const char* pair = pairs + 2 * (digits % 100);
    digits /= 100;
    *--at = pair[1];
    *--at = pair[0];
  }
  if (digits > 0) *--at = static_cast<char>('0' + digits);
  while (at > stop) *--at = '0';
}

}  // namespace

std::string_view format_fixed(double value, int places, char (&buffer)[format_fixed_size]) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  std::uint64_t digits = 0;
  if (places > most_places || !scaled(bits, places, digits)) {
    const auto end = std::to_chars(buffer, buffer + format_fixed_size, value,
                                   std::chars_format::fixed, places);
    return {buffer, static_cast<std::size_t>(end.ptr - buffer)};
  }
  char* const end = buffer + format_fixed_size;
  char* at = end;
  if (places > 0) {
    const std::uint64_t whole = digits / powers_of_ten[places];
    put_digits(digits - whole * powers_of_ten[places], places, at);
    *--at = '.';
    digits = whole;
  }
  put_digits(digits, 1, at);
  if (bits >> 63 != 0) *--at = '-';
  return {at, static_cast<std::size_t>(end - at)};
}

}  // namespace durer
