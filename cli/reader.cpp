// Words and keywords; INI files are in ini.cpp.
#include "cli/reader.h"

#include <fmt/format.h>

#include "base/suggest.h"
#include "cli/values.h"

namespace durer::cli {
namespace {

std::string nearest_keyword(std::string_view word) {
  std::vector<std::string> names;
  for (const Option& o : options()) names.push_back(lower(o.keyword));
  const std::vector<std::string_view> views(names.begin(), names.end());
  const std::string wanted = lower(word);
  const auto near = closest(wanted, views);
  return near ? fmt::format("did you mean `{}`?", option_of_keyword(*near)->keyword) : "";
}

/// GNU names written with one dash are the commonest slip of people who never used POV-Ray, and
/// some of them would pass for a switch: `-output` for a picture named "utput".
std::optional<std::string_view> gnu_name(std::string_view text) {
  if (!text.starts_with('-')) return std::nullopt;
  const std::string_view name = text.substr(1, text.find('=') - 1);
  for (const std::string_view own : {"help", "version"}) {
    if (same_word(own, name)) return own;
  }
  for (const Option& o : options()) {
    if (!o.long_name.empty() && same_word(o.long_name, name)) return o.long_name;
  }
  return std::nullopt;
}

/// The longest run of letters in `text` that is a switch: +ZW3 → +W.
std::string nearest_switch(std::string_view text) {
  const auto is_switch = [](std::string_view letters) {
    const Option* option = option_of_switch(letters);
    return option && option->letters.size() == letters.size() ? option : nullptr;
  };
  const std::string_view word = text.substr(1);
  for (std::size_t size = word.size(); size > 0; --size) {
    for (std::size_t at = 0; at + size <= word.size(); ++at) {
      const Option* option = is_switch(word.substr(at, size));
      if (option) return fmt::format("did you mean `{}{}`?", text.front(), option->letters);
    }
  }
  return {};
}

}  // namespace

void Reader::error(std::string message, const Written& where, std::string help) {
  Diagnostic d;
  d.code = Code::option;
  d.span = where.span;
  d.message = std::move(message);
  if (!help.empty()) d.help.push_back(std::move(help));
  diagnostics_->report(std::move(d));
}

void Reader::warn_obsolete(const Option& option, const Written& where) {
  Diagnostic d;
  d.severity = Severity::warning;
  d.code = Code::option;
  d.span = where.span;
  d.message = fmt::format("`{}`: {} is obsolete and has no effect", where.text, option.keyword);
  diagnostics_->report(std::move(d));
}

void Reader::keyword(std::string_view name, std::string_view value, const Written& where) {
  const Option* option = option_of_keyword(name);
  if (!option) {
    return error(fmt::format("`{}`: there is no option `{}`", where.text, name), where,
                 nearest_keyword(name));
  }
  if (!option->apply) return ini(value, where);
  if (const Problem problem = option->apply(*settings_, value)) {
    return error(fmt::format("`{}`: {}", where.text, *problem), where);
  }
  if (option->group == Group::obsolete) warn_obsolete(*option, where);
  settings_->history.emplace_back(option->keyword, value);
  if (where.span.begin != 0) settings_->from_ini.emplace_back(option->keyword);
}

void Reader::word(std::string_view text, const Written& where) {
  if (text.empty()) return;
  if (text == "-") return keyword("Input_File_Name", text, where);
  if (text.front() == '+' || text.front() == '-') return switch_word(text, where);
  const std::size_t equals = text.find('=');
  const std::string_view name = trim(text.substr(0, equals));
  if (equals != std::string_view::npos && name.find_first_of("./[") == std::string_view::npos) {
    return keyword(name, unquote(trim(text.substr(equals + 1))), where);
  }
  bare_word(unquote(text), where);
}

void Reader::switch_word(std::string_view text, const Written& where) {
  if (gnu_name(text)) return unknown_switch(text, where);
  const bool on = text.front() == '+';
  const Option* option = option_of_switch(text.substr(1));
  if (!option) return unknown_switch(text, where);
  const std::string_view attached = unquote(text.substr(1 + option->letters.size()));
  switch (option->form) {
    case Form::flag: return flag(*option, on, attached, where);
    case Form::type: return output_type(*option, on, attached, where);
    case Form::value:
    case Form::pair: break;
  }
  if (attached.empty()) {
    return error(fmt::format("`{}`: expected a value, attached to the letters", where.text), where,
                 fmt::format("write `{}<{}>` without a blank", where.text, option->hint));
  }
  keyword(option->keyword, attached, where);
}

void Reader::flag(const Option& option, bool on, std::string_view attached, const Written& where) {
  if (!attached.empty()) {
    if (option.companion.empty()) return unknown_switch(where.text, where);
    keyword(option.companion, attached, where);
  }
  keyword(option.keyword, on ? "on" : "off", where);
}

// [type letter][bits][g], for instance N16 or Ng.
void Reader::output_type(const Option& option, bool on, std::string_view attached,
                         const Written& where) {
  keyword(option.keyword, on ? "on" : "off", where);
  if (attached.empty()) return;
  keyword(option.companion, attached.substr(0, 1), where);
  attached.remove_prefix(1);
  if (!attached.empty() && same_word(attached.substr(attached.size() - 1), "g")) {
    keyword("Grayscale_Output", "on", where);
    attached.remove_suffix(1);
  }
  if (!attached.empty()) keyword("Bits_Per_Color", attached, where);
}

void Reader::bare_word(std::string_view text, const Written& where) {
  const std::string tail = lower(text);
  if (tail.ends_with(".pov") || tail.ends_with(".scene")) {
    return keyword("Input_File_Name", text, where);
  }
  if (tail.ends_with('/')) return keyword("Library_Path", text, where);
  ini(text, where);
}

void Reader::unknown_switch(std::string_view text, const Written& where) {
  const auto gnu = gnu_name(text);
  error(fmt::format("there is no switch `{}`", text), where,
        gnu ? fmt::format("did you mean `--{}`?", *gnu) : nearest_switch(text));
}

}  // namespace durer::cli
