// Hard stops: for what slips through the limits that the interpreter watches itself.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace durer::cli {

/// From here on a request for memory beyond `bytes` in all ends the program with exit code 1 and
/// `message` on standard error. Files being written stay as they were before.
void stop_at_memory(std::size_t bytes, const std::string& message);

/// Without a limit too, running out of memory ends with `message` rather than a crash.
void stop_without_memory(const std::string& message);

/// Calls `expired` once, from a thread of its own, `seconds` after it was made, unless it has been
/// destroyed by then. 0 seconds: never.
class Deadline {
 public:
  Deadline(double seconds, std::function<void()> expired);
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;
  ~Deadline();

 private:
  std::mutex mutex_;
  std::condition_variable over_;
  bool done_ = false;
  std::thread thread_;
};

/// Writes `message` to standard error and ends the program with exit code 1, without cleaning up.
[[noreturn]] void stop_now(const std::string& message);

}  // namespace durer::cli
