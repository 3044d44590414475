#include "cli/interrupt.h"

#include <unistd.h>

#include <csignal>

#include "cli/commands.h"

namespace durer::cli {
namespace {

std::atomic<bool> interrupted = false;
std::atomic<bool> flag_only = false;
static_assert(std::atomic<bool>::is_always_lock_free, "used in a signal handler");

extern "C" void on_interrupt(int /*signal*/) {
  if (!flag_only) ::_exit(exit_code::interrupted);
  interrupted = true;
}

}  // namespace

void handle_interrupts() {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  ::sigemptyset(&action.sa_mask);
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
}

const std::atomic<bool>& interrupts_set_flag() {
  flag_only = true;
  return interrupted;
}

}  // namespace durer::cli
