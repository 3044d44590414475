// Eight-bit codes without the curve.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace durer::image {

/// For each code, the smallest number that gets it. What is looked up is what would be computed.
class CodeTable {
 public:
  /// `code_of`: from a number of 0…1 to its code; never falls.
  template <typename CodeOf>
  explicit CodeTable(const CodeOf& code_of) {
    least_[0] = -std::numeric_limits<float>::infinity();
    least_[256] = std::numeric_limits<float>::quiet_NaN();  // there is no such number
    for (unsigned code = 1; code < 256; ++code) {
      std::uint32_t lo = 0;
      std::uint32_t hi = one;
      while (lo < hi) {  // positive numbers are ordered as their bits are
        const std::uint32_t middle = (lo + hi) / 2;
        if (code_of(std::bit_cast<float>(middle)) >= code) hi = middle;
        else lo = middle + 1;
      }
      least_[code] = std::bit_cast<float>(lo);
    }
    for (std::uint32_t i = 0, code = 0; i < first_.size(); ++i) {
      const std::uint32_t begin = i == 0 ? 0 : smallest + (i << shift);
      const std::uint32_t end = smallest + ((i + 1) << shift);
      while (code < 255 && least_[code + 1] <= std::bit_cast<float>(begin)) ++code;
      first_[i] = static_cast<std::uint8_t>(code);
      if (code < 254 && least_[code + 2] < std::bit_cast<float>(end)) exact_ = false;
    }
  }

  /// False for a curve that is too steep for it: then there are wrong codes.
  [[nodiscard]] bool exact() const { return exact_; }

  /// Below 0 and NaN: 0. Above 1: 255.
  [[nodiscard]] unsigned code_of(float v) const {
    float near = v > least_number_ ? v : least_number_;
    near = near < greatest_number_ ? near : greatest_number_;
    const unsigned code = first_[(std::bit_cast<std::uint32_t>(near) - smallest) >> shift];
    return code + (v >= least_[code + 1] ? 1 : 0);
  }

 private:
  // Numbers are sorted by their leading bits, 1024 sorts for each power of two. So fine that no curve
  // but the oddest has two steps in one.
  static constexpr std::uint32_t one = std::bit_cast<std::uint32_t>(1.0F);
  static constexpr std::uint32_t smallest = std::bit_cast<std::uint32_t>(0x1p-20F);
  static constexpr int shift = 13;

  // Not constants, for which the compiler would make branches.
  float least_number_ = std::bit_cast<float>(smallest);
  float greatest_number_ = 1;
  std::array<float, 257> least_{};
  std::array<std::uint8_t, ((one - smallest) >> shift) + 1> first_{};  // code where the sort begins
  bool exact_ = true;
};

}  // namespace durer::image
