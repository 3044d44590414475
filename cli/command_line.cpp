#include "cli/command_line.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "base/suggest.h"
#include "cli/values.h"

namespace durer::cli {
namespace {

/// The one option of CLI11 that carries everything which is not a GNU option.
constexpr const char* word_option = "--word";

/// Long options of flags: `--alpha`, `--alpha=off`, `--antialias=0.1`, `--no-alpha`.
void long_flag(const Option& option, const std::string& value, Reader& reader) {
  const std::string written =
      fmt::format("--{}{}{}", option.long_name, value.empty() ? "" : "=", value);
  if (value.empty() || parse_bool(value) || option.companion.empty()) {
    return reader.keyword(option.keyword, value.empty() ? "on" : value, {written, {}});
  }
  reader.keyword(option.companion, value, {written, {}});
  reader.keyword(option.keyword, "on", {written, {}});
}

/// CLI11 knows the GNU options of the table. Each acts as soon as it is read, because the order
/// among all words counts.
void add_options(CLI::App& app, Reader& reader) {
  const auto add = [&](const std::string& name, auto act) {
    return app.add_option_function<std::string>(name, act)->trigger_on_parse();
  };
  for (const Option& o : options()) {
    if (o.long_name.empty()) continue;
    const std::string name(o.long_name);
    if (o.form == Form::flag) {
      add("--" + name, [&](const std::string& v) { long_flag(o, v, reader); })->expected(0, 1);
      add("--no-" + name, [&, name](const std::string&) {
        reader.keyword(o.keyword, "off", {"--no-" + name, {}});
      })->expected(0);
    } else {
      add("--" + name, [&, name](const std::string& v) {
        reader.keyword(o.keyword, unquote(v), {fmt::format("--{}={}", name, v), {}});
      });
    }
  }
  add(word_option, [&](const std::string& v) { reader.word(v, {v, {}}); });
}

bool takes_value(const std::string& word) {
  if (word.find('=') != std::string::npos) return false;
  for (const Option& o : options()) {
    if (!o.long_name.empty() && word.substr(2) == o.long_name) return o.form != Form::flag;
  }
  return false;
}

/// CLI11 must not see `+W80` or `-A0.3`, whose syntax it does not know: every word that is neither
/// a GNU option nor the value of one becomes the value of `word_option`.
std::vector<std::string> wrap(const std::vector<std::string>& words) {
  std::vector<std::string> out;
  bool only_words = false;  // after `--`
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (!only_words && word == "--") {
      only_words = true;
    } else if (only_words || !word.starts_with("--")) {
      if (!word.empty()) out.push_back(std::string(word_option) + "=" + word);
    } else if (takes_value(word) && i + 1 < words.size()) {
      out.push_back(word + "=" + words[++i]);
    } else {
      out.push_back(word);
    }
  }
  return out;
}

void unknown_option(const std::string& word, Reader& reader) {
  const std::string name = word.substr(0, word.find('='));
  std::vector<std::string> names = {"--help", "--version", "--print-stdlib-path"};
  for (const Option& o : options()) {
    if (!o.long_name.empty()) names.push_back("--" + std::string(o.long_name));
  }
  const std::vector<std::string_view> views(names.begin(), names.end());
  const auto near = closest(name, views);
  reader.error(
      fmt::format("there is no option `{}`", name), {word, {}},
      near ? fmt::format("did you mean `{}`?", *near) : "`durer --help` lists the options");
}

}  // namespace

std::size_t first_bare_word(const std::vector<std::string>& words) {
  std::size_t i = 0;
  while (i < words.size()) {
    const std::string& word = words[i];
    if (word.starts_with("--")) {
      i += takes_value(word) ? 2 : 1;
    } else if (word.find('=') != std::string::npos || word.starts_with('+') || word.starts_with('-')) {
      ++i;
    } else {
      return i;
    }
  }
  return words.size();
}

Request read_command_line(const std::vector<std::string>& words, Reader& reader) {
  Request request = Request::render;
  CLI::App app;
  app.set_help_flag();
  app.allow_extras();
  add_options(app, reader);
  app.add_flag_callback("--help", [&] { request = Request::help; });
  app.add_flag_callback("--help-markdown", [&] { request = Request::help_markdown; });
  app.add_flag_callback("--version", [&] { request = Request::version; });
  app.add_flag_callback("--print-stdlib-path", [&] { request = Request::stdlib_path; });
  std::vector<std::string> backwards = wrap(words);  // CLI11 takes its vector from the back
  std::ranges::reverse(backwards);
  try {
    app.parse(std::move(backwards));
  } catch (const CLI::ParseError& e) {
    reader.error(e.what(), {}, "`durer --help` lists the options");
  }
  for (const std::string& word : app.remaining()) unknown_option(word, reader);
  return request;
}

}  // namespace durer::cli
