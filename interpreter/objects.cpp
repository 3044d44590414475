// Objects: primitives bound by their operand tables, CSG, modifiers (objects §8, §9).
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/suggest.h"
#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;

namespace {

bool is_csg(SymbolId word) {
  return word == w::union_ || word == w::merge || word == w::intersection || word == w::difference;
}

/// Objects of the language that this version can read over but not render.
bool is_known_object(SymbolId word) {
  switch (word) {
    case w::bicubic_patch:
    case w::blob:
    case w::box:
    case w::cone:
    case w::cubic:
    case w::cylinder:
    case w::disc:
    case w::height_field:
    case w::isosurface:
    case w::julia_fractal:
    case w::lathe:
    case w::mesh:
    case w::mesh2:
    case w::ovus:
    case w::parametric:
    case w::plane:
    case w::poly:
    case w::polygon:
    case w::polynomial:
    case w::prism:
    case w::quadric:
    case w::quartic:
    case w::smooth_triangle:
    case w::sor:
    case w::sphere:
    case w::sphere_sweep:
    case w::superellipsoid:
    case w::text:
    case w::torus:
    case w::triangle:
    case w::light_group: return true;
    default: return false;
  }
}

}  // namespace

namespace {
/// Why an object, or something in it, cannot clip or bound others; null if it can (objects §8.4).
const char* unfit_to_cut(const scene::Scene& scene, const scene::Registry& registry,
                         scene::ObjectId id) {
  const scene::Object& o = scene.objects[id];
  if (o.texture.texture != scene::none) return "have a texture";
  const bool patch =
      o.extras->mesh != nullptr
          ? !o.extras->mesh->has_inside()
          : o.kind == scene::NodeKind::light || (o.kind == scene::NodeKind::primitive &&
                                                 registry.primitives[o.type]->is_patch);
  if (patch) return "be without an inside";
  for (const scene::ObjectId child : o.children) {
    if (const char* flaw = unfit_to_cut(scene, registry, child)) return flaw;
  }
  return nullptr;
}

/// The word of the type that an object of this word is.
SymbolId type_word(SymbolId word) {
  switch (word) {
    case w::cubic:
    case w::quartic:
    case w::polynomial: return w::poly;
    case w::mesh2: return w::mesh;
    default: return word;
  }
}
}  // namespace

/// Who reads the operands of such an object. Most are bound by the table of their type.
Interpreter::Reader Interpreter::reader_of(SymbolId word) {
  switch (word) {
    case w::isosurface: return &Interpreter::read_isosurface;
    case w::parametric: return &Interpreter::read_parametric;
    case w::mesh: return &Interpreter::read_mesh;
    case w::mesh2: return &Interpreter::read_mesh2;
    case w::text: return &Interpreter::read_text_object;
    case w::poly:
    case w::cubic:
    case w::quartic:
    case w::polynomial: return &Interpreter::read_polynomial;
    case w::bicubic_patch:
    case w::blob:
    case w::height_field:
    case w::julia_fractal:
    case w::lathe:
    case w::polygon:
    case w::prism:
    case w::sor:
    case w::sphere_sweep: return &Interpreter::read_listed;
    default: return &Interpreter::read_primitive;
  }
}

bool Interpreter::starts_object(const Token& t) const {
  if (t.kind != Token::Kind::word) return false;
  return t.word == w::object || t.word == w::light_source || is_csg(t.word) ||
         is_known_object(t.word) || primitive_words_.contains(t.word);
}

scene::ObjectId Interpreter::add_object(scene::Object object) {
  std::uint32_t depth = 1;
  for (const scene::ObjectId child : object.children) {
    depth = std::max<std::uint32_t>(depth, object_depths_[child] + 1U);
  }
  check_depth(object, depth);
  if (object.importance == 0 && default_importance_ != 1) object.importance = default_importance_;
  object_depths_.push_back(static_cast<std::uint16_t>(depth));
  scene_.objects.push_back(std::move(object));
  return static_cast<scene::ObjectId>(scene_.objects.size() - 1);
}

