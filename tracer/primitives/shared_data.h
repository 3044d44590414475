// What is made once and shared by all objects that show it: a forest of one blob keeps its
// components once.
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

/// Finds data by the address of what they were made from; they live as long as anybody holds them.
/// `Data` must hold its source, so that no other can take that address while the data live.
template <typename Source, typename Data>
class SharedData {
 public:
  template <typename Make>
  std::shared_ptr<const Data> get(const Source* source, Make make) {
    const std::lock_guard lock(mutex_);
    std::weak_ptr<const Data>& entry = known_[source];
    if (auto data = entry.lock()) return data;
    std::shared_ptr<const Data> data = make();
    entry = data;
    return data;
  }

 private:
  std::mutex mutex_;
  std::unordered_map<const Source*, std::weak_ptr<const Data>> known_;
};

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
