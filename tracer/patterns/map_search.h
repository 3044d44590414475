// Which entries of a map a value lies between (textures §11.1).
#pragma once

#include <span>

namespace durer::tracer {

/// The two neighbours of a value; the same one twice where there is nothing to mix.
template <typename Entry>
struct Neighbours {
  const Entry* lower = nullptr;
  const Entry* upper = nullptr;
  double t = 0;  // share of the upper one

  [[nodiscard]] bool single() const { return lower == upper; }
};

/// `entries` is not empty. They are searched as written, never sorted; of two entries with one key
/// the first is found for exactly that value. `Entry` has a `key`.
template <typename Entry>
[[nodiscard]] Neighbours<Entry> find_neighbours(std::span<const Entry> entries, double value) {
  const Entry* const last = &entries.back();
  if (!(value < last->key)) return {last, last, 0};
  const Entry* lower = entries.data();
  const Entry* upper = lower;
  while (value > upper->key) lower = upper++;
  if (value == upper->key || lower == upper) return {upper, upper, 0};
  const double width = static_cast<double>(upper->key) - static_cast<double>(lower->key);
  return {lower, upper, (value - lower->key) / width};
}

}  // namespace durer::tracer
