#include "cli/run_setup.h"

#include <fmt/format.h>

#include <cstdlib>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/diagnostic_json.h"
#include "cli/guard.h"
#include "cli/help.h"
#include "cli/limits.h"
#include "cli/scene_file.h"

namespace durer::cli {
namespace {

int print_and_leave(const std::string& text) {
  fmt::print("{}", text);
  return exit_code::ok;
}

void guard_memory(const Settings& settings) {
  SourceMap none;
  Diagnostic d;
  d.code = Code::limit;
  const std::size_t bytes = limits_of(settings).reading.memory;
  d.message = bytes > 0
                  ? fmt::format("more memory is needed than Max_Memory={} allows", bytes >> 20)
                  : "there is no more memory";
  if (bytes > 0) d.help.emplace_back("raise it with `--max-memory <megabytes>`");
  const std::string message =
      settings.json ? diagnostic_json(d, none) : render_diagnostic(d, none, colour_wanted());
  bytes > 0 ? stop_at_memory(bytes, message) : stop_without_memory(message);
}

}  // namespace

RunSetup set_up(const std::vector<std::string>& words) {
  SourceMap sources;  // of INI files; apart from the scene's, whose first file is the scene
  Diagnostics problems(sources);
  RunSetup setup;
  Reader reader(sources, problems, setup.settings);
  reader.default_ini(std::getenv("POVINI"));
  switch (read_command_line(words, reader)) {
    case Request::help: setup.exit = print_and_leave(help_text()); return setup;
    case Request::help_markdown: setup.exit = print_and_leave(help_markdown()); return setup;
    case Request::version: setup.exit = print_and_leave(version_text()); return setup;
    case Request::stdlib_path: setup.exit = print_and_leave(stdlib_folder() + "\n"); return setup;
    case Request::render: break;
  }
  if (const Problem problem = check(setup.settings)) reader.error(*problem, {});
  std::string problem;
  if (problems.has_errors()) {  // files that were named by mistake are not touched
    Settings quiet = setup.settings;
    for (StreamSettings& stream : quiet.streams) stream.file.clear();
    quiet.all_file.clear();
    setup.console = std::make_unique<Console>(quiet, problem);
  } else {
    setup.console = std::make_unique<Console>(setup.settings, problem);
    if (!problem.empty()) reader.error(problem, {});
  }
  setup.console->print(problems);
  if (problems.has_errors()) setup.exit = exit_code::error;
  guard_memory(setup.settings);
  return setup;
}

}  // namespace durer::cli
