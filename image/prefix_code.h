// Prefix codes as deflate has them (RFC 1951 §3.2.2).
#pragma once

#include <cstdint>
#include <span>

namespace durer::image {

/// Code lengths, in bits, that make a text shortest in which symbol i occurs counts[i] times; 0:
/// it does not occur. At most 320 symbols, of which one or more occur, and fewer than 2^`most`.
/// None becomes longer than `most`, 15 or less; where that matters, the text is a little longer than
/// it could be. Counts add up to less than 2^31.
/// Source: van Leeuwen, "On the construction of Huffman trees", ICALP 1976 (two queues).
void find_lengths(std::span<const std::uint32_t> counts, int most, std::span<std::uint8_t> lengths);

/// The codes to these lengths, the bit that is written first being the lowest.
void find_codes(std::span<const std::uint8_t> lengths, std::span<std::uint16_t> codes);

}  // namespace durer::image
