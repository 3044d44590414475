#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "cli/commands.h"
#include "cli/interrupt.h"

int main(int argc, char** argv) try {
  using namespace durer::cli;
  const std::vector<std::string> words(argv + 1, argv + argc);
  interrupts_end_program();
  if (!words.empty() && words.front() == "parse") {
    return parse_command({words.begin() + 1, words.end()});
  }
  if (!words.empty() && words.front() == "check") {
    return check_command({words.begin() + 1, words.end()});
  }
  return render_command(words);
} catch (const std::exception& e) {  // no memory, most likely
  fmt::print(stderr, "error: {}\n", e.what());
  return durer::cli::exit_code::error;
}
