// The table of options: one line each, for switches, INI keywords, GNU names and help alike.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "cli/settings.h"

namespace durer::cli {

/// How the letters of a switch and what is attached to them become keywords and values.
enum class Form : std::uint8_t {
  flag,   // +X on, -X off; an attached value goes to `companion`, which must then be named
  value,  // ±Xvalue; the sign does not matter
  type,   // ±F[type][bits][g]
  pair,   // keyword only, several of them add up: Declare=name=value
};

/// Chapters of the help.
enum class Group : std::uint8_t {
  files,
  size,
  sampling,
  world,
  animation,
  shell,
  limits,
  debugging,
  messages,
  no_effect,
  obsolete,  // read, with a warning
  not_yet
};

/// What is wrong with a value, in words that follow "… : "; nothing if all is well.
using Problem = std::optional<std::string>;

struct Option {
  std::string_view keyword;  // of INI files and `Keyword=value`
  std::string_view letters;  // of the switch, "AM"; empty: there is none
  Form form = Form::value;
  std::string_view companion;  // the keyword that takes what is attached to a flag
  std::string_view long_name;  // "antialias" for `--antialias`; empty: there is none
  std::string_view hint;       // the value in the help: "n", "file"
  std::string_view doc;
  Group group;
  Problem (*apply)(Settings& settings, std::string_view value);
};

[[nodiscard]] std::span<const Option> options();

/// The option of a keyword, in any case; null if unknown.
[[nodiscard]] const Option* option_of_keyword(std::string_view keyword);
/// The option with the longest letters that begin `text` (what follows the sign of a switch).
[[nodiscard]] const Option* option_of_switch(std::string_view text);

/// Tells what the settings ask for, as a whole, that is not there yet or makes no sense.
[[nodiscard]] Problem check(const Settings& settings);

}  // namespace durer::cli
