#include "image/prefix_code.h"

#include <algorithm>
#include <array>

namespace durer::image {
namespace {

constexpr std::size_t most_symbols = 320;
constexpr std::size_t most_bits = 15;

/// How many codes there are of each length.
using LengthCounts = std::array<std::uint32_t, most_bits + 1>;

struct Node {
  std::uint32_t count;
  std::uint16_t symbol;  // of a leaf
  std::uint16_t parent;
};
using Tree = std::array<Node, 2 * most_symbols>;

/// Joins `leaves` nodes, the rarest first, until there is one; returns its number. Joints come about
/// in order of their counts, so that the rarest two always stand first in either row.
std::size_t join(Tree& tree, std::size_t leaves) {
  std::size_t leaf = 0;
  std::size_t joint = leaves;
  std::size_t end = leaves;
  const auto rarest = [&] {
    const bool take_leaf = leaf < leaves && (joint == end || tree[leaf].count <= tree[joint].count);
    return take_leaf ? leaf++ : joint++;
  };
  while (end < 2 * leaves - 1) {
    const std::size_t a = rarest();
    const std::size_t b = rarest();
    tree[a].parent = tree[b].parent = static_cast<std::uint16_t>(end);
    tree[end++].count = tree[a].count + tree[b].count;
  }
  return end - 1;
}

/// How deep the leaves are; what is too deep counts as the deepest allowed.
LengthCounts depths(const Tree& tree, std::size_t leaves, std::size_t root, std::size_t most) {
  std::array<std::uint16_t, 2 * most_symbols> depth;
  depth[root] = 0;
  LengthCounts found{};
  for (std::size_t i = root; i-- > 0;) {  // parents stand behind their children
    depth[i] = static_cast<std::uint16_t>(depth[tree[i].parent] + 1);
    if (i < leaves) ++found[std::min<std::size_t>(depth[i], most)];
  }
  return found;
}

/// Makes room for codes that were cut to `most` bits: a shorter code gives way to two that are longer
/// by one, one of which is for a code of the greatest length.
void make_room(LengthCounts& lengths, std::size_t most) {
  std::uint32_t taken = 0;  // in codes of the greatest length
  for (std::size_t n = 1; n <= most; ++n) taken += lengths[n] << (most - n);
  for (; taken > 1U << most; --taken) {
    std::size_t n = most - 1;
    while (lengths[n] == 0) --n;
    --lengths[n];
    lengths[n + 1] += 2;
    --lengths[most];
  }
}

}  // namespace

void find_lengths(std::span<const std::uint32_t> counts, int most,
                  std::span<std::uint8_t> lengths) {
  Tree tree;
  std::size_t leaves = 0;
  std::fill(lengths.begin(), lengths.end(), std::uint8_t{0});
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] > 0) tree[leaves++] = {counts[i], static_cast<std::uint16_t>(i), 0};
  }
  if (leaves == 1) {
    lengths[tree[0].symbol] = 1;
    return;
  }
  std::sort(tree.begin(), tree.begin() + static_cast<std::ptrdiff_t>(leaves),
            [](const Node& a, const Node& b) {
              return a.count != b.count ? a.count < b.count : a.symbol < b.symbol;
            });
  const auto longest = static_cast<std::size_t>(most);
  LengthCounts left = depths(tree, leaves, join(tree, leaves), longest);
  make_room(left, longest);
  std::size_t n = longest;
  for (std::size_t i = 0; i < leaves; ++i) {  // the rarest get the longest
    while (left[n] == 0) --n;
    --left[n];
    lengths[tree[i].symbol] = static_cast<std::uint8_t>(n);
  }
}

void find_codes(std::span<const std::uint8_t> lengths, std::span<std::uint16_t> codes) {
  LengthCounts next{};
  for (const std::uint8_t n : lengths) ++next[n];
  next[0] = 0;
  std::uint32_t first = 0;
  for (std::uint32_t& n : next) {
    const std::uint32_t count = n;
    n = first;
    first = (first + count) << 1;
  }
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    std::uint32_t code = next[lengths[i]]++;
    std::uint32_t reversed = 0;
    for (int bit = 0; bit < lengths[i]; ++bit, code >>= 1) reversed = reversed << 1 | (code & 1);
    codes[i] = static_cast<std::uint16_t>(reversed);
  }
}

}  // namespace durer::image
