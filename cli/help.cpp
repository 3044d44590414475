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
    Chapter{Group::shell, "Shell commands"},
    Chapter{Group::limits, "Limits"},
    Chapter{Group::debugging, "Looking into scenes"},
    Chapter{Group::messages, "Messages"},
    Chapter{Group::no_effect, "Accepted, without effect on the picture"},
    Chapter{Group::obsolete, "Obsolete: ignored with a warning"},
    Chapter{Group::not_yet, "Not supported yet: an error when used"},
};

constexpr std::string_view usage =
    "durer [options] scene.scene       render a scene to scene.png\n"
    "durer [options] -                 read the scene from standard input\n"
    "durer check [options] FILE...     read scenes without rendering them\n"
    "durer parse FILE...               check the syntax only\n"
    "durer doc NAME...                 explain a macro, texture, object, function, directive\n"
    "A command is the first word that is no option; options may stand before it.\n";

constexpr std::string_view notes =
    "Options may be POV-Ray's switches (+W800, either sign, any case, value attached), INI\n"
    "keywords (Width=800) or GNU options (--width 800); they act in their order. + switches on,\n"
    "- switches off. Flags have GNU forms --flag, --flag=off and --no-flag.\n"
    "A bare word is a scene if it ends in .pov or .scene, a library folder if it ends in /, and\n"
    "otherwise an INI file, perhaps with a section: file[section].\n"
    "Before the command line one INI file is read: the one that the environment variable POVINI\n"
    "names, else povray.ini in the working folder.\n";

constexpr std::string_view exit_codes =
    "  0  every picture is complete (or help was printed, or all scenes are good)\n"
    "  1  an error; no picture was written, except of frames before it\n"
    "  2  stopped by SIGINT or SIGTERM; no half picture is ever written, but one of\n"
    "     random paths as far as it has come\n";

constexpr std::string_view explanations =
    "\n## Animations\n\n"
    "One process renders all frames, each from a fresh start. `clock` runs from `Initial_Clock` "
    "to\n"
    "`Final_Clock`; the number of a frame stands in the name of its file before the extension, "
    "with\n"
    "as many digits as the last one has. The first frame that fails ends the run.\n\n"
    "## Interrupted pictures\n\n"
    "Renders of more than some seconds keep what is done in a file beside the picture, "
    "`NAME.state`,\n"
    "and so do interrupted ones. `+C` takes it up, and the picture is the same to the last bit as\n"
    "one rendered at a stretch. If scene or options are not the same any more, `+C` refuses. The "
    "file\n"
    "is removed once the picture is complete. Without a state, `+C` skips pictures that exist.\n\n"
    "## Scenes of strangers\n\n"
    "`--untrusted` sets every limit to the value that its line tells; the command line may set\n"
    "others, INI files may not, nor may they name files to write or folders to search. Scenes "
    "then\n"
    "read only below their own folder and the library folders, write nothing (`#fopen`), and "
    "there\n"
    "are no shell commands. Beyond a limit the run ends with an error and exit code 1.\n\n"
    "## Messages for programs\n\n"
    "With `--diagnostics=json` every line on standard error is a JSON object. `\"kind\"` tells "
    "which:\n\n"
    "- `diagnostic`: `severity` (error, warning, note), `code`, `message`, and if they exist "
    "`file`,\n"
    "  `line`, `column`, `end` (`line`, `column`), `at` (words for the place itself), `labels` "
    "and\n"
    "  `trace` (lists of places with `text`), `help` (a list of texts). Lines and columns count "
    "from\n"
    "  1, columns in bytes; `end` is behind the last byte.\n"
    "- `message`: `stream` (debug, fatal, render, statistic, warning) and `text`, which may be a\n"
    "  part of a line or several.\n\n"
    "## Scenes as data\n\n"
    "`--dump-scene` prints what the scene amounts to: objects, lights, textures, interiors, "
    "camera\n"
    "and settings, with the places where they were written. As text it leaves defaults out, as "
    "JSON\n"
    "(`--dump-scene=json`) it is complete. Numbers of objects, textures and so on are indices "
    "into\n"
    "these lists.\n";

std::string switch_text(const Option& o) {
  if (o.letters.empty()) return {};
  const bool sign_counts = o.form == Form::flag || o.form == Form::type;
  return fmt::format("{}{}{}", sign_counts ? "±" : "+", o.letters, o.hint);
}

std::string long_text(const Option& o) {
  if (o.long_name.empty()) return {};
  if (o.form != Form::flag) return fmt::format("--{} {}", o.long_name, o.hint);
  return fmt::format("--{}{}", o.long_name,
                     o.hint.empty()             ? ""
                     : o.hint.starts_with("[=") ? std::string(o.hint)
                                                : fmt::format("[={}", o.hint.substr(1)));
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
  out += "\nOther\n  --help\n  --version\n  --print-stdlib-path\n        tell where the standard includes are\n";
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
  out += explanations;
  out += "\n## Output types\n\n| name | letter | extension | meaning |\n|---|---|---|---|\n";
  for (const image::Format* f : image::formats()) {
    out += fmt::format("| {} | {} | `{}` | {} |\n", f->name,
                       f->letter == 0 ? std::string("–") : std::string(1, f->letter), f->extension,
                       f->doc);
  }
  return out + fmt::format("\n## Exit codes\n\n```\n{}```\n", exit_codes);
}

}  // namespace durer::cli
