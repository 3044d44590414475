// Objects: primitives bound by their operand tables, CSG, modifiers (objects §8, §9).
#include <array>
#include <cmath>

#include <fmt/format.h>

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

/// "the centre" for "centre" and for "the centre".
std::string with_article(std::string_view doc) {
  return doc.starts_with("the ") ? std::string(doc) : fmt::format("the {}", doc);
}

}  // namespace

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
  object_depths_.push_back(static_cast<std::uint16_t>(depth));
  scene_.objects.push_back(std::move(object));
  return static_cast<scene::ObjectId>(scene_.objects.size() - 1);
}

/// After the object's word: reads the whole statement.
scene::ObjectId Interpreter::read_object(const Token& word) {
  check_stack(word.span);
  if (word.word == w::light_source) return read_light(word);
  const Token open = next();
  if (open.kind != Token::Kind::open) {
    unexpected(open, fmt::format("`{{` after `{}`", name_of(word.word)));
  }

  if (const auto it = primitive_words_.find(word.word); it != primitive_words_.end()) {
    std::vector<double> args;
    if (quick_operands(*registry_.primitives[it->second], args, word)) {
      scene::Object o = primitive(it->second, word);
      o.args = std::move(args);
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
  if (word.word == w::poly || word.word == w::cubic || word.word == w::quartic ||
      word.word == w::polynomial) {
    if (const auto it = primitive_words_.find(w::poly); it != primitive_words_.end()) {
      return read_object_modifiers(read_polynomial(it->second, word), word, open.span);
    }
  } else if (word.word == w::isosurface || word.word == w::parametric) {
    if (const auto it = primitive_words_.find(word.word); it != primitive_words_.end()) {
      return read_object_modifiers(word.word == w::isosurface ? read_isosurface(it->second, word)
                                                              : read_parametric(it->second, word),
                                   word, open.span);
    }
  } else if (word.word == w::mesh || word.word == w::mesh2) {
    if (const auto it = primitive_words_.find(w::mesh); it != primitive_words_.end()) {
      return read_object_modifiers(word.word == w::mesh ? read_mesh(it->second, word)
                                                        : read_mesh2(it->second, word),
                                   word, open.span);
    }
  } else if (const auto it = primitive_words_.find(word.word); it != primitive_words_.end()) {
    return read_object_modifiers(read_primitive(it->second, word), word, open.span);
  }
  scene::Object node;
  node.kind = scene::NodeKind::unsupported;
  node.extras.edit().unsupported = fmt::format("`{}`", name_of(word.word));
  node.origin = origin(word.span);
  skip_block();
  return add_object(std::move(node));
}

/// One operand, behind its word if it has one.
void Interpreter::read_operand(const scene::Param& p, double* out) {
  last_span_ = peek().span;
  switch (p.kind) {
    case scene::ArgKind::number: *out = read_scalar(p.doc); break;
    case scene::ArgKind::flag: *out = 1; break;
    case scene::ArgKind::pair:
      out[0] = read_scalar(p.doc);
      optional_comma();
      if (starts_number(peek())) out[1] = read_scalar(p.doc);
      break;
    case scene::ArgKind::vector2:
    case scene::ArgKind::vector: {
      const int n = p.kind == scene::ArgKind::vector ? 3 : 2;
      const Num v = fit(read_num(n), n);
      for (int k = 0; k < n; ++k) out[k] = v.v[static_cast<std::size_t>(k)];
      break;
    }
  }
}

const Interpreter::OperandPlan& Interpreter::operand_plan(const scene::TypeInfo& info) {
  const auto [known, is_new] = operand_plans_.try_emplace(&info);
  OperandPlan& plan = known->second;
  if (!is_new) return plan;
  for (std::size_t i = 0; i < info.params.size(); ++i) {
    const scene::Param& p = info.params[i];
    plan.offsets.push_back(static_cast<std::uint16_t>(plan.fallback.size()));
    plan.fallback.insert(plan.fallback.end(), p.fallback.begin(),
                         p.fallback.begin() + scene::width(p.kind));
    if (p.positional) plan.positional = i + 1;
    plan.has_words |= !p.positional;
    plan.simple &= !p.positional || (!p.optional && (p.kind == scene::ArgKind::number ||
                                                     p.kind == scene::ArgKind::vector));
  }
  return plan;
}

/// The operands of a primitive, pattern or warp: positional ones in order, then flags and keyword
/// ones.
std::vector<double> Interpreter::read_operands(const scene::TypeInfo& info, const Token& word) {
  const OperandPlan& plan = operand_plan(info);
  std::vector<double> args = plan.fallback;
  const auto put = [&](std::size_t i) { read_operand(info.params[i], &args[plan.offsets[i]]); };
  for (std::size_t i = 0; i < plan.positional; ++i) {
    const scene::Param& p = info.params[i];
    if (!p.positional) continue;
    const Token& t = peek();
    const bool here = t.kind == Token::Kind::expr || t.kind == Token::Kind::punct;
    if (!here && p.optional) continue;
    if (!here) {
      Diagnostic d;
      d.code = Code::missing_argument;
      d.span = t.span;
      d.message =
          fmt::format("expected {} of this `{}`, found {}", with_article(p.doc), info.name,
                      describe(t));
      d.labels.push_back({word.span, "in this block"});
      fail(std::move(d));
    }
    put(i);
    // A comma after the last operand is an error in the language (language §1.8).
    if (i + 1 < plan.positional) optional_comma();
  }
  for (bool again = plan.has_words; again;) {
    again = false;
    const Token t = peek();
    if (t.kind != Token::Kind::word) break;
    for (std::size_t i = 0; i < info.params.size(); ++i) {
      if (info.params[i].positional || info.params[i].name != name_of(t.word)) continue;
      next();
      put(i);
      again = true;
      break;
    }
  }
  check_operands(info, args, word);
  return args;
}

void Interpreter::check_operands(const scene::TypeInfo& info, const std::vector<double>& args,
                                 const Token& word) {
  if (info.validate != nullptr) {
    if (const auto problem = info.validate(args)) fail(Code::degenerate, word.span, *problem);
  }
  if (info.doubt != nullptr) {
    if (const auto doubt = info.doubt(args)) warn(Code::degenerate, word.span, *doubt);
  }
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

/// `poly { n, <…> }`, `cubic { <…> }`, `quartic { <…> }` and `polynomial { n, xyz(i,j,k): c, … }`
/// (objects §12.3).
scene::Object Interpreter::read_polynomial(std::uint32_t type, const Token& word) {
  scene::Object o;
  o.kind = scene::NodeKind::primitive;
  o.type = type;
  o.origin = origin(word.span);
  double degree = word.word == w::cubic ? 3 : 4;
  if (word.word == w::poly || word.word == w::polynomial) {
    degree = std::trunc(read_scalar("the degree"));
    optional_comma();
  }
  if (!(degree >= 2 && degree <= 35)) {
    fail(Code::out_of_range, word.span, "the degree of a polynomial surface is 2 to 35");
  }
  const auto n = static_cast<std::size_t>(degree);
  std::vector<double> terms((n + 1) * (n + 2) * (n + 3) / 6);
  if (word.word == w::polynomial) {
    while (accept(w::xyz)) {
      std::array<std::size_t, 3> power{};
      read_exponents(power, word.span);
      if (power[0] + power[1] + power[2] > n) {
        fail(Code::out_of_range, last_span_,
             fmt::format("these exponents add up to more than {}", n));
      }
      const Token colon = next();
      if (!colon.is_punct(':')) unexpected(colon, "`:` and a factor");
      const std::size_t a = n - power[0];
      const std::size_t b = a - power[1];
      terms[(a + 2) * (a + 1) * a / 6 + (b + 1) * b / 2 + (b - power[2])] = read_scalar("factor");
      optional_comma();
    }
  } else {
    const std::size_t found = read_numbers(terms);
    if (found != terms.size()) {
      fail(Code::missing_argument, word.span,
           fmt::format("a surface of degree {} takes {} numbers in `< >`, here are {}", n,
                       terms.size(), found));
    }
  }
  o.args.push_back(degree);
  o.args.insert(o.args.end(), terms.begin(), terms.end());
  return o;
}

/// `(i, j, k)` after `xyz`.
void Interpreter::read_exponents(std::array<std::size_t, 3>& power, Span span) {
  const Token t = next();
  last_span_ = t.span;
  const auto* g = t.node<ast::OpenGroup>();
  if (g == nullptr || g->kind != ast::OpenGroup::Kind::paren)
    unexpected(t, "`(` and three exponents");
  const Nested part(*this, *t.tree, g->items);
  for (std::size_t& p : power) {
    const double v = read_scalar("exponent");
    if (!(v >= 0 && v <= 35)) fail(Code::out_of_range, span, "exponents are 0 to 35");
    p = static_cast<std::size_t>(v);
    optional_comma();
  }
}

/// A long vector `< … >` into `out`; returns how many numbers there were.
std::size_t Interpreter::read_numbers(std::span<double> out) {
  const Token t = next();
  std::size_t n = 0;
  const auto take = [&] {
    while (peek().kind != Token::Kind::end) {
      const double x = read_scalar("number");
      if (n < out.size()) out[n] = x;
      ++n;
      optional_comma();
    }
  };
  if (const auto* v = t.node<ast::Vector>(); v != nullptr) {
    for (std::uint32_t i = 0; i < v->components.count; ++i) {
      const Nested part(*this, *t.tree, t.tree->expr_lists[v->components.first + i]);
      take();
    }
  } else if (const auto* g = t.node<ast::OpenGroup>();
             g != nullptr && g->kind == ast::OpenGroup::Kind::vector) {
    const Nested part(*this, *t.tree, g->items);
    take();
  } else {
    unexpected(t, "`<` and a list of numbers");
  }
  return n;
}

scene::Object Interpreter::read_csg(scene::NodeKind kind, const Token& word) {
  scene::Object o;
  o.kind = kind;
  o.origin = origin(word.span);
  for (;;) {
    const Token t = peek();
    if (starts_object(t)) {
      next();
      o.children.push_back(read_object(t));
    } else if (t.is_place()) {
      const Value* v = lookup(*t.tree, t.expr, true);
      const auto* ref = v == nullptr ? nullptr : v->get<ObjectRef>();
      if (ref == nullptr) unexpected(t, "an object or a modifier");
      o.children.push_back(ref->id);
      next();
    } else if (t.is_punct(';')) {
      next();
    } else {
      break;
    }
  }
  if (o.children.size() < 2 && version() >= 150) {
    warn(Code::scene, word.span,
         fmt::format("this `{}` has {} child{}", name_of(word.word), o.children.size(),
                     o.children.size() == 1 ? "" : "ren"));
  }
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
  if (own_texture_ != scene::none && object.texture.texture == own_texture_) {
    share_texture(object.texture);
  }
  own_texture_ = scene::none;
  return add_object(std::move(object));
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
  if (o.uv_mapping) return;  // its textures lie on the surface
  if (o.texture.texture != scene::none) o.texture.transform = o.texture.transform.then(step);
  if (o.extras->interior_texture.texture != scene::none) {
    scene::TextureUse& inner = o.extras.edit().interior_texture;
    inner.transform = inner.transform.then(step);
  }
}

/// Reads one modifier whose word is `t`; false if `t` is none.
bool Interpreter::object_modifier(scene::Object& o, const Token& t) {
  if (const auto transform = read_transformation(t)) {
    transform_object(o, *transform);
    return true;
  }
  const auto unsupported = [&](std::string_view what) {
    if (o.extras->unsupported.empty()) o.extras.edit().unsupported = what;
  };
  switch (t.word) {
    case w::texture: add_layers(o.texture, read_texture("texture")); return true;
    case w::pigment:
    case w::finish:
    case w::normal: edit_texture(o.texture, t); return true;
    case w::interior_texture:
      add_layers(o.extras.edit().interior_texture, read_texture("interior_texture"));
      return true;
    case w::interior: o.interior = read_interior(); return true;
    case w::material: {
      const Material m = read_material();
      if (m.texture != scene::none) o.texture = {m.texture, {}};
      if (m.interior_texture != scene::none) o.extras.edit().interior_texture = {m.interior_texture, {}};
      if (m.interior != scene::none) o.interior = m.interior;
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
    case w::sturm: o.sturm = read_switch(true); return true;
    case w::hierarchy: read_switch(true); return true;  // a matter of speed in the oracle
    case w::split_union: read_float(); return true;     // likewise (objects §8.2)
    case w::uv_mapping:
      if (o.texture.texture != scene::none) {
        fail(Code::scene, t.span, "`uv_mapping` must stand before the texture of its object");
      }
      o.uv_mapping = true;
      return true;
    case w::cutaway_textures: unsupported("`cutaway_textures`"); return true;
    case w::photons: {
      // Photons can only be shot once they are switched on in global_settings.
      expect_open("photons");
      skip_block();
      return true;
    }
    case w::radiosity: {
      expect_open("radiosity");
      skip_block();
      return true;
    }
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
  list.insert(list.end(), added.begin(), added.end());
}

// ---- transformations (objects §6) --------------------------------------------------------------

/// `translate`, `rotate` or `scale` by a vector.
Transform Interpreter::transformation(SymbolId word, dvec3 by, Span span) {
  if (word == w::translate) return Transform::translate(by);
  if (word == w::rotate) return Transform::rotate_deg(by);
  for (int i = 0; i < 3; ++i) {
    if (by[i] != 0) continue;
    warn(Code::degenerate, span,
         fmt::format("`scale` with {} = 0; 1 is used instead", "xyz"[i]));
    by[i] = 1;
  }
  return Transform::scale(by);
}

/// The transformation that starts with `t`, or nothing if it starts none.
std::optional<Transform> Interpreter::read_transformation(const Token& t) {
  if (t.kind != Token::Kind::word) return std::nullopt;
  switch (t.word) {
    case w::translate:
    case w::rotate:
    case w::scale: return transformation(t.word, read_vector(), t.span);
    case w::matrix: return read_matrix(t);
    case w::transform: return read_transform_block();
    default: return std::nullopt;
  }
}

Transform Interpreter::read_matrix(const Token& word) {
  std::array<double, 12> m{};
  const std::size_t n = read_numbers(m);
  if (n != 12) {
    fail(Code::missing_argument, word.span,
         fmt::format("`matrix` takes 12 numbers in `< >`, here are {}", n));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(m[i]) < epsilon && std::abs(m[i + 3]) < epsilon && std::abs(m[i + 6]) < epsilon) {
      warn(Code::degenerate, word.span,
           fmt::format("column {} of the matrix is zero; its diagonal element becomes 1", i));
      m[4 * i] = 1;
    }
  }
  const auto matrix = Transform::matrix(m);
  if (!matrix)
    fail(Code::degenerate, word.span, "this matrix is singular",
         "its three rows must not lie in one plane");
  return *matrix;
}

/// After the word `transform`: `{ … }` or a bare identifier.
Transform Interpreter::read_transform_block() {
  const auto identifier = [&](const Token& t) -> std::optional<Transform> {
    if (t.kind != Token::Kind::expr) return std::nullopt;
    const Value* v = lookup(*t.tree, t.expr, true);
    if (v == nullptr) return std::nullopt;
    const auto* ref = v->get<Shared<Transform>>();
    if (ref == nullptr) {
      fail(Code::wrong_kind, t.span, fmt::format("expected a transform, found {}", kind_name(*v)));
    }
    return **ref;
  };
  const Token first = next();
  if (first.kind != Token::Kind::open) {
    if (const auto t = identifier(first)) return *t;
    unexpected(first, "`{` or a transform after `transform`");
  }
  Transform sum;
  bool inverted = false;
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) break;
    if (t.is_punct(';')) continue;
    if (t.is(w::inverse)) {
      inverted = true;
    } else if (const auto step = read_transformation(t)) {
      sum = sum.then(*step);
    } else if (const auto named = identifier(t)) {
      sum = sum.then(*named);
    } else {
      unexpected(t, "a transformation");
    }
  }
  return inverted ? sum.inverse() : sum;
}

}  // namespace durer::interpreter