/// After the object's word: reads the whole statement.
scene::ObjectId Interpreter::read_object(const Token& word) {
  check_stack(word.span);
  if (word.word == w::light_source) return read_light(word);
  if (word.word == w::light_group) return read_light_group(word);
  const Token open = next();
  if (open.kind != Token::Kind::open) {
    unexpected(open, fmt::format("`{{` after `{}`", name_of(word.word)));
  }

  if (const auto it = primitive_words_.find(word.word);
      it != primitive_words_.end() && reader_of(word.word) == &Interpreter::read_primitive) {
    if (quick_operands(*registry_.primitives[it->second], operands_, word)) {
      scene::Object o = primitive(it->second, word);
      o.args = operands_;
      return read_object_modifiers(std::move(o), word, open.span);
    }
  }
  // `sphere { Thing … }` copies Thing, whatever it is (objects §8.1).
  const Token first = peek();
  if (first.is_place()) {
    const Value* v = lookup(*first.tree, first.expr, false);
    const auto* ref = v == nullptr ? nullptr : v->get<ObjectRef>();
    if (ref != nullptr && !(is_csg(word.word))) {
      const scene::ObjectId id = ref->id;
      next();
      if (raw_next().kind == Token::Kind::close) {
        next();
        return id;
      }
      scene::Object copy = scene_.objects[id];
      copy.origin = origin(word.span);
      return read_object_modifiers(std::move(copy), word, open.span);
    }
    if (ref == nullptr && word.word == w::object && v != nullptr) {
      if (const auto* u = v->get<Shared<Unsupported>>()) {
        scene::Object node;
        node.kind = scene::NodeKind::unsupported;
        node.extras.edit().unsupported = (*u)->feature;
        node.origin = origin((*u)->span);
        next();
        skip_block();
        return add_object(std::move(node));
      }
      fail(Code::wrong_kind, first.span,
           fmt::format("expected an object, found {}", kind_name(*v)));
    }
  }
  if (word.word == w::object) {
    const Token inner = next();
    if (!starts_object(inner)) unexpected(inner, "an object");
    scene::Object copy = scene_.objects[read_object(inner)];
    return read_object_modifiers(std::move(copy), word, open.span);
  }
  if (is_csg(word.word)) {
    const scene::NodeKind kind = word.word == w::union_         ? scene::NodeKind::union_
                                 : word.word == w::merge        ? scene::NodeKind::merge
                                 : word.word == w::intersection ? scene::NodeKind::intersection
                                                                : scene::NodeKind::difference;
    return read_object_modifiers(read_csg(kind, word), word, open.span);
  }
  if (const auto it = primitive_words_.find(type_word(word.word)); it != primitive_words_.end()) {
    return read_object_modifiers((this->*reader_of(word.word))(it->second, word), word, open.span);
  }
  scene::Object node;
  node.kind = scene::NodeKind::unsupported;
  node.extras.edit().unsupported = fmt::format("`{}`", name_of(word.word));
  node.origin = origin(word.span);
  skip_block();
  return add_object(std::move(node));
}

/// A primitive without its operands.
scene::Object Interpreter::primitive(std::uint32_t type, const Token& word) {
  scene::Object o;
  o.kind = scene::NodeKind::primitive;
  o.type = type;
  o.origin = origin(word.span);
  return o;
}

scene::Object Interpreter::read_primitive(std::uint32_t type, const Token& word) {
  scene::Object o = primitive(type, word);
  o.args = read_operands(*registry_.primitives[type], word);
  return o;
}

scene::Object Interpreter::read_csg(scene::NodeKind kind, const Token& word) {
  scene::Object o;
  o.kind = kind;
  o.origin = origin(word.span);
  std::vector<scene::ObjectId> children;
  for (;;) {
    run_ahead(&children);
    const Token t = peek();
    if (starts_object(t)) {
      next();
      children.push_back(read_object(t));
    } else if (t.is_place()) {
      const Value* v = lookup(*t.tree, t.expr, true);
      const auto* ref = v == nullptr ? nullptr : v->get<ObjectRef>();
      if (ref == nullptr) unexpected(t, "an object or a modifier");
      children.push_back(ref->id);
      next();
    } else if (t.is_punct(';')) {
      next();
    } else {
      break;
    }
  }
  if (children.size() < 2 && version() >= 150) {
    warn(Code::scene, word.span,
         fmt::format("this `{}` has {} child{}", name_of(word.word), children.size(),
                     children.size() == 1 ? "" : "ren"));
  }
  o.children = children;
  return o;
}

