// From the command line to the picture.
#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/convert.h"
#include "cli/create_ini.h"
#include "cli/help.h"
#include "cli/interrupt.h"
#include "cli/output_name.h"
#include "cli/progress.h"
#include "cli/scene_file.h"
#include "cli/terminal.h"
#include "tracer/object_queries.h"
#include "tracer/pigment_queries.h"

namespace durer::cli {
namespace {

/// Sends what a phase has reported to the streams of warnings and errors.
void print_diagnostics(const Diagnostics& diagnostics, const Settings& settings, Console& console) {
  for (const Diagnostic& d : diagnostics.all()) {
    const bool is_error = d.severity == Severity::error;
    if (!is_error && settings.warning_level == 0) continue;
    console.print(is_error ? Stream::fatal : Stream::warning,
                  render_diagnostic(d, diagnostics.sources(), colour_wanted()));
  }
  if (const std::size_t more = diagnostics.dropped_errors(); more > 0) {
    console.print(Stream::fatal, fmt::format("and {} more error{}\n", more, more == 1 ? "" : "s"));
  }
}

int fail(Console& console, const std::string& message) {
  console.print(Stream::fatal, fmt::format("error: {}\n", message));
  return exit_code::error;
}

class Render {
 public:
  Render(Settings& settings, Console& console)
      : settings_(settings), console_(console), diagnostics_(sources_) {}

  int run() {
    const auto file = read_scene(settings_, sources_, diagnostics_);
    if (!file) return end_with_errors();
    output_ = output_of(settings_);
    std::string problem;
    const auto window = window_of(settings_, problem);
    if (!window) return fail(console_, problem);
    if (const auto unwritable = image::probe(output_.path)) return fail(console_, *unwritable);

    interpreter::Options options = interpreter_options(settings_);
    const auto queries = tracer::make_object_queries();
    options.queries = queries.get();
    const auto pigments = tracer::make_pigment_queries();
    options.pigments = pigments.get();
    options.stdlib_path = stdlib_folder();
    options.fallback_paths = installed_include_folders();
    options.on_debug = [&](std::string_view text) { console_.print(Stream::debug, text); };
    const auto scene =
        interpreter::interpret(sources_, *file, tracer::registry(), options, diagnostics_);
    if (!scene) return end_with_errors();
    const auto compiled = tracer::compile(*scene, diagnostics_);
    if (!compiled || diagnostics_.has_errors()) return end_with_errors();
    print_diagnostics(diagnostics_, settings_, console_);
    console_.print(Stream::render, assumptions(settings_, scene->settings) + "\n");
    return trace(*compiled, *window, encoding_of(settings_, scene->settings));
  }

 private:
  int end_with_errors() {
    print_diagnostics(diagnostics_, settings_, console_);
    return exit_code::error;
  }

  int trace(const tracer::CompiledScene& compiled, const Window& window,
            const image::Encoding& encoding) {
    ProgressLine line(stderr, terminal_columns(STDERR_FILENO));
    const bool shows_progress = settings_.verbose.value_or(true) && console_.speaks(Stream::render);
    std::function<void(const tracer::Progress&)> on_progress;
    if (shows_progress) on_progress = [&](const tracer::Progress& p) { line.show(p); };
    auto result = tracer::render(compiled, render_options(settings_, window), on_progress,
                                 &interrupts_set_flag());
    line.clear();
    if (result.cancelled) {
      console_.print(Stream::fatal, "interrupted, no picture was written\n");
      return exit_code::interrupted;
    }
    blacken_outside(result.image, window);
    if (!output_.path.empty()) {
      const auto error = image::write(result.image, output_.path, *output_.format, encoding);
      if (error) return fail(console_, *error);
    }
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

  Settings& settings_;
  Console& console_;
  SourceMap sources_;
  Diagnostics diagnostics_;
  Output output_;
};

int print_and_leave(const std::string& text) {
  fmt::print("{}", text);
  return exit_code::ok;
}

}  // namespace

bool colour_wanted() {
  const char* no_color = std::getenv("NO_COLOR");
  return ::isatty(STDERR_FILENO) != 0 && (!no_color || !*no_color);
}

int render_command(const std::vector<std::string>& words) {
  SourceMap option_sources;  // apart from the scene's, whose first file is the scene
  Diagnostics option_problems(option_sources);
  Settings settings;
  Reader reader(option_sources, option_problems, settings);
  reader.default_ini(std::getenv("POVINI"));
  switch (read_command_line(words, reader)) {
    case Request::help: return print_and_leave(help_text());
    case Request::help_markdown: return print_and_leave(help_markdown());
    case Request::version: return print_and_leave(version_text());
    case Request::render: break;
  }
  if (const Problem problem = check(settings)) reader.error(*problem, {});
  if (settings.input.empty() && !option_problems.has_errors()) {
    reader.error("there is no scene to render", {},
                 "write `durer scene.scene`; `durer --help` lists the options");
  }
  std::string problem;
  Console console(settings, problem);
  if (!problem.empty()) reader.error(problem, {});
  print_diagnostics(option_problems, settings, console);
  if (option_problems.has_errors()) return exit_code::error;
  if (const auto error = create_ini(settings)) return fail(console, *error);
  return Render(settings, console).run();
}

}  // namespace durer::cli
