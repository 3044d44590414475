#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/interrupt.h"

int main(int argc, char** argv) try {
  using namespace durer::cli;
  std::vector<std::string> words(argv + 1, argv + argc);
  interrupts_end_program();
  const std::size_t at = first_bare_word(words);
  const std::string command = at < words.size() ? words[at] : "";
  if (command != "parse" && command != "check" && command != "doc") return render_command(words);
  words.erase(words.begin() + static_cast<std::ptrdiff_t>(at));
  if (command == "doc") return doc_command(words);
  return command == "parse" ? parse_command(words) : check_command(words);
} catch (const std::exception& e) {  // no memory, most likely
  fmt::print(stderr, "error: {}\n", e.what());
  return durer::cli::exit_code::error;
}