/// Modifiers up to the closing brace.
scene::ObjectId Interpreter::read_object_modifiers(scene::Object object, const Token& word,
                                                   Span opened) {
  for (;;) {
    if (quick_modifier(object)) continue;
    const Token t = next();
    if (t.kind == Token::Kind::close) break;
    if (t.is_punct(';')) continue;
    if (t.kind == Token::Kind::word && object_modifier(object, t)) continue;
    Diagnostic d;
    d.code = t.kind == Token::Kind::word ? Code::unknown_setting : Code::unexpected_item;
    d.span = t.span;
    d.message = t.kind == Token::Kind::word
                    ? fmt::format("`{}` takes no `{}` here", name_of(word.word), name_of(t.word))
                    : fmt::format("expected a modifier or `}}`, found {}", describe(t));
    if (const auto* name = t.node<ast::Name>();
        name != nullptr && env_.find(name->name) == nullptr) {
      static constexpr std::string_view modifiers[] = {
          "translate",  "rotate",  "scale",   "matrix",     "transform", "texture",
          "pigment",    "normal",  "finish",  "interior",   "material",  "clipped_by",
          "bounded_by", "inverse", "hollow",  "no_shadow",  "no_image",  "no_reflection",
          "open",       "sturm",   "photons", "uv_mapping", "color",     "interior_texture"};
      d.message = fmt::format("`{}` is not declared, and no modifier of that name exists",
                              name_of(name->name));
      if (const auto near = closest(name_of(name->name), modifiers)) {
        d.help.push_back(fmt::format("did you mean `{}`?", *near));
      }
    }
    d.labels.push_back({word.span.to(opened), "in this block"});
    fail(std::move(d));
  }
  if (object.texture.texture == scene::none &&
      object.extras->interior_texture.texture != scene::none) {
    fail(Code::scene, word.span, "an `interior_texture` needs a texture of the outside beside it",
         "put a `texture` or `pigment` into the same object");
  }
  settle_texture(object);
  return add_object(std::move(object));
}

/// At the end of the statement that made the object.
void Interpreter::settle_texture(scene::Object& object) {
  if (own_texture_ != scene::none && object.texture.texture == own_texture_) {
    share_texture(object.texture);
  }
  own_texture_ = scene::none;
}

void Interpreter::transform_object(scene::Object& o, const Transform& t) {
  const SharedTransform step(t);
  o.transform = o.transform.then(step);
  if (!o.extras->clips.empty()) {
    o.extras.edit().clip_transform = o.extras->clip_transform.then(step);
  }
  if (!o.extras->bounds.empty()) {
    o.extras.edit().bound_transform = o.extras->bound_transform.then(step);
  }
  if (o.interior != scene::none && !scene_.interiors[o.interior].media->empty()) {
    o.extras.edit().media_transform = o.extras->media_transform.then(step);
  }
  if (o.uv_mapping) return;  // its textures lie on the surface
  if (o.texture.texture != scene::none) o.texture.transform = o.texture.transform.then(step);
  if (o.extras->interior_texture.texture != scene::none) {
    scene::TextureUse& inner = o.extras.edit().interior_texture;
    inner.transform = inner.transform.then(step);
  }
}

void Interpreter::put_interior(scene::Object& o, scene::InteriorId interior) {
  o.interior = interior;
  if (!o.extras->media_transform.is_identity()) o.extras.edit().media_transform = {};
}

