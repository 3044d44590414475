#include "interpreter/deep_stack.h"

#include <sys/mman.h>
#include <ucontext.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <initializer_list>
#include <utility>

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/common_interface_defs.h>
#endif

namespace durer::interpreter {
namespace {

constexpr std::size_t mebibyte = std::size_t{1} << 20U;

// What one step may need before it asks again: expressions are up to 5000 operators high.
constexpr std::size_t reserve = 4 * mebibyte;
constexpr std::size_t guard = 65536;

#ifdef __SANITIZE_ADDRESS__
// The sanitizer forgets nothing of frames left by exceptions on stacks beyond 64 MiB.
constexpr std::size_t largest = 63 * mebibyte;
#else
constexpr std::size_t largest = 256 * mebibyte;
#endif

thread_local std::uintptr_t floor_of_stack = 0;

/// Memory for a stack, with a guard below it. Pages are taken when they are used.
class Stack {
 public:
  Stack() {
    // Under a tight limit on memory a smaller one must do.
    for (const std::size_t size : {largest, largest / 4, largest / 16}) {
      void* at = mmap(nullptr, size, PROT_READ | PROT_WRITE,
                      MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_STACK, -1, 0);
      if (at == MAP_FAILED) continue;
      base_ = static_cast<char*>(at);
      size_ = size;
      (void)mprotect(base_, guard, PROT_NONE);
      return;
    }
  }
  Stack(const Stack&) = delete;
  Stack& operator=(const Stack&) = delete;
  ~Stack() {
    if (base_ != nullptr) munmap(base_, size_);
  }
  [[nodiscard]] char* base() const { return base_; }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  char* base_ = nullptr;
  std::size_t size_ = 0;
};

struct Job {
  const std::function<void()>* work = nullptr;
  std::exception_ptr failure;
  ucontext_t caller{};
  ucontext_t callee{};
  const void* caller_stack = nullptr;  // for the address sanitizer
  std::size_t caller_size = 0;
};

/// Where the new stack begins; contexts take only ints along.
void enter(unsigned high, unsigned low) {
  Job& job = *reinterpret_cast<Job*>(std::uintptr_t{high} << 32U | low);
#ifdef __SANITIZE_ADDRESS__
  __sanitizer_finish_switch_fiber(nullptr, &job.caller_stack, &job.caller_size);
#endif
  try {
    (*job.work)();
  } catch (...) {
    job.failure = std::current_exception();
  }
#ifdef __SANITIZE_ADDRESS__
  __sanitizer_start_switch_fiber(nullptr, job.caller_stack, job.caller_size);
#endif
}

}  // namespace

void on_deep_stack(const std::function<void()>& work) {
  const Stack stack;
  Job job;
  job.work = &work;
  if (stack.base() == nullptr || getcontext(&job.callee) != 0) return work();
  job.callee.uc_stack.ss_sp = stack.base();
  job.callee.uc_stack.ss_size = stack.size();
  job.callee.uc_link = &job.caller;
  const auto address = reinterpret_cast<std::uintptr_t>(&job);
  makecontext(&job.callee, reinterpret_cast<void (*)()>(enter), 2,
              static_cast<unsigned>(address >> 32U), static_cast<unsigned>(address));
  const std::uintptr_t outer =
      std::exchange(floor_of_stack, reinterpret_cast<std::uintptr_t>(stack.base()) + reserve);
#ifdef __SANITIZE_ADDRESS__
  void* fake = nullptr;
  __sanitizer_start_switch_fiber(&fake, stack.base(), stack.size());
#endif
  swapcontext(&job.caller, &job.callee);
#ifdef __SANITIZE_ADDRESS__
  __sanitizer_finish_switch_fiber(fake, nullptr, nullptr);
#endif
  floor_of_stack = outer;
  if (job.failure) std::rethrow_exception(job.failure);
}

bool stack_is_low() {
  const char here = 0;
  return reinterpret_cast<std::uintptr_t>(&here) < floor_of_stack;
}

}  // namespace durer::interpreter
