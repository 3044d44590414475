// From the command line to the pictures.
#include "cli/commands.h"
#include "cli/create_ini.h"
#include "cli/frame.h"
#include "cli/frame_scene.h"
#include "cli/interrupt.h"
#include "cli/limits.h"
#include "cli/run_setup.h"

namespace durer::cli {
namespace {

ShellNames shell_names(const Settings& settings, const FrameTask& task) {
  ShellNames names;
  names.output = output_of(settings, task).path;
  names.scene = scene_stem(settings);
  names.frame = task.number;
  names.clock = task.clock;
  names.width = settings.width;
  names.height = settings.height;
  return names;
}

/// A signal while a scene is read, or before, ends the program at once.
void arm_interrupts(const Settings& settings, const FrameTask& task) {
  const ShellHook& hook = settings.hooks[static_cast<std::size_t>(Moment::user_abort)];
  interrupts_end_program(substitute(hook.command, shell_names(settings, task)));
}

int dump_scene(const Settings& settings, const SceneText& text, Console& console) {
  const auto frame = read_frame(settings, text, frame_task(settings, 0), console);
  console.print(frame->diagnostics);
  if (!frame->scene) return exit_code::error;
  return dump(*frame, settings) ? exit_code::ok : exit_code::error;
}

int render_all(const Settings& settings, const SceneText& text, Console& console) {
  SequenceActions actions;
  actions.names = [&](const FrameTask& task) { return shell_names(settings, task); };
  actions.shell = run_shell;
  actions.render = [&](const FrameTask& task) {
    arm_interrupts(settings, task);
    return render_frame(settings, text, console, task);
  };
  return run_sequence(settings, actions);
}

}  // namespace

int render_command(const std::vector<std::string>& words) {
  RunSetup setup = set_up(words);
  if (setup.exit) return *setup.exit;
  Settings& settings = setup.settings;
  Console& console = *setup.console;
  if (settings.input.empty()) {
    return console.fail(Code::option, "there is no scene to render",
                        "write `durer scene.scene`; `durer --help` lists the options");
  }
  if (const Problem problem = check_extent(settings)) return console.fail(Code::limit, *problem);
  if (const auto error = create_ini(settings)) return console.fail(Code::file_not_written, *error);

  SourceMap none;
  Diagnostics diagnostics(none);
  const auto text = read_scene(settings, diagnostics);
  console.print(diagnostics);
  if (!text) return exit_code::error;
  if (settings.dump_scene != DumpFormat::none) return dump_scene(settings, *text, console);
  return render_all(settings, *text, console);
}

}  // namespace durer::cli
