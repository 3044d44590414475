#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

namespace durer::image {

/// Eight bytes at once, the first one lowest.
[[nodiscard]] inline std::uint64_t load64(const unsigned char* p) {
  std::uint64_t v;
  std::memcpy(&v, p, sizeof v);
  return std::endian::native == std::endian::little ? v : __builtin_bswap64(v);
}
inline void store64(unsigned char* p, std::uint64_t v) {
  if (std::endian::native != std::endian::little) v = __builtin_bswap64(v);
  std::memcpy(p, &v, sizeof v);
}

}  // namespace durer::image
