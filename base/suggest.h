#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace durer {

/// The candidate nearest to `word` within edit distance 2 (and less than half of the word's
/// length); none if nothing is that near.
[[nodiscard]] std::optional<std::string_view> closest(std::string_view word,
                                                      std::span<const std::string_view> candidates);

}  // namespace durer
