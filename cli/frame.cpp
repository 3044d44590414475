#include "cli/frame.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <span>

#include "cli/checkpointing.h"
#include "cli/commands.h"
#include "cli/convert.h"
#include "cli/frame_scene.h"
#include "cli/guard.h"
#include "cli/interrupt.h"
#include "cli/limits.h"
#include "cli/progress.h"
#include "cli/scene_file.h"
#include "cli/terminal.h"
#include "tracer/compile.h"

namespace durer::cli {
namespace {

namespace fs = std::filesystem;

bool is_rendered(const std::string& path) {
  std::error_code error;
  return fs::is_regular_file(path, error) && fs::file_size(path, error) > 0 && !error;
}

class Render {
 public:
  Render(const Settings& settings, Console& console, const FrameTask& task)
      : settings_(settings), console_(console), task_(task), output_(output_of(settings, task)) {}

  int run(const SceneText& text) {
    if (settings_.continue_trace && !has_state() && is_rendered(output_.path)) {
      console_.print(Stream::render, fmt::format("{} is already rendered\n", output_.path));
      return exit_code::ok;
    }
    std::string problem;
    const auto window = window_of(settings_, problem);
    if (!window) return console_.fail(Code::option, problem);
    if (const auto unwritable = image::probe(output_.path)) {
      return console_.fail(Code::file_not_written, *unwritable);
    }
    announce();
    auto frame = read_frame(settings_, text, task_, console_);
    constexpr std::size_t large = 1 << 20;  // bytes
    frame->sources.rest(large);
    tracer::CompiledScenePtr compiled;
    if (frame->scene) {
      compiled = tracer::compile(*frame->scene, frame->diagnostics, settings_.quality,
                                 settings_.paths ? tracer::Integrator::path
                                                 : tracer::Integrator::trace);
    }
    console_.print(frame->diagnostics);
    if (!compiled || frame->diagnostics.has_errors()) return exit_code::error;
    stop_ = &interrupts_set_flag();  // from here on there is something to keep
    console_.print(Stream::render, assumptions(settings_, frame->scene->settings, frame->assumed) + "\n");
    const int code = trace(*frame->scene, *compiled, *window);
    Diagnostics events(frame->sources);
    tracer::report_events(*compiled, events);
    if (!warning_.empty()) {
      Diagnostic d;
      d.severity = Severity::warning;
      d.code = Code::file_not_written;
      d.message = warning_;
      events.report(std::move(d));
    }
    console_.print(events);
    leave_behind(std::move(compiled));
    leave_behind(std::move(frame));
    return code;
  }

 private:
  [[nodiscard]] bool has_state() const {
    std::error_code ignored;
    const std::string path = state_path(output_.path);
    return !path.empty() && fs::exists(path, ignored);
  }

  void announce() {
    if (!task_.animation) return;
    console_.print(Stream::render, fmt::format("frame {} ({} of {}), clock {:g}\n", task_.number,
                                               task_.index + 1, task_.count, task_.clock));
  }

  int trace(const scene::Scene& scene, const tracer::CompiledScene& compiled,
            const Window& window) {
    tracer::RenderOptions options = render_options(settings_, window);
    const bool gathers = scene.settings.radiosity && !settings_.paths;
    if (const auto problem = gathers ? take_gathered_light(options) : std::nullopt) {
      return console_.fail(Code::file_not_found, *problem,
                           "`+RFO` writes such a file, `-RFI` renders without it");
    }
    Checkpointing saved(state_path(output_.path), scene, options);
    if (settings_.continue_trace) {
      if (const auto refused = saved.take_up()) {
        return console_.fail(Code::option, *refused,
                             "remove that file, or render anew without `+C`");
      }
    }
    std::atomic<bool> expired = false;
    const double seconds = limits_of(settings_).render_seconds;
    tracer::RenderResult result;
    {
      const Deadline deadline(seconds, [&] { expired = *stop_ = true; });
      ProgressLine line(stderr, terminal_columns(STDERR_FILENO));
      const bool shows =
          settings_.verbose.value_or(true) && console_.speaks(Stream::render) && !console_.json();
      const auto on_progress = [&](const tracer::Progress& p) {
        if (shows) line.show(p);
        saved.save_now_and_then(p);
      };
      result = tracer::render(compiled, options, on_progress, stop_, &saved.checkpoint());
      line.clear();
    }
    warning_ = result.warning;
    if (options.keep_gathered && !result.cancelled) write_gathered_light(result.gathered);
    const image::Encoding encoding = encoding_of(settings_, scene.settings);
    if (!result.cancelled) return finish(result, window, encoding, saved);
    const auto lost = saved.save();
    std::string state = lost ? *lost : fmt::format("`+C` takes up what is in {}", saved.path());
    if (settings_.paths) {
      tracer::Checkpoint::State so_far = saved.checkpoint().copy();
      const int samples = tracer::fewest_samples(options, so_far);
      state = fmt::format("{} of {} samples per pixel; {}", samples, options.samples, state);
      if (samples > 0) return write_so_far(so_far.image, window, encoding, state);
    }
    return stopped(state, expired, seconds);
  }

