// Textures, pigments and maps (textures §11, §14, §16).
#include <cmath>

#include <fmt/format.h>

#include "interpreter/maps.h"

namespace durer::interpreter {

namespace w = grammar::words;

// ---- textures
// -------------------------------------------------------------------------------------

scene::TextureId Interpreter::add_texture(scene::Texture texture) {
  scene_.textures.push_back(std::move(texture));
  return static_cast<scene::TextureId>(scene_.textures.size() - 1);
}

void Interpreter::transform_texture(scene::Texture& texture, const Transform& t) {
  if (texture.patterned()) {
    // The pattern moves, and the textures in it with it: they are looked up where it points.
    if (!texture.uv_mapping) {
      scene::Pattern& pattern = texture.pattern.edit();
      pattern.transform = pattern.transform.then(t);
    }
    return;
  }
  for (scene::Layer& layer : texture.layers) {
    if (layer.normal->pattern->exists() && !layer.normal->uv_mapping) {
      scene::Pattern& bumps = layer.normal.edit().pattern.edit();
      bumps.transform = bumps.transform.then(t);
    }
    if (layer.pigment->uv_mapping) continue;  // it lies on the surface (textures §11.7)
    scene::Pattern& pattern = layer.pigment.edit().pattern.edit();
    pattern.transform = pattern.transform.then(t);
  }
}

/// A copy of the texture in use, with its transform settled into the layers.
scene::Texture Interpreter::materialize(const scene::TextureUse& use) {
  scene::Texture t = scene_.textures[use.texture];
  if (!use.transform.is_identity()) transform_texture(t, use.transform);
  return t;
}

namespace {

// Before version 3.5, layers that lie on others do not tint what they let through (textures §14.2).
void filter_as_transmit(Colour& c) {
  c.transmit += c.filter;
  c.filter = 0;
}
void filter_as_transmit(scene::Pigment& p) {
  filter_as_transmit(p.colour);
  for (scene::PigmentEntry& e : p.entries) filter_as_transmit(e.colour);
  for (scene::Pigment& child : p.children) filter_as_transmit(child);
}

}  // namespace

/// Puts the layers of a texture on top of those in use (textures §14.2).
void Interpreter::add_layers(scene::TextureUse& use, scene::TextureId added) {
  if (use.texture == scene::none) {
    use = {added, {}};
    return;
  }
  scene::Texture t = materialize(use);
  const scene::Texture& top = scene_.textures[added];
  if (t.patterned() || top.patterned()) {
    fail(Code::unexpected_item, scene_.origins[top.origin].span,
         "a texture that is chosen by a pattern cannot be a layer of others");
  }
  const std::size_t lower = t.layers.size();
  t.layers.insert(t.layers.end(), top.layers.begin(), top.layers.end());
  if (version() <= 310) {
    for (std::size_t i = lower; i < t.layers.size(); ++i) {
      filter_as_transmit(t.layers[i].pigment.edit());
    }
  }
  if (t.unsupported.empty()) t.unsupported = top.unsupported;
  use = {add_texture(std::move(t)), {}};
}

/// `pigment`, `finish` or `normal` right in an object: changes the top layer of its texture, which
/// is a copy of the default if there is none.
void Interpreter::edit_texture(scene::TextureUse& use, const Token& word) {
  if (use.texture == scene::none) use = {default_texture_, {}};
  if (word.is(w::pigment) && quick_pigment(use)) return;
  change_texture(use, [&](scene::Texture& t) { edit_layer(top_layer(t, word.span), word); });
}

void Interpreter::edit_layer(scene::Layer& layer, const Token& word) {
  switch (word.word) {
    case w::pigment: layer.pigment = read_pigment(*layer.pigment); return;
    case w::finish: layer.finish = read_shared_finish(layer.finish); return;
    default: layer.normal = read_normal(*layer.normal); return;
  }
}

/// The layer that settings right in the texture change.
scene::Layer& Interpreter::top_layer(scene::Texture& texture, Span span) {
  if (texture.patterned()) {
    fail(Code::unexpected_item, span, "this texture is chosen by a pattern and has no layers",
         "change the textures that it is made of");
  }
  return texture.layers.back();
}

/// `no_bump_scale` goes for everything in a texture.
void Interpreter::keep_bump_scale(scene::Texture& texture) {
  texture.no_bump_scale = texture.patterned();
  for (scene::TextureEntry& entry : texture.entries) {
    scene::Texture part = scene_.textures[entry.texture];
    keep_bump_scale(part);
    entry.texture = add_texture(std::move(part));
  }
  for (scene::Layer& layer : texture.layers) {
    if (layer.normal->pattern->exists()) keep_bump_scale(layer.normal.edit());
  }
}

/// After the word `texture`: `{ … }`.
scene::TextureId Interpreter::read_texture(std::string_view block) {
  expect_open(block);
  return read_texture_body(Token::Kind::close);
}

/// Reads up to and including the closing mark `last`. A name alone stands for the texture itself.
scene::TextureId Interpreter::read_texture_body(Token::Kind last) {
  const Token first = peek();
  const Value* v =
      first.kind == Token::Kind::expr ? lookup(*first.tree, first.expr, false) : nullptr;
  const TextureRef* ref = v == nullptr ? nullptr : v->get<TextureRef>();
  scene::Texture t = scene_.textures[ref == nullptr ? default_texture_ : ref->id];
  if (ref == nullptr) {
    t.origin = origin(first.span);
  } else {
    const scene::TextureId id = ref->id;
    next();
    if (raw_next().kind == last) {
      next();
      return id;
    }
  }
  read_texture_items(t, first.span, last);
  return add_texture(std::move(t));
}

namespace {
constexpr std::string_view texture_settings =
    "pigment normal finish texture_map tiles uv_mapping no_bump_scale translate rotate scale "
    "matrix transform";
}  // namespace

void Interpreter::read_texture_items(scene::Texture& t, Span span, Token::Kind last) {
  bool keep_scale = false;
  for (;;) {
    const Token token = next();
    if (token.kind == last) break;
    if (token.is_punct(';')) continue;
    if (token.kind == Token::Kind::expr) {
      read_texture_part(t, token, span);
      continue;
    }
    if (token.kind != Token::Kind::word) {
      unexpected(token, "a pigment, normal, finish or transformation in `texture`");
    }
    if (const auto transform = read_transformation(token)) {
      transform_texture(t, *transform);
      continue;
    }
    switch (token.word) {
      case w::pigment:
      case w::finish:
      case w::normal: edit_layer(top_layer(t, token.span), token); continue;
      case w::no_bump_scale: keep_scale = read_switch(true); continue;
      case w::tiles: read_tiles(t, token.span); continue;
      default: break;
    }
    const bool known = pattern_words_.contains(token.word) || token.word == w::uv_mapping;
    if (!known && !is_pattern_word(token.word)) {
      bad_setting(token, "texture", span, texture_settings);
    }
    t.origin = origin(token.span);
    if (known) {
      read_pattern_texture(t, token, last);
    } else {
      t.unsupported = fmt::format("a texture patterned by `{}`", name_of(token.word));
      skip_to(last);
    }
    break;
  }
  if (keep_scale) keep_bump_scale(t);
}

/// Identifiers replace a part: `texture { MyPigment MyFinish }`.
void Interpreter::read_texture_part(scene::Texture& t, const Token& token, Span span) {
  const Value* v = lookup(*token.tree, token.expr, false);
  scene::Layer& top = top_layer(t, token.span);
  if (v != nullptr && v->get<Boxed<scene::Pigment>>() != nullptr) {
    top.pigment = *v->get<Boxed<scene::Pigment>>();
  } else if (v != nullptr && v->get<Boxed<scene::Normal>>() != nullptr) {
    top.normal = *v->get<Boxed<scene::Normal>>();
  } else if (v != nullptr && v->get<Boxed<scene::Finish>>() != nullptr) {
    top.finish = *v->get<Boxed<scene::Finish>>();
  } else if (v != nullptr && v->get<Shared<Unsupported>>() != nullptr) {
    if (top.unsupported.empty()) top.unsupported = (*v->get<Shared<Unsupported>>())->feature;
  } else {
    bad_setting(token, "texture", span, texture_settings);
  }
}

// ---- textures that a pattern chooses (textures §11, §14.1)

/// After the word of a pattern, or `uv_mapping`: a list or map and modifiers, up to and including
/// the closing mark `last`.
void Interpreter::read_pattern_texture(scene::Texture& t, const Token& word, Token::Kind last) {
  t.layers.clear();
  t.pattern = {};
  t.entries.clear();
  if (word.word == w::uv_mapping) {
    t.uv_mapping = true;
    t.entries.push_back({0, read_texture_body(last)});
    return;
  }
  scene::Pattern pattern;
  const std::uint32_t index = pattern_words_.find(word.word)->second;
  const scene::PatternInfo& info = *registry_.patterns[index];
  choose_pattern(pattern, index);
  if (info.only_normal || info.only_pigment) bad_setting(word, "texture", {}, texture_settings);
  if (info.list_size > 0) {
    open_list(pattern, word);
    read_texture_list(t, info.list_size);
    close_list(pattern, word);
  }
  read_pattern_operands(pattern, word);
  if (info.only_texture) read_materials(t, pattern, word.span);
  bool keep_scale = false;
  for (Token token = next(); token.kind != last; token = next()) {
    if (token.kind != Token::Kind::word) {
      unexpected(token, fmt::format("a modifier or `texture_map` after `{}`", info.name));
    }
    if (token.word == w::texture_map) {
      if (info.list_size > 0 || info.only_texture) bad_map(token, &info);
      t.entries = read_texture_map(info.averages).entries;
    } else if (token.word == w::no_bump_scale) {
      keep_scale = read_switch(true);
    } else if (!pattern_modifier(pattern, token)) {
      bad_setting(token, "texture", word.span,
                  "texture_map turbulence frequency phase warp translate rotate scale matrix "
                  "transform");
    }
  }
  check_pattern(pattern, false, {});
  t.pattern = std::move(pattern);
  if (t.entries.empty()) {
    fail(Code::missing_argument, word.span,
         fmt::format("a texture that is chosen by `{}` needs a `texture_map`", info.name));
  }
  if (keep_scale) keep_bump_scale(t);
}

/// `texture {…} texture {…}` after a block pattern; missing ones are the default.
void Interpreter::read_texture_list(scene::Texture& t, int size) {
  for (int i = 0; i < size; ++i) {
    const bool here = accept(w::texture);
    t.entries.push_back({static_cast<float>(i), here ? read_texture("texture") : default_texture_});
    if (here) optional_comma();
  }
}

/// `texture {…} …` up to the end of a `material_map`: one for every number.
void Interpreter::read_materials(scene::Texture& t, scene::Pattern& pattern, Span span) {
  while (accept(w::texture)) {
    t.entries.push_back({static_cast<float>(t.entries.size()), read_texture("texture")});
    optional_comma();
  }
  expect_close("material_map", span);
  if (t.entries.empty()) {
    fail(Code::missing_argument, span, "a `material_map` needs at least one `texture`");
  }
  pattern.args = {static_cast<double>(t.entries.size())};
}

/// `tiles { texture {…} tile2 texture {…} }`, an old checker that begins with the other one.
void Interpreter::read_tiles(scene::Texture& t, Span span) {
  const auto checker = pattern_words_.find(w::checker);
  if (checker == pattern_words_.end()) not_supported("`tiles`", span);
  expect_open("tiles");
  const auto tile = [&] {
    if (!accept(w::texture)) unexpected(peek(), "`texture` in `tiles`");
    return read_texture("texture");
  };
  const scene::TextureId first = tile();
  if (!accept(w::tile2)) unexpected(peek(), "`tile2` and the other texture");
  const scene::TextureId second = tile();
  expect_close("tiles", span);
  scene::Pattern pattern;
  choose_pattern(pattern, checker->second);
  t.layers.clear();
  t.pattern = std::move(pattern);
  t.entries = {{0, second}, {1, first}};
}

/// `texture_map { [key texture] … }` or `texture_map { Identifier }`.
TextureMap Interpreter::read_texture_map(bool weights) {
  TextureMap map;
  read_map("texture_map", map, weights, [&](float key) {
    map.entries.push_back({key, read_texture_body(Token::Kind::bracket_close)});
  });
  return map;
}

}  // namespace durer::interpreter
