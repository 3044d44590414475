#include "image/run_deflate.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "image/bit_writer.h"
#include "image/bytes.h"
#include "image/prefix_code.h"

namespace durer::image {
namespace {

constexpr std::size_t block_size = 1 << 15;  // bytes with codes of their own
constexpr std::size_t shortest_run = 7;  // hardly any shorter one costs less than its bytes
constexpr std::size_t longest_run = 258;
constexpr int longest_code = 12;  // so that four are 48 bits; with 15 files are 0.3 % smaller
constexpr std::size_t end_of_block = 256;
constexpr std::size_t symbols = 286;  // bytes, the end, lengths of runs

/// Some bytes as they are, then one that is repeated; `run` 0: none is.
struct Piece {
  const unsigned char* bytes;
  std::uint32_t count;
  std::uint32_t run;
};

/// How often the byte before `p` is repeated from there on.
std::size_t run_length(const unsigned char* p, const unsigned char* end) {
  const std::size_t most = std::min(longest_run, static_cast<std::size_t>(end - p));
  std::size_t n = 0;
  for (; n + 8 <= most; n += 8) {
    const std::uint64_t change = load64(p + n - 1) ^ load64(p + n);
    if (change != 0) return n + static_cast<std::size_t>(std::countr_zero(change)) / 8;
  }
  while (n < most && p[n] == p[n - 1]) ++n;
  return n;
}

/// The first place from `p` on where a run begins; `end` if there is none. Of seven bytes in a row,
/// four stand at multiples of four from `p`.
const unsigned char* next_run(const unsigned char* p, const unsigned char* end) {
  static_assert(shortest_run >= 7);
  for (const unsigned char* four = p; end - four >= 8; four += 4) {
    const std::uint64_t change = load64(four - 1) ^ load64(four);
    if ((change & 0xFFFFFFFF) != 0) {
      if (change >> 32 != 0) four += 4;
      continue;
    }
    const unsigned char* first = four;
    while (first > p && first[-1] == first[-2]) --first;
    if (run_length(first, end) >= shortest_run) return first;
  }
  constexpr std::ptrdiff_t rest = 10;  // the last that these have not seen
  if (end - p > rest) p = end - rest;
  while (p < end && run_length(p, end) < shortest_run) ++p;
  return p;
}

/// Cuts `block` into pieces; `first`: of its stream, so that nothing stands before it.
void cut(std::span<const unsigned char> block, bool first, std::vector<Piece>& pieces) {
  pieces.clear();
  const unsigned char* p = block.data();
  const unsigned char* const end = p + block.size();
  while (p < end) {
    const unsigned char* from = p;
    if (first) ++from;
    first = false;
    const unsigned char* const run = next_run(from, end);
    const std::size_t length = run < end ? run_length(run, end) : 0;
    pieces.push_back({p, static_cast<std::uint32_t>(run - p), static_cast<std::uint32_t>(length)});
    p = run + length;
  }
}

/// How deflate writes the length of a run: a symbol, and some bits.
struct RunLength {
  std::size_t symbol;
  std::uint32_t extra = 0;
  std::uint32_t extra_bits = 0;

  explicit RunLength(std::uint32_t length) {
    const std::uint32_t v = length - 3;
    if (length == longest_run) {
      symbol = 285;
    } else if (v < 8) {
      symbol = 257 + v;
    } else {
      extra_bits = static_cast<std::uint32_t>(std::bit_width(v)) - 3;
      symbol = 257 + 4 * extra_bits + (v >> extra_bits);
      extra = v & ((1U << extra_bits) - 1);
    }
  }
};

using Counts = std::array<std::uint32_t, symbols>;

Counts count(std::span<const Piece> pieces) {
  // Four tables, for a byte is often that of a moment ago, whose count is still on its way.
  std::array<std::array<std::uint32_t, 256>, 4> bytes{};
  Counts all{};
  for (const Piece& piece : pieces) {
    const unsigned char* p = piece.bytes;
    std::uint32_t i = 0;
    for (; i + 4 <= piece.count; i += 4) {
      ++bytes[0][p[i]], ++bytes[1][p[i + 1]], ++bytes[2][p[i + 2]], ++bytes[3][p[i + 3]];
    }
    for (; i < piece.count; ++i) ++bytes[0][p[i]];
    if (piece.run > 0) ++all[RunLength(piece.run).symbol];
  }
  for (std::size_t i = 0; i < 256; ++i) {
    all[i] = bytes[0][i] + bytes[1][i] + bytes[2][i] + bytes[3][i];
  }
  all[end_of_block] = 1;
  return all;
}

/// A prefix code over `size` symbols.
template <std::size_t size>
struct Code {
  std::array<std::uint8_t, size> lengths;
  std::array<std::uint16_t, size> bits;

