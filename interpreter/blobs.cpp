// `blob` (objects §10.6): components, each with transformations and a texture of its own.
#include <fmt/format.h>

#include <glm/geometric.hpp>

#include "interpreter/object_reader.h"

namespace durer::interpreter {

namespace w = grammar::words;

void BlobMove::then(const Token& word, const Transform& step) {
  const Affine& m = step.forward;
  const bool even = m.x.x == m.y.y && m.y.y == m.z.z;
  stays_ball = stays_ball &&
               (word.is(w::translate) || word.is(w::rotate) || (word.is(w::scale) && even));
  if (!stays_ball) {
    rest = rest.then(step);
    return;
  }
  kept = kept.then(step);
  if (word.is(w::scale)) growth *= m.x.x;
}

/// `blob { threshold T  sphere {…} cylinder {…} component … }`. Operands: the threshold; then for
/// each component its kind (1: a rod, + 2: moved), one or two points, radius, strength, which of
/// the object's part_textures it shows, and the 12 numbers of its matrix if it is moved.
void ObjectReader::blob() {
  args_.assign(1, 1.0);
  for (;;) {
    if (accept(w::threshold)) {
      args_[0] = number("the threshold");
    } else if (accept(w::sphere)) {
      blob_component(false);
    } else if (accept(w::cylinder)) {
      blob_component(true);
    } else if (accept(w::component)) {
      const double strength = number("strength");
      const double radius = number("radius");
      args_.push_back(0);
      vector();
      args_.insert(args_.end(), {radius, strength, static_cast<double>(scene::none)});
    } else {
      return;
    }
  }
}

/// `{ centre [, end], radius, [strength] s … }`.
void ObjectReader::blob_component(bool rod) {
  in_.expect_open(rod ? "cylinder" : "sphere");
  const std::size_t start = args_.size();
  args_.push_back(rod ? 1 : 0);
  vector();
  if (rod) {
    vector();
    const double* p = &args_[start + 1];
    if (glm::distance(dvec3(p[0], p[1], p[2]), dvec3(p[3], p[4], p[5])) < epsilon) {
      in_.fail(Code::degenerate, in_.last_span_, "a cylinder's ends must not be one point");
    }
  }
  args_.push_back(number("radius"));
  accept(w::strength);
  args_.push_back(number("strength"));
  const std::size_t texture_at = args_.size();
  args_.push_back(scene::none);
  BlobMove move;
  move.stays_ball = !rod;
  scene::TextureUse texture;
  blob_modifiers(move, texture);
  if (texture.texture != scene::none) {
    std::vector<scene::TextureId>& parts = object_.extras.edit().part_textures;
    args_[texture_at] = static_cast<double>(parts.size());
    parts.push_back(texture.transform.is_identity() ? texture.texture
                                                    : in_.add_texture(in_.materialize(texture)));
  }
  in_.own_texture_ = scene::none;
  if (!rod) {
    double* ball = &args_[start + 1];  // centre, radius
    const dvec3 centre = move.kept.point({ball[0], ball[1], ball[2]});
    ball[0] = centre.x, ball[1] = centre.y, ball[2] = centre.z;
    ball[3] *= move.growth;
  }
  if (move.rest.is_identity()) return;
  args_[start] += 2;
  const Affine& m = move.rest.forward;
  for (const dvec3 row : {m.x, m.y, m.z, m.t}) args_.insert(args_.end(), {row.x, row.y, row.z});
}

/// Up to the closing brace of a component. Transformations move the textures before them.
void ObjectReader::blob_modifiers(BlobMove& move, scene::TextureUse& texture) {
  for (;;) {
    const Token t = in_.next();
    if (t.kind == Token::Kind::close) return;
    if (t.is_punct(';')) continue;
    if (const auto step = in_.read_transformation(t)) {
      move.then(t, *step);
      if (texture.texture != scene::none) texture.transform = texture.transform.then(*step);
    } else if (t.is(w::texture)) {
      in_.add_layers(texture, in_.read_texture("texture"));
    } else if (t.is(w::pigment) || t.is(w::normal) || t.is(w::finish)) {
      in_.edit_texture(texture, t);
    } else {
      in_.unexpected(t, "a transformation or texture of this component");
    }
  }
}

}  // namespace durer::interpreter
