// Reads words as the program would and keeps what came of it.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "cli/command_line.h"
#include "tests/support/catch.h"

namespace durer::cli::test {

struct Result {
  Settings settings;
  Request request = Request::render;
  std::vector<std::string> errors;  // message, then its help lines
  std::vector<std::string> warnings;
  std::vector<Place> places;  // of the errors
};

inline Result read(const std::vector<std::string>& words, const char* povini = nullptr) {
  static std::vector<std::unique_ptr<SourceMap>> kept;  // places refer to their paths
  kept.push_back(std::make_unique<SourceMap>());
  SourceMap& sources = *kept.back();
  Diagnostics diagnostics(sources);
  Result r;
  Reader reader(sources, diagnostics, r.settings);
  if (povini) reader.default_ini(povini);
  r.request = read_command_line(words, reader);
  for (const Diagnostic& d : diagnostics.all()) {
    std::string text = d.message;
    for (const std::string& help : d.help) text += "; " + help;
    (d.severity == Severity::error ? r.errors : r.warnings).push_back(text);
    if (d.severity == Severity::error) r.places.push_back(sources.place(d.span.begin));
  }
  return r;
}

/// The settings of words that must be right.
inline Settings accepted(const std::vector<std::string>& words) {
  const Result r = read(words);
  CAPTURE(words, r.errors);
  CHECK(r.errors.empty());
  return r.settings;
}

/// The one error of words that must be wrong.
inline std::string refused(const std::vector<std::string>& words) {
  const Result r = read(words);
  CAPTURE(words, r.errors);
  CHECK(r.errors.size() == 1);
  return r.errors.empty() ? "" : r.errors.front();
}

/// A working directory of its own for each test, gone afterwards.
class Folder {
 public:
  Folder() : before_(std::filesystem::current_path()) {
    std::string name = (std::filesystem::temp_directory_path() / "durer-cli-XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    path_ = name;
    std::filesystem::current_path(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::current_path(before_, ignored);
    std::filesystem::remove_all(path_, ignored);
  }
  void file(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name) << text;
  }

 private:
  std::filesystem::path before_;
  std::filesystem::path path_;
};

}  // namespace durer::cli::test
