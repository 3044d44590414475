// Data that equal objects share: a forest of one blob keeps its components once.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <unordered_map>
#include <vector>

namespace durer::tracer {

/// What make(args) returns; made once for the same numbers, as long as anybody holds it. `Data`
/// tells which kind of data this is: two makers must not make the same type.
template <typename Data, typename Make>
std::shared_ptr<const Data> shared_data(std::span<const double> args, Make&& make) {
  struct Known {
    std::vector<double> args;
    std::weak_ptr<const Data> data;
  };
  static std::mutex mutex;
  static std::unordered_multimap<std::uint64_t, Known> all;
  std::uint64_t hash = args.size();
  for (const double x : args) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15U;
    hash ^= hash >> 29U;
  }
  const std::lock_guard lock(mutex);
  auto [at, end] = all.equal_range(hash);
  while (at != end) {
    auto data = at->second.data.lock();
    if (data && std::ranges::equal(at->second.args, args)) return data;
    at = data ? std::next(at) : all.erase(at);
  }
  std::shared_ptr<const Data> made = make(args);
  all.emplace(hash, Known{{args.begin(), args.end()}, made});
  return made;
}

}  // namespace durer::tracer
