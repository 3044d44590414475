#include "cli/interrupt.h"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>

#include "cli/commands.h"

namespace durer::cli {
namespace {

std::atomic<bool> interrupted = false;
std::atomic<bool> flag_only = false;
static_assert(std::atomic<bool>::is_always_lock_free, "used in a signal handler");
/// Copied when set, because a handler must not allocate.
char abort_command[4096] = "";

void run_abort_command() {
  if (abort_command[0] == 0) return;
  const pid_t child = ::fork();
  if (child == 0) {
    ::execl("/bin/sh", "sh", "-c", abort_command, static_cast<char*>(nullptr));
    ::_exit(127);
  }
  int status = 0;
  if (child > 0) ::waitpid(child, &status, 0);
}

extern "C" void on_interrupt(int /*signal*/) {
  if (!flag_only) {
    run_abort_command();
    ::_exit(exit_code::interrupted);
  }
  interrupted = true;
}

void handle_signals() {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  ::sigemptyset(&action.sa_mask);
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

void interrupts_end_program(const std::string& command) {
  flag_only = true;  // while the text is replaced
  const std::size_t size = command.copy(abort_command, sizeof abort_command - 1);
  abort_command[size] = 0;
  flag_only = false;
  handle_signals();
}

std::atomic<bool>& interrupts_set_flag() {
  flag_only = true;
  return interrupted;
}

}  // namespace durer::cli