/// Reads one modifier whose word is `t`; false if `t` is none.
bool Interpreter::object_modifier(scene::Object& o, const Token& t) {
  if (const auto transform = read_transformation(t)) {
    transform_object(o, *transform);
    return true;
  }
  const auto must_be = [&](const scene::Object& object, const Token& word,
                           std::initializer_list<std::string_view> types) {
    const bool known = object.kind == scene::NodeKind::primitive && object.type != scene::none;
    const std::string_view type = known ? registry_.primitives[object.type]->name : "";
    if (std::find(types.begin(), types.end(), type) != types.end()) return;
    fail(Code::unknown_setting, word.span,
         fmt::format("`{}` means nothing to this object", name_of(word.word)),
         fmt::format("it belongs to {}", fmt::join(types, ", ")));
  };
  switch (t.word) {
    case w::texture: add_layers(o.texture, read_texture("texture")); return true;
    case w::pigment:
    case w::finish:
    case w::normal: edit_texture(o.texture, t); return true;
    case w::interior_texture:
      add_layers(o.extras.edit().interior_texture, read_texture("interior_texture"));
      return true;
    case w::interior: put_interior(o, read_interior()); return true;
    case w::material: {
      const Material m = read_material();
      if (m.texture != scene::none) o.texture = {m.texture, {}};
      if (m.interior_texture != scene::none) o.extras.edit().interior_texture = {m.interior_texture, {}};
      if (m.interior != scene::none) put_interior(o, m.interior);
      return true;
    }
    case w::clipped_by: read_clips(o, true); return true;
    case w::bounded_by: read_clips(o, false); return true;
    case w::inverse: o.inverse = !o.inverse; return true;
    case w::hollow: o.hollow = read_switch(true); return true;
    case w::no_shadow: o.no_shadow = true; return true;
    case w::no_image: o.no_image = read_switch(true); return true;
    case w::no_reflection: o.no_reflection = read_switch(true); return true;
    case w::no_radiosity: o.no_radiosity = read_switch(true); return true;
    case w::double_illuminate: o.double_illuminate = read_switch(true); return true;
    case w::sturm:
      must_be(o, t, {"torus", "ovus", "poly", "blob", "lathe", "prism", "sor", "lemon"});
      o.sturm = read_switch(true);
      return true;
    case w::hierarchy:  // a matter of speed in the oracle
      must_be(o, t, {"blob", "mesh", "height_field"});
      read_switch(true);
      return true;
    case w::split_union:
      if (o.kind != scene::NodeKind::union_ && o.kind != scene::NodeKind::merge) {
        fail(Code::unknown_setting, t.span, "`split_union` is for `union` and `merge`");
      }
      o.kept_whole = !(read_float() > 0);
      return true;
    case w::uv_mapping:
      if (o.texture.texture != scene::none) {
        fail(Code::scene, t.span, "`uv_mapping` must stand before the texture of its object");
      }
      o.uv_mapping = true;
      return true;
    case w::cutaway_textures:
      if (o.kind != scene::NodeKind::intersection && o.kind != scene::NodeKind::difference) {
        fail(Code::unknown_setting, t.span,
             "`cutaway_textures` is for `intersection` and `difference`");
      }
      o.cutaway_textures = true;
      return true;
    case w::photons: read_object_photons(o.extras.edit().photons, t); return true;
    case w::radiosity: o.importance = read_importance(t); return true;
    case w::color:
    case w::colour:
      unread(t);
      read_colour();
      warn(Code::deprecated, t.span, "a colour here has no effect", "put it into `pigment { … }`");
      return true;
    default: return false;
  }
}

/// `clipped_by { … }` and `bounded_by { … }` (objects §8.4).
void Interpreter::read_clips(scene::Object& o, bool clip) {
  const std::string_view block = clip ? "clipped_by" : "bounded_by";
  expect_open(block);
  scene::ObjectExtras& extras = o.extras.edit();
  std::vector<scene::ObjectId>& list = clip ? extras.clips : extras.bounds;
  SharedTransform& moved = clip ? extras.clip_transform : extras.bound_transform;
  if (accept(clip ? w::bounded_by : w::clipped_by)) {
    if (!list.empty()) {
      fail(Code::scene, peek().span,
           fmt::format("`{}` cannot borrow a list when it has one", block));
    }
    list = clip ? extras.bounds : extras.clips;
    moved = clip ? extras.bound_transform : extras.clip_transform;
    expect_close(block, {});
    return;
  }
  // Earlier transformations moved the earlier objects only: settle them first.
  if (!moved.is_identity()) {
    for (scene::ObjectId& id : list) {
      scene::Object copy = scene_.objects[id];
      transform_object(copy, moved);
      id = add_object(std::move(copy));
    }
    moved = {};
  }
  std::vector<scene::ObjectId> added;
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) break;
    if (t.is_punct(';')) continue;
    if (starts_object(t)) {
      added.push_back(read_object(t));
    } else if (const auto transform = read_transformation(t)) {
      for (scene::ObjectId& id : added) {
        scene::Object copy = scene_.objects[id];
        transform_object(copy, *transform);
        id = add_object(std::move(copy));
      }
    } else if (const Value* v =
                   t.kind == Token::Kind::expr ? lookup(*t.tree, t.expr, false) : nullptr;
               v != nullptr && v->get<ObjectRef>() != nullptr) {
      added.push_back(v->get<ObjectRef>()->id);
    } else {
      unexpected(t, fmt::format("an object in `{}`", block));
    }
  }
  for (const scene::ObjectId id : added) {
    const char* flaw = unfit_to_cut(scene_, registry_, id);
    if (flaw == nullptr) continue;
    fail(Code::scene, scene_.origins[scene_.objects[id].origin].span,
         fmt::format("what stands in `{}` must not {}", block, flaw));
  }
  list.insert(list.end(), added.begin(), added.end());
}

}  // namespace durer::interpreter
