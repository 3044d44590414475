#include "interpreter/deep_stack.h"

#include <pthread.h>

#include <cstddef>
#include <cstdint>
#include <exception>

namespace durer::interpreter {
namespace {

// Address space, not memory: pages are taken when they are used.
constexpr std::size_t stack_size = std::size_t{256} << 20U;
// What one step may need before it asks again: expressions are up to 5000 operators high.
constexpr std::size_t reserve = std::size_t{4} << 20U;

/// The lowest address that this thread should use; 0 if unknown.
std::uintptr_t find_floor() {
  pthread_attr_t attributes;
  if (pthread_getattr_np(pthread_self(), &attributes) != 0) return 0;
  void* lowest = nullptr;
  std::size_t size = 0;
  const bool known = pthread_attr_getstack(&attributes, &lowest, &size) == 0;
  pthread_attr_destroy(&attributes);
  if (!known) return 0;
  return reinterpret_cast<std::uintptr_t>(lowest) + (size > 2 * reserve ? reserve : size / 2);
}

struct Job {
  const std::function<void()>* work = nullptr;
  std::exception_ptr failure;
};

void* run(void* argument) {
  Job& job = *static_cast<Job*>(argument);
  try {
    (*job.work)();
  } catch (...) {
    job.failure = std::current_exception();
  }
  return nullptr;
}

}  // namespace

void on_deep_stack(const std::function<void()>& work) {
  Job job{&work, {}};
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, stack_size);
  pthread_t thread{};
  const bool started = pthread_create(&thread, &attributes, run, &job) == 0;
  pthread_attr_destroy(&attributes);
  if (!started) return work();  // no room for it: the stack that is there must do
  pthread_join(thread, nullptr);
  if (job.failure) std::rethrow_exception(job.failure);
}

bool stack_is_low() {
  static thread_local const std::uintptr_t floor = find_floor();
  char here = 0;
  return reinterpret_cast<std::uintptr_t>(&here) < floor;
}

}  // namespace durer::interpreter
