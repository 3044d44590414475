#include "cli/sequence.h"

#include "cli/commands.h"

namespace durer::cli {
namespace {

/// How it goes on after a command: to the next step, past some steps, or to the end.
enum class Flow : std::uint8_t { on, skip, skip_all, end };

class Sequence {
 public:
  Sequence(const Settings& settings, const SequenceActions& actions)
      : settings_(settings), actions_(actions) {}

  int run() {
    FrameTask task = frame_task(settings_, 0);
    // Outside the frames there is no number: %o is the name without one (language §9.2).
    FrameTask whole = task;
    whole.animation = std::nullopt;
    const Flow before = hook(Moment::pre_scene, whole);
    if (before == Flow::end || before == Flow::skip_all) return finish(whole);
    const int count = before == Flow::skip ? 0 : task.count;
    for (int i = 0; i < count; ++i) {
      task = frame_task(settings_, i);
      const Flow flow = frame(task);
      if (flow == Flow::end) return finish(task);
      if (flow == Flow::skip_all) break;
    }
    (void)hook(Moment::post_scene, whole);
    return finish(whole);
  }

 private:
  Flow frame(const FrameTask& task) {
    const Flow before = hook(Moment::pre_frame, task);
    if (before != Flow::on) return before == Flow::skip ? Flow::on : before;
    code_ = actions_.render(task);
    if (code_ != exit_code::ok) return Flow::end;
    return hook(Moment::post_frame, task);
  }

  Flow hook(Moment moment, const FrameTask& task) {
    const ShellHook& hook = settings_.hooks[static_cast<std::size_t>(moment)];
    if (hook.command.empty()) return Flow::on;
    const int code = actions_.shell(substitute(hook.command, actions_.names(task)));
    switch (action_after(hook, code)) {
      case Action::ignore: return Flow::on;
      case Action::skip: return Flow::skip;
      case Action::skip_all: return Flow::skip_all;
      case Action::quit:
        code_ = exit_code::ok;
        quit_ = true;
        return Flow::end;
      case Action::user_abort: code_ = exit_code::interrupted; return Flow::end;
      case Action::fatal: code_ = exit_code::error; return Flow::end;
    }
    return Flow::on;
  }

  /// The commands after an error or an interruption; they may change the exit code.
  int finish(const FrameTask& task) {
    if (quit_ || code_ == exit_code::ok) return code_;
    (void)hook(code_ == exit_code::error ? Moment::fatal_error : Moment::user_abort, task);
    return code_;
  }

  const Settings& settings_;
  const SequenceActions& actions_;
  int code_ = exit_code::ok;
  bool quit_ = false;
};

}  // namespace

FrameTask frame_task(const Settings& settings, int index) {
  FrameTask task;
  task.index = index;
  task.animation = animation_of(settings);
  if (!task.animation) {
    task.clock = static_cast<double>(static_cast<float>(settings.clock));
    task.clock_on = settings.clock_given;
    return task;
  }
  task.count = task.animation->count();
  task.number = task.animation->from + index * task.animation->step;
  task.clock = task.animation->clock(task.number);
  task.clock_on = true;
  return task;
}

int run_sequence(const Settings& settings, const SequenceActions& actions) {
  return Sequence(settings, actions).run();
}

}  // namespace durer::cli
