// Textures, pigments and maps (textures §11, §14, §16).
#include <cmath>

#include <fmt/format.h>

#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;

// ---- textures
// -------------------------------------------------------------------------------------

scene::TextureId Interpreter::add_texture(scene::Texture texture) {
  scene_.textures.push_back(std::move(texture));
  return static_cast<scene::TextureId>(scene_.textures.size() - 1);
}

void Interpreter::transform_texture(scene::Texture& texture, const Transform& t) {
  for (scene::Layer& layer : texture.layers) {
    if (layer.pigment->uv_mapping) continue;  // it lies on the surface (textures §11.7)
    layer.pigment.edit().transform = layer.pigment->transform.then(t);
  }
}

/// A copy of the texture in use, with its transform settled into the layers.
scene::Texture Interpreter::materialize(const scene::TextureUse& use) {
  scene::Texture t = scene_.textures[use.texture];
  if (!use.transform.is_identity()) transform_texture(t, use.transform);
  return t;
}

/// Puts the layers of a texture on top of those in use (textures §14.2).
void Interpreter::add_layers(scene::TextureUse& use, scene::TextureId added) {
  if (use.texture == scene::none) {
    use = {added, {}};
    return;
  }
  scene::Texture t = materialize(use);
  const scene::Texture& top = scene_.textures[added];
  t.layers.insert(t.layers.end(), top.layers.begin(), top.layers.end());
  if (t.unsupported.empty()) t.unsupported = top.unsupported;
  use = {add_texture(std::move(t)), {}};
}

/// `pigment`, `finish` or `normal` right in an object: changes the top layer of its texture, which
/// is a copy of the default if there is none.
void Interpreter::edit_texture(scene::TextureUse& use, const Token& word) {
  if (use.texture == scene::none) use = {default_texture_, {}};
  scene::Texture t;
  const bool own = use.texture == own_texture_ && own_texture_ != scene::none;
  if (own) {
    // Made by this very statement: nobody else has seen it, so it can be changed in place.
    t = std::move(scene_.textures[use.texture]);
    if (!use.transform.is_identity()) transform_texture(t, use.transform);
  } else {
    t = materialize(use);
  }
  edit_layer(t.layers.back(), word);
  if (own) {
    scene_.textures[use.texture] = std::move(t);
    use.transform = {};
  } else {
    use = {add_texture(std::move(t)), {}};
    own_texture_ = use.texture;
  }
}

void Interpreter::edit_layer(scene::Layer& layer, const Token& word) {
  switch (word.word) {
    case w::pigment: layer.pigment = read_pigment(*layer.pigment); return;
    case w::finish: layer.finish = read_finish(*layer.finish); return;
    default: {
      // A normal without any bumps changes nothing; every other one has to wait.
      expect_open("normal");
      if (peek().kind != Token::Kind::close) layer.unsupported = "`normal`";
      skip_block();
      return;
    }
  }
}

namespace {
bool starts_patterned_texture(SymbolId word) {
  switch (word) {
    case w::tiles:
    case w::material_map:
    case w::uv_mapping:
    case w::texture_map: return true;
    default: return false;
  }
}
}  // namespace

/// After the word `texture`: `{ … }`.
scene::TextureId Interpreter::read_texture(std::string_view block) {
  expect_open(block);
  const Token first = peek();
  if (const Value* v =
          first.kind == Token::Kind::expr ? lookup(*first.tree, first.expr, false) : nullptr;
      v != nullptr && v->get<TextureRef>() != nullptr) {
    const scene::TextureId id = v->get<TextureRef>()->id;
    next();
    if (raw_next().kind == Token::Kind::close) {
      next();
      return id;
    }
    return read_texture_body(scene_.textures[id], first.span);
  }
  scene::Texture t = scene_.textures[default_texture_];
  t.origin = origin(first.span);
  return read_texture_body(std::move(t), first.span);
}