  // Light that an earlier render gathered. Animations begin without: the first frame writes the file.
  std::optional<std::string> take_gathered_light(tracer::RenderOptions& options) const {
    options.keep_gathered = settings_.radiosity_to_file;
    if (!settings_.radiosity_from_file) return std::nullopt;
    const std::string& path = settings_.radiosity_file;
    const auto text = read_file(path);
    if (!text && settings_.radiosity_to_file) return std::nullopt;
    if (!text) return fmt::format("cannot read the gathered light of `{}`", path);
    if (tracer::take_gathered(options, *text)) return std::nullopt;
    return fmt::format("`{}` is no file of gathered light", path);
  }

  void write_gathered_light(const std::string& text) {
    const auto bytes = std::span(reinterpret_cast<const unsigned char*>(text.data()), text.size());
    if (auto problem = image::write_file(settings_.radiosity_file, bytes)) warning_ = *problem;
  }

  // Random paths show all of the picture early; it is only noisy.
  int write_so_far(image::Image& image, const Window& window, const image::Encoding& encoding,
                   const std::string& state) {
    if (const auto error = write(image, window, encoding)) {
      return console_.fail(Code::file_not_written, *error);
    }
    console_.print(Stream::fatal, fmt::format("stopped, the picture has {}\n", state));
    return exit_code::interrupted;
  }

  int stopped(const std::string& state, bool expired, double seconds) {
    if (expired) {
      return console_.fail(
          Code::limit, fmt::format("rendering takes longer than Max_Render_Seconds={:g}", seconds),
          state);
    }
    console_.print(Stream::fatal, fmt::format("interrupted, no picture was written; {}\n", state));
    return exit_code::interrupted;
  }

  [[nodiscard]] std::optional<std::string> write(image::Image& image, const Window& window,
                                                 const image::Encoding& encoding) const {
    blacken_outside(image, window);
    if (output_.path.empty()) return std::nullopt;
    return image::write(image, output_.path, *output_.format, encoding);
  }

  int finish(tracer::RenderResult& result, const Window& window, const image::Encoding& encoding,
             Checkpointing& saved) {
    if (const auto error = write(result.image, window, encoding)) {
      return console_.fail(Code::file_not_written, *error);
    }
    saved.remove();
    if (settings_.show) show(result.image, encoding);
    console_.print(Stream::statistic, closing_line(result.final));
    return exit_code::ok;
  }

  void show(const image::Image& image, const image::Encoding& encoding) const {
    const bool taken = output_.path == "-";  // standard output already carries the picture
    const int fd = taken ? STDERR_FILENO : STDOUT_FILENO;
    const std::string picture = draw(image, encoding, terminal_of(fd));
    std::FILE* to = taken ? stderr : stdout;
    std::fwrite(picture.data(), 1, picture.size(), to);
    std::fflush(to);
  }

  [[nodiscard]] std::string closing_line(const tracer::Progress& p) const {
    const std::string where = output_.path.empty()  ? "nothing written"
                              : output_.path == "-" ? "standard output"
                                                    : output_.path;
    const double rays = static_cast<double>(p.rays);
    return fmt::format("{}: {}x{}, {}, {} rays ({} rays/s)\n", where, settings_.width,
                       settings_.height, time_text(p.seconds), count_text(rays),
                       count_text(p.seconds > 0 ? rays / p.seconds : 0));
  }

  const Settings& settings_;
  Console& console_;
  const FrameTask& task_;
  Output output_;
  std::atomic<bool>* stop_ = nullptr;
  std::string warning_;  // of the render
};

}  // namespace

Output output_of(const Settings& settings, const FrameTask& task) {
  if (!task.animation) return output_of(settings);
  return output_of(settings, FrameNumber{task.number, task.animation->digits});
}

int render_frame(const Settings& settings, const SceneText& text, Console& console,
                 const FrameTask& task) {
  return Render(settings, console, task).run(text);
}

}  // namespace durer::cli
