#include "cli/guard.h"

#include <sys/resource.h>
#include <unistd.h>

#include <cstring>
#include <new>

#include "cli/commands.h"

namespace durer::cli {
namespace {

/// Made beforehand: there is no memory when it is wanted.
char memory_message[1024] = "";

[[noreturn]] void write_and_exit(const char* text, std::size_t size) {
  // There is nothing to be done if it cannot be written.
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text, size);
  ::_exit(exit_code::error);
}

[[noreturn]] void on_no_memory() { write_and_exit(memory_message, std::strlen(memory_message)); }

}  // namespace

void stop_without_memory(const std::string& message) {
  memory_message[message.copy(memory_message, sizeof memory_message - 1)] = 0;
  std::set_new_handler(on_no_memory);
}

void stop_at_memory(std::size_t bytes, const std::string& message) {
  stop_without_memory(message);
  // Data rather than address space: stacks and arenas that are only reserved do not count, nor do
  // shared libraries.
  const rlimit limit{bytes, bytes};
  ::setrlimit(RLIMIT_DATA, &limit);
}

void stop_now(const std::string& message) { write_and_exit(message.data(), message.size()); }

Deadline::Deadline(double seconds, std::function<void()> expired) {
  if (seconds <= 0) return;
  const auto wait = std::chrono::duration<double>(std::min(seconds, 1e8));
  thread_ = std::thread([this, wait, call = std::move(expired)] {
    std::unique_lock lock(mutex_);
    if (!over_.wait_for(lock, wait, [this] { return done_; })) call();
  });
}

Deadline::~Deadline() {
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  over_.notify_all();
  if (thread_.joinable()) thread_.join();
}

}  // namespace durer::cli
