// Pigments and their maps (textures §11, §16).
#include <algorithm>

#include <fmt/format.h>

#include "interpreter/maps.h"

namespace durer::interpreter {

namespace w = grammar::words;

namespace {
constexpr std::string_view pigment_settings =
    "color rgb rgbf rgbt rgbft checker brick hexagon gradient agate bozo bumps cells crackle "
    "cylindrical dents granite leopard marble onion planar quilted radial ripples spherical "
    "spotted "
    "waves wood wrinkles image_map color_map pigment_map turbulence frequency phase warp "
    "translate rotate scale matrix transform quick_color";
}  // namespace

namespace {

// The default colours of the Mandelbrot set are not for its relatives of other exponents
// (textures §11.4).
void settle_fractal_colours(scene::Pigment& p, const scene::Registry& registry) {
  if (!p.pattern->exists()) return;
  const scene::PatternInfo& info = *registry.patterns[p.pattern->type];
  const auto same = [](const scene::PigmentEntry& a, const scene::MapEntry& b) {
    return a.key == b.key && a.colour == b.colour && a.pigment == scene::none;
  };
  if (info.name != "mandel" || p.pattern->args[1] == 2 ||
      !std::equal(p.entries.begin(), p.entries.end(), info.default_map.begin(),
                  info.default_map.end(), same)) {
    return;
  }
  p.entries = {{0, {}, scene::none}, {1, Colour{vec3(1.0F), 0, 0}, scene::none}};
}

}  // namespace

scene::Pigment Interpreter::read_pigment(scene::Pigment start) {
  expect_open("pigment");
  start.origin = origin(peek().span);
  read_pigment_body(start, Token::Kind::close);
  return start;
}

/// Reads up to and including the closing mark `last`.
void Interpreter::read_pigment_body(scene::Pigment& p, Token::Kind last) {
  for (bool first = true;; first = false) {
    const Token t = peek();
    if (t.kind == last) {
      next();
      check_pattern(*p.pattern, p.entries.empty(), "pigment_map");
      settle_fractal_colours(p, registry_);
      return;
    }
    if (t.is_punct(';')) {
      next();
      continue;
    }
    if (t.kind == Token::Kind::expr && first) {
      const Value* v = lookup(*t.tree, t.expr, false);
      if (v != nullptr && v->get<Boxed<scene::Pigment>>() != nullptr) {
        const scene::OriginId at = p.origin;
        p = **v->get<Boxed<scene::Pigment>>();
        if (p.unsupported.empty()) p.origin = at;
        next();
        continue;
      }
      if (v != nullptr && v->get<Shared<Unsupported>>() != nullptr) {
        p.unsupported = (*v->get<Shared<Unsupported>>())->feature;
        next();
        continue;
      }
    }
    if (const auto* name = t.node<ast::Name>();
        name != nullptr && !symbols_.reserved(name->name) && env_.find(name->name) == nullptr) {
      bad_setting(t, "pigment", {}, pigment_settings);
    }
    if (starts_colour(t) || t.kind == Token::Kind::expr || t.is_punct('-')) {
      p.colour = read_colour_num(t.kind != Token::Kind::word).colour();
      p.pattern.edit().type = scene::none;
      p.entries.clear();
      p.children.clear();
      p.unsupported.clear();
      continue;
    }
    if (t.kind != Token::Kind::word) unexpected(t, "a colour, pattern or modifier in `pigment`");
    next();
    if (t.word == w::uv_mapping) {
      // What follows is looked up on the surface, and nothing is left of what stood before.
      p = {};
      p.origin = origin(t.span);
      read_pigment_body(p, last);
      p.uv_mapping = true;
      return;
    }
    if (const auto it = pattern_words_.find(t.word);
        it != pattern_words_.end() && !registry_.patterns[it->second]->only_normal &&
        !registry_.patterns[it->second]->only_texture) {
      start_pigment_pattern(p, it->second, t);
      continue;
    }
    if (pigment_modifier(p, t)) continue;
    if (is_pattern_word(t.word)) {
      p.unsupported = fmt::format("`{}`", name_of(t.word));
      p.origin = origin(t.span);
      skip_to(last);
      return;
    }
    bad_setting(t, "pigment", {}, pigment_settings);
  }
}

void Interpreter::start_pigment_pattern(scene::Pigment& p, std::uint32_t index, const Token& word) {
  const scene::PatternInfo& info = *registry_.patterns[index];
  p.unsupported.clear();
  p.entries.clear();
  p.children.clear();
  p.colour = {};
  choose_pattern(p.pattern.edit(), index);
  if (info.list_size > 0) {
    open_list(p.pattern.edit(), word);
    read_colour_list(p, info);
    close_list(p.pattern.edit(), word);
  } else {
    for (const scene::MapEntry& e : info.default_map)
      p.entries.push_back({e.key, e.colour, scene::none});
  }
  read_pattern_operands(p.pattern.edit(), word);
}

/// `checker Red, White` or `checker pigment {…} pigment {…}`: up to `list_size` entries, the rest
/// from the default list (textures §11.5).
void Interpreter::read_colour_list(scene::Pigment& p, const scene::PatternInfo& info) {
  const bool pigments = peek().is(w::pigment);
  for (int i = 0; i < info.list_size; ++i) {
    scene::PigmentEntry entry;
    entry.key = static_cast<float>(i);
    const Token t = peek();
    if (pigments) {
      entry.pigment = static_cast<std::uint32_t>(p.children.size());
      if (t.is(w::pigment)) {
        next();
        scene::Pigment child =
            read_pigment(*scene_.textures[default_texture_].layers.back().pigment);
        p.children.push_back(std::move(child));
        optional_comma();
      } else {
        p.children.push_back(*scene_.textures[default_texture_].layers.back().pigment);
      }
    } else if (starts_colour(t) || t.kind == Token::Kind::expr) {
      entry.colour = read_colour();
      optional_comma();
    } else if (static_cast<std::size_t>(i) < info.default_map.size()) {
      entry.colour = info.default_map[static_cast<std::size_t>(i)].colour;
    }
    p.entries.push_back(entry);
  }
}

bool Interpreter::pigment_modifier(scene::Pigment& p, const Token& t) {
  if (pattern_modifier(p.pattern.edit(), t)) return true;
  switch (t.word) {
    case w::quick_color:
    case w::quick_colour:
      p.quick_colour = read_colour();
      return true;
    case w::color_map:
    case w::colour_map:
    case w::pigment_map: {
      const scene::PatternInfo* const info =
          p.pattern->exists() ? registry_.patterns[p.pattern->type] : nullptr;
      const bool colours = t.word != w::pigment_map;
      if ((info == nullptr && p.unsupported.empty()) ||
          (info != nullptr && (info->list_size > 0 || info->only_pigment || (colours && info->averages)))) {
        bad_map(t, info);
      }
      ColourMap map = colours ? read_colour_map()
                              : read_pigment_map(info != nullptr && info->averages);
      p.entries = std::move(map.entries);
      p.children = std::move(map.children);
      return true;
    }
    default: return false;
  }
}

/// `color_map { [key colour] … }` or `color_map { Identifier }` (textures §11.2).
ColourMap Interpreter::read_colour_map() {
  ColourMap map;
  read_map("color_map", map, false, [&](float key) {
    scene::PigmentEntry entry;
    entry.key = key;
    const Token c = peek();
    if (c.kind == Token::Kind::expr) {
      const Num n = read_full(1);
      if (n.length == 1) {  // the old form: [key1, key2 color A color B]
        scene::PigmentEntry second;
        second.key = static_cast<float>(n.v[0]);
        optional_comma();
        entry.colour = read_colour();
        optional_comma();
        second.colour = read_colour();
        map.entries.push_back(entry);
        entry = second;
      } else if (n.length == 5) {
        Num colour = n;
        continue_colour(colour);
        entry.colour = colour.colour();
      } else {
        fail(Code::wrong_kind, c.span, "expected a colour, found a vector",
             "write `rgb` before it");
      }
    } else if (starts_colour(c)) {
      entry.colour = read_colour();
    } else {
      unexpected(c, "a colour");
    }
    map.entries.push_back(entry);
    const Token close = next();
    if (close.kind != Token::Kind::bracket_close) unexpected(close, "`]`");
  });
  return map;
}

/// `pigment_map { [key pigment] … }` or `pigment_map { Identifier }`.
ColourMap Interpreter::read_pigment_map(bool weights) {
  ColourMap map;
  read_map("pigment_map", map, weights, [&](float key) {
    scene::Pigment child = *scene_.textures[default_texture_].layers.back().pigment;
    child.origin = origin(last_span_);
    read_pigment_body(child, Token::Kind::bracket_close);
    map.entries.push_back({key, {}, static_cast<std::uint32_t>(map.children.size())});
    map.children.push_back(std::move(child));
  });
  return map;
}

}  // namespace durer::interpreter