scene::TextureId Interpreter::read_texture_body(scene::Texture t, Span span) {
  for (;;) {
    const Token token = next();
    if (token.kind == Token::Kind::close) break;
    if (token.is_punct(';')) continue;
    if (token.kind == Token::Kind::expr) {
      // Identifiers replace a part: `texture { MyPigment MyFinish }`.
      const Value* v = lookup(*token.tree, token.expr, false);
      scene::Layer& top = t.layers.back();
      if (v != nullptr && v->get<Shared<scene::Pigment>>() != nullptr) {
        top.pigment = Boxed(*v->get<Shared<scene::Pigment>>());
      } else if (v != nullptr && v->get<Shared<scene::Finish>>() != nullptr) {
        top.finish = Boxed(*v->get<Shared<scene::Finish>>());
      } else if (v != nullptr && v->get<Shared<Unsupported>>() != nullptr) {
        if (top.unsupported.empty()) top.unsupported = (*v->get<Shared<Unsupported>>())->feature;
      } else {
        bad_setting(token, "texture", span,
                    "pigment normal finish translate rotate scale matrix transform");
      }
      continue;
    }
    if (token.kind != Token::Kind::word)
      unexpected(token, "a pigment, normal, finish or transformation in `texture`");
    if (const auto transform = read_transformation(token)) {
      transform_texture(t, *transform);
      continue;
    }
    switch (token.word) {
      case w::pigment:
      case w::finish:
      case w::normal: edit_layer(t.layers.back(), token); continue;
      case w::no_bump_scale: continue;  // about normals, which bring their own error
      default: break;
    }
    if (starts_patterned_texture(token.word) || is_pattern_word(token.word)) {
      if (t.unsupported.empty()) {
        t.unsupported = fmt::format("a texture patterned by `{}`", name_of(token.word));
      }
      t.origin = origin(token.span);
      skip_block();
      break;
    }
    bad_setting(token, "texture", span,
                "pigment normal finish translate rotate scale matrix transform");
  }
  return add_texture(std::move(t));
}

// ---- pigments (textures §3, §11, §16)
// -----------------------------------------------------------------

bool Interpreter::is_pattern_word(SymbolId word) const {
  if (pattern_words_.contains(word)) return true;
  switch (word) {
    case w::agate:
    case w::aoi:
    case w::average:
    case w::boxed:
    case w::bozo:
    case w::brick:
    case w::bumps:
    case w::cells:
    case w::checker:
    case w::crackle:
    case w::cubic:
    case w::cylindrical:
    case w::density_file:
    case w::dents:
    case w::facets:
    case w::function:
    case w::gradient:
    case w::granite:
    case w::hexagon:
    case w::image_map:
    case w::image_pattern:
    case w::julia:
    case w::leopard:
    case w::magnet:
    case w::mandel:
    case w::marble:
    case w::object:
    case w::onion:
    case w::pavement:
    case w::pigment_pattern:
    case w::planar:
    case w::quilted:
    case w::radial:
    case w::ripples:
    case w::slope:
    case w::spherical:
    case w::spiral1:
    case w::spiral2:
    case w::spotted:
    case w::square:
    case w::tiling:
    case w::triangular:
    case w::uv_mapping:
    case w::waves:
    case w::wood:
    case w::wrinkles:
    case w::bump_map: return true;
    default: return false;
  }
}

namespace {
constexpr std::string_view pigment_settings =
    "color rgb rgbf rgbt rgbft checker brick hexagon gradient agate bozo bumps cells crackle "
    "cylindrical dents granite leopard marble onion planar quilted radial ripples spherical "
    "spotted "
    "waves wood wrinkles image_map color_map pigment_map turbulence frequency phase warp "
    "translate rotate scale matrix transform quick_color";
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
      return;
    }
    if (t.is_punct(';')) {
      next();
      continue;
    }
    if (t.kind == Token::Kind::expr && first) {
      const Value* v = lookup(*t.tree, t.expr, false);
      if (v != nullptr && v->get<Shared<scene::Pigment>>() != nullptr) {
        const scene::OriginId at = p.origin;
        p = **v->get<Shared<scene::Pigment>>();
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
      p.pattern = scene::none;
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
    if (const auto it = pattern_words_.find(t.word); it != pattern_words_.end()) {
      start_pattern(p, it->second, t);
      continue;
    }
    if (pigment_modifier(p, t)) continue;
    if (is_pattern_word(t.word) || is_warp_word(t.word)) {
      p.unsupported = fmt::format("`{}`", name_of(t.word));
      p.origin = origin(t.span);
      skip_to(last);
      return;
    }
    bad_setting(t, "pigment", {}, pigment_settings);
  }
}

bool Interpreter::is_warp_word(SymbolId word) const {
  switch (word) {
    case w::turbulence:
    case w::octaves:
    case w::omega:
    case w::lambda:
    case w::warp:
    case w::noise_generator: return true;
    default: return false;
  }
}

/// Skips the rest of a block, its closing mark included.
void Interpreter::skip_to(Token::Kind last) {
  for (int depth = 0;;) {
    const Token t = next();
    if (t.kind == last && depth == 0) return;
    if (t.kind == Token::Kind::open || t.kind == Token::Kind::bracket_open) ++depth;
    if (t.kind == Token::Kind::close || t.kind == Token::Kind::bracket_close) --depth;
    if (t.kind == Token::Kind::end) unexpected(t, "the end of this block");
  }
}

