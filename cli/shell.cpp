#include "cli/shell.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <cstdlib>

namespace durer::cli {
namespace {

std::string value_of(char letter, const ShellNames& n) {
  switch (letter) {
    case 'o': return n.output;
    case 's': return n.scene;
    case 'n': return std::to_string(n.frame);
    case 'k': return fmt::format("{:g}", n.clock);
    case 'w': return std::to_string(n.width);
    case 'h': return std::to_string(n.height);
    case '%': return "%";
    default: return std::string("%") + letter;
  }
}

}  // namespace

std::string substitute(std::string_view command, const ShellNames& names) {
  std::string out;
  for (std::size_t i = 0; i < command.size(); ++i) {
    if (command[i] == '%' && i + 1 < command.size()) {
      out += value_of(command[++i], names);
    } else {
      out += command[i];
    }
  }
  return out;
}

Action action_after(const ShellHook& hook, int code) {
  return (code == 0) == hook.on_success ? hook.action : Action::ignore;
}

int run_shell(const std::string& command) {
  const int status = std::system(command.c_str());
  return status != -1 && WIFEXITED(status) ? WEXITSTATUS(status) : 127;
}

}  // namespace durer::cli
