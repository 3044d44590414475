// The program's own `new` and `delete` (cli/blocks.cpp), which this test program is linked with.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <thread>
#include <vector>

#include "tests/support/catch.h"

namespace {

struct Block {
  unsigned char* bytes;
  std::size_t size;
  unsigned char mark;
};

Block make(std::size_t size, unsigned char mark) {
  auto* bytes = static_cast<unsigned char*>(::operator new(size));
  std::memset(bytes, mark, size);
  return {bytes, size, mark};
}

bool is_whole(const Block& b) {
  return std::all_of(b.bytes, b.bytes + b.size, [&](unsigned char c) { return c == b.mark; });
}

std::size_t next_size(std::uint32_t& state) {
  state = state * 1664525U + 1013904223U;
  return std::size_t{1} << (state >> 28U) | ((state >> 8U) & 63U);  // up to 32 KiB and a bit
}

/// Takes and gives back blocks of many sizes; true if none ever overlapped another.
bool churn(std::uint32_t seed) {
  std::vector<Block> held;
  std::uint32_t state = seed;
  bool whole = true;
  for (int i = 0; i < 4000; ++i) {
    held.push_back(make(next_size(state), static_cast<unsigned char>(i)));
    if (held.size() < 200) continue;
    std::swap(held[state % held.size()], held.back());
    whole = whole && is_whole(held.back());
    ::operator delete(held.back().bytes);
    held.pop_back();
  }
  for (const Block& b : held) {
    whole = whole && is_whole(b);
    ::operator delete(b.bytes, b.size);
  }
  return whole;
}

}  // namespace

TEST_CASE("blocks: all sizes are aligned and apart", "[cli][blocks]") {
  std::vector<Block> held;
  for (std::size_t size = 0; size < 70000; size += size < 700 ? 1 : 977) {
    held.push_back(make(size, static_cast<unsigned char>(size)));
    CHECK(reinterpret_cast<std::uintptr_t>(held.back().bytes) % alignof(std::max_align_t) == 0);
  }
  CHECK(std::all_of(held.begin(), held.end(), is_whole));
  for (const Block& b : held) ::operator delete(b.bytes);
}

TEST_CASE("blocks: what is given back is used again", "[cli][blocks]") {
  void* const first = ::operator new(48);
  ::operator delete(first, 48);
  void* const second = ::operator new(40);  // of the same class
  CHECK(first == second);
  ::operator delete(second);
}

TEST_CASE("blocks: threads may give back each other's", "[cli][blocks]") {
  CHECK(churn(1));
  std::vector<std::unique_ptr<std::vector<int>>> made(64);
  std::thread([&] {
    for (auto& v : made) v = std::make_unique<std::vector<int>>(1000, 7);
  }).join();
  for (const auto& v : made) CHECK(v->back() == 7);
  made.clear();
  bool whole[4] = {};
  std::vector<std::thread> threads;
  for (std::uint32_t i = 0; i < 4; ++i) {
    threads.emplace_back([&whole, i] { whole[i] = churn(i + 2); });
  }
  for (std::thread& t : threads) t.join();
  for (const bool w : whole) CHECK(w);
}