void Interpreter::start_pattern(scene::Pigment& p, std::uint32_t index, const Token& word) {
  const scene::PatternInfo& info = *registry_.patterns[index];
  p.pattern = index;
  p.unsupported.clear();
  p.entries.clear();
  p.children.clear();
  p.colour = {};
  if (info.list_size > 0) {
    p.frequency = 0;  // block values select, they are not wrapped (textures §3)
  } else if (info.wave != scene::Wave::ramp) {
    p.wave = info.wave;
  }
  if (info.list_size > 0) read_colour_list(p, info);
  p.args = read_operands(info, word);
  p.function = info.takes_function ? read_scene_function() : nullptr;
  if (info.list_size == 0) {
    for (const scene::MapEntry& e : info.default_map)
      p.entries.push_back({e.key, e.colour, scene::none});
  }
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
  if (const auto transform = read_transformation(t)) {
    p.transform = p.transform.then(*transform);
    return true;
  }
  switch (t.word) {
    case w::frequency: p.frequency = static_cast<float>(read_float()); return true;
    case w::phase: p.phase = static_cast<float>(read_float()); return true;
    case w::ramp_wave: p.wave = scene::Wave::ramp; return true;
    case w::sine_wave: p.wave = scene::Wave::sine; return true;
    case w::triangle_wave: p.wave = scene::Wave::triangle; return true;
    case w::scallop_wave: p.wave = scene::Wave::scallop; return true;
    case w::cubic_wave: p.wave = scene::Wave::cubic; return true;
    case w::poly_wave:
      p.wave = scene::Wave::poly;
      if (starts_number(peek())) p.wave_exponent = static_cast<float>(read_float());
      return true;
    case w::quick_color:
    case w::quick_colour:
      read_colour();  // shown at quality 5 and below only
      return true;
    case w::color_map:
    case w::colour_map:
    case w::pigment_map: {
      const bool block = p.pattern != scene::none && registry_.patterns[p.pattern]->list_size > 0;
      if (block || (p.pattern == scene::none && p.unsupported.empty())) {
        fail(Code::unexpected_item, t.span,
             block
                 ? fmt::format("`{}` takes a list, not a map", registry_.patterns[p.pattern]->name)
                 : fmt::format("`{}` needs a pattern before it", name_of(t.word)));
      }
      ColourMap map = t.word == w::pigment_map ? read_pigment_map() : read_colour_map();
      p.entries = std::move(map.entries);
      p.children = std::move(map.children);
      return true;
    }
    default: return false;
  }
}

/// `color_map { [key colour] … }` or `color_map { Identifier }` (textures §11.2).
ColourMap Interpreter::read_colour_map() {
  expect_open("color_map");
  ColourMap map;
  if (const Token t = peek(); t.kind == Token::Kind::expr) {
    const Value* v = lookup(*t.tree, t.expr, true);
    const auto* ref = v == nullptr ? nullptr : v->get<Shared<ColourMap>>();
    if (ref == nullptr) unexpected(t, "a colour map or `[`");
    next();
    map = **ref;
  }
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) break;
    if (t.kind != Token::Kind::bracket_open) unexpected(t, "`[` or `}` in `color_map`");
    scene::PigmentEntry entry;
    entry.key = static_cast<float>(read_scalar("key"));
    optional_comma();
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
  }
  check_map(map);
  return map;
}

void Interpreter::check_map(const ColourMap& map) {
  if (map.entries.empty())
    fail(Code::missing_argument, peek().span, "a map needs at least one entry");
  if (map.entries.size() > 256) fail(Code::limit, peek().span, "a map has at most 256 entries");
}

ColourMap Interpreter::read_pigment_map() {
  expect_open("pigment_map");
  ColourMap map;
  if (const Token t = peek(); t.kind == Token::Kind::expr) {
    const Value* v = lookup(*t.tree, t.expr, true);
    const auto* ref = v == nullptr ? nullptr : v->get<Shared<ColourMap>>();
    if (ref == nullptr) unexpected(t, "a pigment map or `[`");
    next();
    map = **ref;
  }
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) break;
    if (t.kind != Token::Kind::bracket_open) unexpected(t, "`[` or `}` in `pigment_map`");
    scene::PigmentEntry entry;
    entry.key = static_cast<float>(read_scalar("key"));
    optional_comma();
    scene::Pigment child = *scene_.textures[default_texture_].layers.back().pigment;
    child.origin = origin(t.span);
    read_pigment_body(child, Token::Kind::bracket_close);
    entry.pigment = static_cast<std::uint32_t>(map.children.size());
    map.children.push_back(std::move(child));
    map.entries.push_back(entry);
  }
  check_map(map);
  return map;
}

}  // namespace durer::interpreter