  Code(const std::array<std::uint32_t, size>& counts, int most) {
    find_lengths(counts, most, lengths);
    find_codes(lengths, bits);
  }
};

/// Lengths of codes are themselves written by a code, of these symbols: a length, …
constexpr std::size_t repeat = 16;      // … 3 to 6 times the length before
constexpr std::size_t few_zeros = 17;   // … 3 to 10 zeros
constexpr std::size_t many_zeros = 18;  // … 11 to 138
constexpr std::size_t length_symbols = 19;
struct LengthSymbol {
  std::uint8_t symbol;
  std::uint8_t extra;
};
constexpr std::uint32_t extra_bits_of(std::size_t symbol) {
  return symbol == repeat ? 2 : symbol == few_zeros ? 3 : symbol == many_zeros ? 7 : 0;
}

std::vector<LengthSymbol> packed(std::span<const std::uint8_t> lengths) {
  std::vector<LengthSymbol> out;
  const auto put = [&](std::size_t symbol, std::size_t extra) {
    out.push_back({static_cast<std::uint8_t>(symbol), static_cast<std::uint8_t>(extra)});
  };
  for (std::size_t i = 0; i < lengths.size();) {
    const std::uint8_t length = lengths[i];
    std::size_t n = 1;
    while (i + n < lengths.size() && lengths[i + n] == length) ++n;
    i += n;
    if (length > 0) put(length, 0), --n;
    while (n >= 3) {
      const bool many = length == 0 && n >= 11;
      const std::size_t taken = std::min<std::size_t>(n, length > 0 ? 6 : many ? 138 : 10);
      put(length > 0 ? repeat : many ? many_zeros : few_zeros, taken - (many ? 11 : 3));
      n -= taken;
    }
    for (; n > 0; --n) put(length, 0);
  }
  return out;
}

using ByteCode = Code<symbols>;

void write_header(BitWriter& out, const ByteCode& code, bool last) {
  std::array<std::uint8_t, symbols + 1> lengths;
  std::copy(code.lengths.begin(), code.lengths.end(), lengths.begin());
  lengths.back() = 1;  // the only distance
  const std::vector<LengthSymbol> list = packed(lengths);
  std::array<std::uint32_t, length_symbols> counts{};
  for (const LengthSymbol& s : list) ++counts[s.symbol];
  const Code<length_symbols> list_code(counts, 7);
  static constexpr std::array<std::size_t, length_symbols> order = {
      16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
  std::size_t listed = length_symbols;
  while (listed > 4 && list_code.lengths[order[listed - 1]] == 0) --listed;
  out.put(last ? 1 : 0, 1);
  out.put(2, 2);  // the block brings its codes
  out.put(symbols - 257, 5);
  out.put(0, 5);  // one distance
  out.put(static_cast<std::uint32_t>(listed) - 4, 4);
  out.flush();
  for (std::size_t i = 0; i < listed; ++i) out.put(list_code.lengths[order[i]], 3), out.flush();
  for (const LengthSymbol& s : list) {
    out.put(list_code.bits[s.symbol], list_code.lengths[s.symbol]);
    out.put(s.extra, extra_bits_of(s.symbol));
    out.flush();
  }
}

void write_pieces(BitWriter& to, const ByteCode& code, std::span<const Piece> pieces) {
  std::array<std::uint32_t, 256> table;  // one look at it instead of two
  for (std::size_t i = 0; i < table.size(); ++i) table[i] = code.bits[i] << 8U | code.lengths[i];
  BitWriter out = to;  // a copy, which nobody else can see, stays in registers
  const auto of = [&code](unsigned char byte) { return Bits{code.bits[byte], code.lengths[byte]}; };
  for (const Piece& piece : pieces) {
    const unsigned char* p = piece.bytes;
    std::uint32_t i = 0;
    for (; i + 4 <= piece.count; i += 4) {
      const Bits first = join(of(p[i]), of(p[i + 1]));
      const Bits second = join(of(p[i + 2]), of(p[i + 3]));
      out.put(join(first, second));  // without waiting for those before
      out.flush();
    }
    for (; i < piece.count; ++i) out.put(of(p[i])), out.flush();
    if (piece.run == 0) continue;
    const RunLength run(piece.run);
    out.put(code.bits[run.symbol], code.lengths[run.symbol]);
    out.put(run.extra, run.extra_bits);
    out.put(0, 1);  // the only distance: one byte
    out.flush();
  }
  out.put(code.bits[end_of_block], code.lengths[end_of_block]);
  out.flush();
  to = out;
}

/// Bytes that a block with these codes takes at most; with room for the end of the stream.
std::size_t room_for(const Counts& counts, const ByteCode& code) {
  constexpr std::size_t longest_header = 17 + 3 * length_symbols + (symbols + 1) * 14;  // bits
  std::size_t bits = longest_header;
  for (std::size_t i = 0; i < symbols; ++i) {
    const std::size_t extra = i > end_of_block ? 6 : 0;
    bits += counts[i] * (code.lengths[i] + extra);
  }
  return bits / 8 + 32;
}

}  // namespace

void deflate_runs(std::span<const unsigned char> part, bool last, std::vector<unsigned char>& out) {
  std::vector<Piece> pieces;
  std::size_t size = out.size();
  BitWriter writer;
  for (std::size_t at = 0; at < part.size(); at += block_size) {
    const auto block = part.subspan(at, std::min(block_size, part.size() - at));
    cut(block, at == 0, pieces);
    const Counts counts = count(pieces);
    const ByteCode code(counts, longest_code);
    out.resize(size + room_for(counts, code));
    writer.continue_at(out.data() + size);
    write_header(writer, code, last && at + block_size >= part.size());
    write_pieces(writer, code, pieces);
    size = static_cast<std::size_t>(writer.end() - out.data());
  }
  if (!last) writer.put(0, 3);  // an empty block of bytes as they are: these begin at a whole byte
  writer.align();
  if (!last) writer.put(0x0000, 16), writer.put(0xFFFF, 16), writer.flush();
  out.resize(static_cast<std::size_t>(writer.end() - out.data()));
}

}  // namespace durer::image
