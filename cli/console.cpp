#include "cli/console.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

namespace durer::cli {

Console::Console(const Settings& settings, std::string& problem) {
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

void Console::print(Stream stream, std::string_view text) {
  const auto index = static_cast<std::size_t>(stream);
  const auto put = [&](std::FILE* to) {
    std::fwrite(text.data(), 1, text.size(), to);
    std::fflush(to);
  };
  if (console_[index]) put(stderr);
  if (files_[index]) put(files_[index].get());
  if (all_) put(all_.get());
}

bool Console::speaks(Stream stream) const { return console_[static_cast<std::size_t>(stream)]; }

}  // namespace durer::cli
