#include "cli/console.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "cli/diagnostic_json.h"

namespace durer::cli {
namespace {

constexpr std::array<std::string_view, stream_count> names = {"debug", "fatal", "render",
                                                              "statistic", "warning"};

void put(std::FILE* to, std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), to);
  std::fflush(to);
}

}  // namespace

Console::Console(const Settings& settings, std::string& problem)
    : json_(settings.json), warnings_(settings.warning_level > 0) {
  for (std::size_t i = 0; i < stream_count; ++i) {
    const bool muted = settings.quiet && static_cast<Stream>(i) != Stream::fatal;
    console_[i] = settings.streams[i].console && !muted;
    files_[i] = open(settings.streams[i].file, settings.append_files, problem);
  }
  all_ = open(settings.all_file, settings.append_files, problem);
}

Console::File Console::open(const std::string& path, bool append, std::string& problem) {
  if (path.empty()) return nullptr;
  File file(std::fopen(path.c_str(), append ? "ae" : "we"));
  if (!file) problem = fmt::format("cannot write `{}`: {}", path, std::strerror(errno));
  return file;
}

void Console::to_console(Stream stream, std::string_view text) {
  if (speaks(stream)) put(stderr, text);
}

void Console::to_files(Stream stream, std::string_view text) {
  const File& own = files_[static_cast<std::size_t>(stream)];
  if (own) put(own.get(), text);
  if (all_) put(all_.get(), text);
}

void Console::print(Stream stream, std::string_view text) {
  to_console(stream, json_ ? message_json(names[static_cast<std::size_t>(stream)], text) : text);
  to_files(stream, text);
}

void Console::print(const Diagnostic& d, const SourceMap& sources) {
  const bool is_error = d.severity == Severity::error;
  if (!is_error && !warnings_) return;
  const Stream stream = is_error ? Stream::fatal : Stream::warning;
  to_console(stream,
             json_ ? diagnostic_json(d, sources) : render_diagnostic(d, sources, colour_wanted()));
  to_files(stream, render_diagnostic(d, sources));
}

void Console::print(const Diagnostics& diagnostics) {
  for (const Diagnostic& d : diagnostics.all()) print(d, diagnostics.sources());
  if (const std::size_t more = diagnostics.dropped_errors(); more > 0) {
    print(Stream::fatal, fmt::format("and {} more error{}\n", more, more == 1 ? "" : "s"));
  }
}

int Console::fail(Code code, std::string message, std::string help) {
  Diagnostic d;
  d.code = code;
  d.message = std::move(message);
  if (!help.empty()) d.help.push_back(std::move(help));
  print(d, SourceMap());
  return 1;
}

bool Console::speaks(Stream stream) const { return console_[static_cast<std::size_t>(stream)]; }

bool colour_wanted() {
  const char* no_color = std::getenv("NO_COLOR");
  return ::isatty(STDERR_FILENO) != 0 && (!no_color || !*no_color);
}

}  // namespace durer::cli
