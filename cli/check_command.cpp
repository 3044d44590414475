// `durer check`: scenes are read and thrown away.
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/convert.h"
#include "cli/frame_scene.h"
#include "cli/limits.h"
#include "cli/progress.h"
#include "cli/run_setup.h"

namespace durer::cli {
namespace {

std::string counted(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// Without those that the interpreter brings along.
std::size_t files_read(const SourceMap& sources) {
  std::size_t count = 0;
  for (FileId file = 0; file < sources.size(); ++file) count += !sources.path(file).starts_with('<');
  return count;
}

std::string summary(const FrameScene& frame, const Settings& settings) {
  const scene::Scene& s = *frame.scene;
  return fmt::format("{}: {}, {}, {}, {} read, {}; {}\n", frame.sources.path(0),
                     counted(s.roots.size(), "object"), counted(s.lights.size(), "light"),
                     counted(s.textures.size(), "texture"), counted(files_read(frame.sources), "file"),
                     time_text(frame.seconds), assumptions(settings, s.settings, frame.assumed));
}

/// The first frame of an animation stands for all.
bool is_good(Settings settings, Console& console) {
  SourceMap none;
  Diagnostics diagnostics(none);
  const auto text = read_scene(settings, diagnostics);
  console.print(diagnostics);
  if (!text) return false;
  auto frame = read_frame(settings, *text, frame_task(settings, 0), console);
  console.print(frame->diagnostics);
  if (!frame->scene) return false;
  if (settings.dump_scene != DumpFormat::none && !dump(*frame, settings)) return false;
  console.print(Stream::statistic, summary(*frame, settings));
  leave_behind(std::move(frame));
  return true;
}

}  // namespace

int check_command(const std::vector<std::string>& words) {
  RunSetup setup = set_up(words);
  if (setup.exit) return *setup.exit;
  if (setup.settings.inputs.empty()) {
    return setup.console->fail(Code::option, "there is no scene to check",
                               "write `durer check scene.scene`");
  }
  bool good = true;
  for (const std::string& input : setup.settings.inputs) {
    Settings one = setup.settings;
    one.input = input;
    good = is_good(std::move(one), *setup.console) && good;
  }
  return good ? exit_code::ok : exit_code::error;
}

}  // namespace durer::cli
