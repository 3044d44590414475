// Limits for scenes that nobody vouches for, and for those with a mistake: turns, time, memory.
#include <chrono>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

#include "interpreter/deep_stack.h"
#include "interpreter/interpreter.h"

namespace durer::interpreter {
namespace {

constexpr std::uint64_t turns_between_checks = 4096;

/// Bytes of memory that the process holds now; 0 if the system does not tell.
std::size_t memory_held() {
  std::FILE* f = std::fopen("/proc/self/statm", "r");
  if (f == nullptr) return 0;
  unsigned long total = 0;
  unsigned long resident = 0;
  const int read = std::fscanf(f, "%lu %lu", &total, &resident);  // NOLINT: fixed format
  std::fclose(f);
  return read == 2 ? resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) : 0;
}

}  // namespace

/// Where reading recurses: too deep is an error, not the end of the program.
void Interpreter::check_stack(Span span) {
  if (!stack_is_low()) return;
  fail(Code::limit, span, "this is nested too deeply", "is a macro calling itself without end?");
}

/// Objects in objects, by way of declared names too: whoever walks them recurses.
void Interpreter::check_depth(const scene::Object& object, std::uint32_t depth) {
  constexpr std::uint32_t most = 5000;
  if (depth <= most) return;
  fail(Code::limit, scene_.origins[object.origin].span,
       fmt::format("objects are nested more than {} deep", most));
}

/// Looks at the clock and the memory once in a while, at the turns always when they are limited.
void Interpreter::check_limits(Span span) {
  const Limits& limits = options_.limits;
  next_check_ = turns_ + turns_between_checks;
  if (limits.loop_turns > 0) {
    if (turns_ > limits.loop_turns) {
      fail(Code::limit, span,
           fmt::format("the loops and macro calls of this scene exceed {} turns",
                       limits.loop_turns),
           "does a loop run without end? --max-loop-turns raises the limit");
    }
    next_check_ = std::min(next_check_, limits.loop_turns + 1);
  }
  if (limits.seconds > 0) {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - started_;
    if (spent.count() > limits.seconds) {
      fail(Code::limit, span,
           fmt::format("reading this scene takes more than {:g} seconds", limits.seconds),
           "does a loop run without end? --max-seconds raises the limit");
    }
  }
  if (limits.memory > 0 && memory_held() > limits.memory) {
    fail(Code::limit, span,
         fmt::format("this scene needs more than {} MiB of memory", limits.memory >> 20U),
         "--max-memory raises the limit");
  }
}

}  // namespace durer::interpreter
