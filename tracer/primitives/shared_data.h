// What is made once for a part of the scene and shared by all objects that show it.
#pragma once

#include <memory>
#include <mutex>
#include <unordered_map>

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

}  // namespace durer::tracer
