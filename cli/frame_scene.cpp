#include "cli/frame_scene.h"

#include <fmt/format.h>

#include <chrono>
#include <utility>
#include <vector>

#include "cli/convert.h"
#include "cli/diagnostic_json.h"
#include "cli/guard.h"
#include "cli/limits.h"
#include "image/read.h"
#include "scene/dump.h"
#include "tracer/compile.h"
#include "tracer/object_queries.h"
#include "tracer/pigment_queries.h"

namespace durer::cli {
namespace {

/// The interpreter watches the clock where scenes spend their time. Should it be caught elsewhere,
/// the run ends without a place.
double hard_limit(double seconds) { return seconds > 0 ? 1.5 * seconds + 2 : 0; }

std::string too_slow(const Settings& settings, double seconds) {
  SourceMap none;
  Diagnostic d;
  d.code = Code::limit;
  d.message = fmt::format("the scene takes longer to read than Max_Seconds={:g}", seconds);
  return settings.json ? diagnostic_json(d, none) : render_diagnostic(d, none, colour_wanted());
}

std::vector<std::shared_ptr<const void>>& left_behind() {
  static auto& parts = *new std::vector<std::shared_ptr<const void>>;  // never destroyed
  return parts;
}

}  // namespace

void leave_behind(std::shared_ptr<const void> part) { left_behind().push_back(std::move(part)); }

std::unique_ptr<FrameScene> read_frame(const Settings& settings, const SceneText& text,
                                       const FrameTask& task, Console& console) {
  using Clock = std::chrono::steady_clock;
  for (std::shared_ptr<const void>& part : left_behind()) part.reset();
  left_behind().clear();
  auto frame = std::make_unique<FrameScene>();
  interpreter::Options options = interpreter_options(settings, task);
  frame->queries = tracer::make_object_queries();
  options.queries = frame->queries.get();
  frame->pigments = tracer::make_pigment_queries();
  options.pigments = frame->pigments.get();
  options.read_picture = image::read;
  options.stdlib_path = stdlib_folder();
  options.fallback_paths = installed_include_folders();
  options.on_debug = [&](std::string_view said) { console.print(Stream::debug, said); };
  if (settings.trace_macros) {
    options.on_trace = [&](std::string_view line) {
      console.print(Stream::debug, fmt::format("{}\n", line));
    };
  }
  options.on_assumptions = [&](std::string_view line) { frame->assumed = line; };
  const double seconds = options.limits.seconds;
  const Deadline deadline(hard_limit(seconds), [&] { stop_now(too_slow(settings, seconds)); });
  const auto start = Clock::now();
  const FileId file = frame->sources.add(text.path, text.text);
  frame->scene =
      interpreter::interpret(frame->sources, file, tracer::registry(), options, frame->diagnostics);
  frame->seconds = std::chrono::duration<double>(Clock::now() - start).count();
  if (frame->diagnostics.has_errors()) frame->scene.reset();
  return frame;
}

bool dump(const FrameScene& frame, const Settings& settings) {
  const auto style =
      settings.dump_scene == DumpFormat::json ? scene::DumpStyle::json : scene::DumpStyle::text;
  bool written = true;
  scene::dump(*frame.scene, tracer::registry(), &frame.sources, style, [&](std::string_view text) {
    written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && written;
  });
  return std::fflush(stdout) == 0 && written;
}

}  // namespace durer::cli
