// Objects that look alike share their textures: scenes of programs give a hundred thousand balls
// one of ten colours, each in a block of its own.
#include "interpreter/plain_look.h"

#include "interpreter/interpreter.h"

namespace durer::interpreter {
namespace {

PlainLook look_of(const scene::Texture& t) {
  return {t.layers[0].pigment->colour, t.layers[0].finish.identity()};
}

}  // namespace

/// Nothing but a colour and a finish.
bool Interpreter::is_plain(const scene::Texture& t) {
  return t.layers.size() == 1 && !scene::has_place(t) && t.unsupported.empty() &&
         t.layers[0].unsupported.empty() && t.layers[0].pigment->unsupported.empty() &&
         t.layers[0].normal->unsupported.empty() && !t.layers[0].pigment->uv_mapping;
}

/// Made by the object statement that ends here: if an earlier one looks the same, that is used, and
/// this one goes.
void Interpreter::share_texture(scene::TextureUse& use) {
  if (use.texture + 1U != scene_.textures.size()) return;
  const scene::Texture& own = scene_.textures[use.texture];
  if (!is_plain(own)) return;
  const PlainLook look = look_of(own);
  const scene::TextureId known = plain_textures_.find(look);
  if (known == scene::none) return plain_textures_.add(look, use.texture);
  use = {known, {}};
  scene_.textures.pop_back();
}

/// True if a colour can be laid over the texture in use; it is finished, and plain.
bool Interpreter::takes_paint(scene::TextureId texture) {
  if (texture == own_texture_) return false;  // it is in the making
  if (texture == plain_base_) return true;    // textures that are not in the making never change
  if (!is_plain(scene_.textures[texture])) return false;
  plain_base_ = texture;
  return true;
}

/// `pigment { rgb C }` on a plain texture. False, with nothing read, if this is anything else.
bool Interpreter::quick_pigment(scene::TextureUse& use) {
  if (!takes_paint(use.texture)) return false;
  const std::optional<Colour> colour = quick_colour_block();
  if (!colour) return false;
  const ast::Tree& tree = *frames_.back().tree;
  const ast::Group& block = tree.groups[tree.items[frames_.back().pos - 1].ref];
  paint(use, *colour, tree.items[block.items.first].span);
  return true;
}

/// Gives the texture in use, which takes paint, another colour; `written` is where it begins.
void Interpreter::paint(scene::TextureUse& use, const Colour& colour, Span written) {
  const Boxed<scene::Finish>& finish = scene_.textures[use.texture].layers[0].finish;
  const scene::TextureId known = plain_textures_.find({colour, finish.identity()});
  if (known != scene::none) {
    use = {known, {}};
    return;
  }
  use = {painted(use.texture, colour, written), {}};
  own_texture_ = use.texture;  // a finish may follow; share_texture comes last
}

/// A new texture: `base`, which takes paint, with another colour.
scene::TextureId Interpreter::painted(scene::TextureId base, const Colour& colour, Span written) {
  const scene::TextureId made = add_texture(scene::Texture(scene_.textures[base]));
  scene::Pigment& pigment = scene_.textures[made].layers[0].pigment.edit();
  pigment.colour = colour;
  pigment.origin = origin(written);
  return made;
}

/// Colour and finish at once, on the default texture, which takes paint, with nothing to follow. True if
/// the texture is that of another object.
bool Interpreter::dress(scene::TextureUse& use, const Colour& colour,
                        const Boxed<scene::Finish>& finish, Span written) {
  const PlainLook look{colour, finish.identity()};
  const scene::TextureId known = plain_textures_.find(look);
  use = {known != scene::none ? known : painted(default_texture_, colour, written), {}};
  if (known != scene::none) return true;
  scene_.textures[use.texture].layers[0].finish = finish;
  plain_textures_.add(look, use.texture);
  return false;
}

/// Gives the texture in use, the default if there is none, another finish.
void Interpreter::give_finish(scene::TextureUse& use, const Boxed<scene::Finish>& finish) {
  if (use.texture == scene::none) use = {default_texture_, {}};
  if (use.texture == own_texture_ && use.transform.is_identity()) {
    scene_.textures[own_texture_].layers[0].finish = finish;
  } else {
    change_texture(use, [&](scene::Texture& t) { t.layers[0].finish = finish; });
  }
}

}  // namespace durer::interpreter
