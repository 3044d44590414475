#include "cli/help.h"

#include <fmt/format.h>

#include <array>

#include "cli/options.h"
#include "image/image.h"

namespace durer::cli {
namespace {

struct Chapter {
  Group group;
  std::string_view title;
};

constexpr std::array chapters = {
    Chapter{Group::files, "Files"},
    Chapter{Group::size, "Size and part"},
    Chapter{Group::sampling, "Sampling"},
    Chapter{Group::world, "What the scene sees"},
    Chapter{Group::animation, "Animation"},
    Chapter{Group::messages, "Messages"},
    Chapter{Group::no_effect, "Accepted, without effect on the picture"},
    Chapter{Group::not_yet, "Not supported yet: an error when used"},
};

constexpr std::string_view usage =
    "durer [options] scene.scene       render a scene to scene.png\n"
    "durer [options] -                 read the scene from standard input\n"
    "durer parse FILE...               check the syntax only\n";

constexpr std::string_view notes =
    "Options may be POV-Ray's switches (+W800, either sign, any case, value attached), INI\n"
    "keywords (Width=800) or GNU options (--width 800); they act in their order. + switches on,\n"
    "- switches off. Flags have GNU forms --flag, --flag=off and --no-flag.\n"
    "A bare word is a scene if it ends in .pov or .scene, a library folder if it ends in /, and\n"
    "otherwise an INI file, perhaps with a section: file[section].\n"
    "Before the command line one INI file is read: the one that the environment variable POVINI\n"
    "names, else povray.ini in the working folder.\n";

constexpr std::string_view exit_codes =
    "  0  the picture is complete (or help was printed)\n"
    "  1  an error; nothing was written\n"
    "  2  stopped by SIGINT or SIGTERM; nothing was written\n";

std::string switch_text(const Option& o) {
  if (o.letters.empty()) return {};
  const bool sign_counts = o.form == Form::flag || o.form == Form::type;
  return fmt::format("{}{}{}", sign_counts ? "±" : "+", o.letters, o.hint);
}

std::string long_text(const Option& o) {
  if (o.long_name.empty()) return {};
  if (o.form != Form::flag) return fmt::format("--{} {}", o.long_name, o.hint);
  return fmt::format("--{}{}", o.long_name,
                     o.hint.empty() ? "" : fmt::format("[={}", o.hint.substr(1)));
}

std::string keyword_text(const Option& o) {
  return fmt::format("{}={}", o.keyword,
                     o.form == Form::flag || o.form == Form::type ? "on" : o.hint);
}

/// Breaks at blanks so that lines stay within 100 columns.
std::string indented(std::string_view text, std::size_t indent) {
  std::string out;
  std::size_t column = indent;
  while (!text.empty()) {
    const std::size_t blank = text.find(' ');
    const std::string_view word = text.substr(0, blank);
    if (column + word.size() > 98 && column > indent) {
      out += '\n';
      out.append(indent, ' ');
      column = indent;
    }
    if (column > indent) out += ' ';
    out += word;
    column += word.size() + 1;
    text = blank == std::string_view::npos ? std::string_view() : text.substr(blank + 1);
  }
  return out;
}

std::string help_line(const Option& o) {
  std::string names = switch_text(o);
  if (const std::string text = long_text(o); !text.empty()) {
    names += (names.empty() ? "" : ", ") + text;
  }
  names += (names.empty() ? "" : ", ") + keyword_text(o);
  if (o.doc.empty()) return fmt::format("  {}\n", names);
  return fmt::format("  {}\n        {}\n", names, indented(o.doc, 8));
}

}  // namespace

std::string version_text() { return fmt::format("durer {}\n", DURER_VERSION); }

std::string help_text() {
  std::string out =
      fmt::format("Durer {}: renders scenes in the language of POV-Ray 3.7.\n\n{}\n{}",
                  DURER_VERSION, usage, notes);
  for (const Chapter& chapter : chapters) {
    out += fmt::format("\n{}\n", chapter.title);
    for (const Option& o : options()) {
      if (o.group == chapter.group) out += help_line(o);
    }
  }
  out += "\nOther\n  --help\n  --version\n";
  return out + fmt::format("\nExit codes\n{}", exit_codes);
}

std::string help_markdown() {
  std::string out = fmt::format("# The command line\n\n```\n{}```\n\n{}", usage, notes);
  for (const Chapter& chapter : chapters) {
    out +=
        fmt::format("\n## {}\n\n| switch | keyword | long option | meaning |\n|---|---|---|---|\n",
                    chapter.title);
    for (const Option& o : options()) {
      if (o.group != chapter.group) continue;
      const auto code = [](const std::string& text) {
        return text.empty() ? std::string("–") : fmt::format("`{}`", text);
      };
      out += fmt::format("| {} | {} | {} | {} |\n", code(switch_text(o)), code(keyword_text(o)),
                         code(long_text(o)), o.doc);
    }
  }
  out += "\n## Output types\n\n| name | letter | extension | meaning |\n|---|---|---|---|\n";
  for (const image::Format* f : image::formats()) {
    out += fmt::format("| {} | {} | `{}` | {} |\n", f->name,
                       f->letter == 0 ? std::string("–") : std::string(1, f->letter), f->extension,
                       f->doc);
  }
  return out + fmt::format("\n## Exit codes\n\n```\n{}```\n", exit_codes);
}

}  // namespace durer::cli
