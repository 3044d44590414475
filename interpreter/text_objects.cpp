// `text`: a union of glyphs, each of which is a primitive (objects §10.15).
#include <array>
#include <cmath>
#include <filesystem>
#include <unordered_map>

#include <fmt/format.h>

#include "interpreter/font.h"
#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;
namespace fs = std::filesystem;

namespace {

/// Fonts that may be shipped with anything, to stand in for one that is missing: by what it looks
/// like, best first (stdlib §23). Each in the folder of its Debian package.
struct Substitute {
  std::string_view file;
  std::string_view name;
};
constexpr std::array<Substitute, 4> serif = {{
    {"liberation2/LiberationSerif-Regular.ttf", "Liberation Serif"},
    {"liberation/LiberationSerif-Regular.ttf", "Liberation Serif"},
    {"freefont/FreeSerif.ttf", "FreeSerif"},
    {"dejavu/DejaVuSerif.ttf", "DejaVu Serif"},
}};
constexpr std::array<Substitute, 4> sans = {{
    {"liberation2/LiberationSans-Regular.ttf", "Liberation Sans"},
    {"liberation/LiberationSans-Regular.ttf", "Liberation Sans"},
    {"freefont/FreeSans.ttf", "FreeSans"},
    {"dejavu/DejaVuSans.ttf", "DejaVu Sans"},
}};
constexpr std::array<Substitute, 4> fixed = {{
    {"liberation2/LiberationMono-Regular.ttf", "Liberation Mono"},
    {"liberation/LiberationMono-Regular.ttf", "Liberation Mono"},
    {"freefont/FreeMono.ttf", "FreeMono"},
    {"dejavu/DejaVuSansMono.ttf", "DejaVu Sans Mono"},
}};

std::span<const Substitute> substitutes_for(const std::string& font) {
  const std::string name = fs::path(font).stem().string();
  if (name == "timrom" || name == "povlogo") return serif;
  if (name == "crystal" || name.find("ono") != name.npos) return fixed;
  if (name.find("erif") != name.npos || name.find("imes") != name.npos) return serif;
  return sans;
}

/// The whole is turned by this before anything else; the oracle does so to keep its letters from
/// lying exactly in one plane with others.
constexpr double first_turn = 0.001;

constexpr std::array<std::string_view, 1> font_suffixes = {".ttf"};

/// The fonts by number.
std::string internal_font(double number) {
  const int n = static_cast<int>(number);
  return n == 1 ? "timrom.ttf" : n == 2 ? "cyrvetic.ttf" : n == 3 ? "crystal.ttf" : "povlogo.ttf";
}

}  // namespace

/// The font of this name, or one that stands in for it.
std::shared_ptr<Font> Interpreter::open_font(const std::string& name, Span span) {
  std::shared_ptr<Font>& known = fonts_[name];
  if (known) return known;
  if (const auto path = find_file(name, span, font_suffixes)) {
    known = Font::open(*path);
    if (!known)
      fail(Code::file_not_found, span, fmt::format("`{}` holds no outlines of letters", *path));
    return known;
  }
  for (const Substitute& s : substitutes_for(name)) {
    for (const char* root : {"/usr/share/fonts/truetype", "/usr/local/share/fonts/truetype"}) {
      known = Font::open((fs::path(root) / s.file).string());
      if (!known) continue;
      warn(Code::file_found_elsewhere, span,
           fmt::format("there is no font `{}`; {} is taken instead", name, s.name),
           "letters look and run differently; add the font's folder with `+L<folder>`");
      return known;
    }
  }
  missing_file(name, span, font_suffixes);
}

/// `text { ttf "file" | internal N  "text" depth, offset }`: the union of its letters.
scene::Object Interpreter::read_text_object(std::uint32_t type, const Token& word) {
  std::string name;
  const Span font_span = peek().span;
  if (accept(w::internal)) {
    name = internal_font(read_scalar("number of a font"));
  } else if (accept(w::ttf)) {
    name = read_text(true).bytes();
  } else {
    unexpected(next(), "`ttf` or `internal`");
  }
  optional_comma();
  const Text text = read_text();
  optional_comma();
  const double depth = read_scalar("the depth");
  optional_comma();
  last_span_ = peek().span;
  const dvec3 offset = read_vector();
  const std::shared_ptr<Font> font = open_font(name, font_span);
  font->prefer_unicode(charset_ != Charset::ascii);

  scene::Object o;
  o.kind = scene::NodeKind::union_;
  o.origin = origin(word.span);
  o.transform = Transform::rotate_deg(dvec3(first_turn));
  double pen = 0;
  double rise = 0;
  unsigned left = 0;
  std::vector<scene::ObjectId> children;
  std::unordered_map<unsigned, SharedList<double>> letters;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const unsigned index = font->index_of(text[i]);
    const Font::Glyph& glyph = font->glyph(index);
    // The first letter begins at x = 0 with its left edge.
    pen += i == 0 ? -glyph.bearing : font->kerning(left, index);
    if (!glyph.outline.empty() && text[i] != u' ') {
      scene::Object letter;
      letter.type = type;
      letter.origin = o.origin;
      SharedList<double>& operands = letters[index];  // a letter is kept once
      if (operands.empty()) {
        std::vector<double> list{depth};
        list.insert(list.end(), glyph.outline.begin(), glyph.outline.end());
        operands = list;
      }
      letter.args = operands;
      letter.transform = Transform::translate({pen, rise, 0});
      children.push_back(add_object(std::move(letter)));
    }
    pen += glyph.advance + offset.x;
    rise += offset.y;
    left = index;
  }
  o.children = children;
  return o;
}

}  // namespace durer::interpreter
