#pragma once

#include <cstdint>

#include "image/bytes.h"

namespace durer::image {

/// Up to 48 bits; the one to be written first is the lowest.
struct Bits {
  std::uint64_t bits = 0;
  std::uint32_t count = 0;
};
[[nodiscard]] inline Bits join(Bits a, Bits b) {
  return {a.bits | b.bits << a.count, a.count + b.count};
}

/// Bits → bytes, the lowest bit of a byte first. There must be room for all, and for eight bytes
/// more.
class BitWriter {
 public:
  /// What is still waiting goes there, too.
  void continue_at(unsigned char* out) { out_ = out; }

  /// At most 48 bits may be put between two calls of `flush`.
  void put(Bits b) {
    waiting_ |= b.bits << fill_;
    fill_ += b.count;
  }
  void put(std::uint64_t bits, std::uint32_t count) { put({bits, count}); }
  void flush() {
    store64(out_, waiting_);
    out_ += fill_ / 8;
    waiting_ >>= fill_ & ~7U;
    fill_ &= 7;
  }
  /// Goes on at the next whole byte.
  void align() {
    fill_ = (fill_ + 7) & ~7U;
    flush();
  }
  [[nodiscard]] unsigned char* end() const { return out_; }

 private:
  unsigned char* out_ = nullptr;
  std::uint64_t waiting_ = 0;
  std::uint32_t fill_ = 0;
};

}  // namespace durer::image
