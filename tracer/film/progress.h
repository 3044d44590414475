#pragma once

#include <atomic>
#include <chrono>
#include <mutex>

#include "tracer/render.h"

namespace durer::tracer {

/// Adds up what the threads have done and tells the caller now and then.
class ProgressMeter {
 public:
  ProgressMeter(std::uint64_t pixels_total, const std::function<void(const Progress&)>& report,
                const std::atomic<bool>* cancel);

  /// Called by a thread after each block.
  void add(std::uint64_t pixels, std::uint64_t rays);

  [[nodiscard]] bool cancelled() const { return cancel_ != nullptr && cancel_->load(); }
  [[nodiscard]] Progress now() const;

 private:
  using Clock = std::chrono::steady_clock;

  std::uint64_t total_;
  const std::function<void(const Progress&)>* report_;
  const std::atomic<bool>* cancel_;
  Clock::time_point start_ = Clock::now();
  std::atomic<std::uint64_t> pixels_{0};
  std::atomic<std::uint64_t> rays_{0};
  std::mutex reporting_;
  Clock::time_point next_report_ = start_;
};

}  // namespace durer::tracer
