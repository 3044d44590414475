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
    scene::Pattern& pattern = layer.pigment.edit().pattern;
    pattern.transform = pattern.transform.then(t);
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

}  // namespace durer::interpreter
