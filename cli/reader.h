// Settings from wherever they stand: switches, `Keyword=value`, INI files. Everything is applied
// in the order in which it is read, so that what comes later wins.
#pragma once

#include "base/diagnostic.h"
#include "cli/options.h"

namespace durer::cli {

/// How a setting is named in messages, and where it stands; {0, 0} for the command line.
struct Written {
  std::string text;
  Span span;
};

class Reader {
 public:
  Reader(SourceMap& sources, Diagnostics& diagnostics, Settings& settings)
      : sources_(&sources), diagnostics_(&diagnostics), settings_(&settings) {}

  /// `Keyword=value`, the value without quotes.
  void keyword(std::string_view name, std::string_view value, const Written& where);
  /// One word: a switch, `Keyword=value`, or the name of a scene, a library folder or an INI file.
  void word(std::string_view text, const Written& where);
  /// "file" or "file[section]"; `.ini` is tried, then the library folders.
  void ini(std::string_view name, const Written& where);
  /// The one INI file that is read before the command line: what POVINI names, else ./povray.ini.
  void default_ini(const char* povini);

  void error(std::string message, const Written& where, std::string help = {});

 private:
  void switch_word(std::string_view text, const Written& where);
  void flag(const Option& option, bool on, std::string_view attached, const Written& where);
  void output_type(const Option& option, bool on, std::string_view attached, const Written& where);
  void bare_word(std::string_view text, const Written& where);
  void warn_obsolete(const Option& option, const Written& where);
  void unknown_switch(std::string_view text, const Written& where);
  void ini_text(FileId file, std::string_view section);
  void ini_line(std::string_view line);

  [[nodiscard]] Span span_of(std::string_view text) const;

  SourceMap* sources_;
  Diagnostics* diagnostics_;
  Settings* settings_;
  FileId file_ = 0;  // of the INI file being read
  int depth_ = 0;
};

}  // namespace durer::cli
