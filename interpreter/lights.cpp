// Light sources (shading §6.1).
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;

scene::ObjectId Interpreter::read_light(const Token& word) {
  expect_open("light_source");
  scene::Object o;
  o.kind = scene::NodeKind::light;
  o.origin = origin(word.span);
  scene::Light l;
  l.origin = o.origin;

  const Token first = peek();
  const Value* v =
      first.kind == Token::Kind::expr ? lookup(*first.tree, first.expr, false) : nullptr;
  if (v != nullptr && v->get<ObjectRef>() != nullptr) {
    next();
    o = scene_.objects[v->get<ObjectRef>()->id];
    if (o.kind != scene::NodeKind::light)
      fail(Code::wrong_kind, first.span, "expected a light source");
    l = scene_.lights[o.light];
  } else {
    l.position = read_vector();
    optional_comma();
    l.colour = read_rgb();
  }
  read_light_items(o, l, word);
  o.light = static_cast<scene::LightId>(scene_.lights.size());
  scene_.lights.push_back(l);
  return add_object(std::move(o));
}

namespace {

constexpr std::string_view light_settings =
    "spotlight cylinder parallel shadowless point_at radius falloff tightness area_light adaptive "
    "jitter circular orient area_illumination fade_distance fade_power media_attenuation "
    "media_interaction looks_like projected_through photons color_map translate rotate scale matrix "
    "transform";

}  // namespace

void Interpreter::read_light_items(scene::Object& o, scene::Light& l, const Token& word) {
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) break;
    if (t.is_punct(';')) continue;
    if (const auto transform = read_transformation(t)) {
      o.transform = o.transform.then(*transform);
      continue;
    }
    if (t.kind != Token::Kind::word) bad_setting(t, "light_source", word.span, light_settings);
    if (aiming_setting(l, t) || area_setting(l, t)) continue;
    switch (t.word) {
      case w::shadowless: l.shadowless = true; break;
      case w::fade_distance: l.fade_distance = read_float(); break;
      case w::fade_power: l.fade_power = read_float(); break;
      case w::media_attenuation: l.media_attenuation = read_switch(true); break;
      case w::media_interaction: l.media_interaction = read_switch(true); break;
      case w::looks_like: read_looks_like(o, l, t); break;
      case w::projected_through: {
        if (l.projected_through != scene::none) {
          fail(Code::scene, t.span, "a light source has one `projected_through` at most");
        }
        Span opened;
        scene::Object shape = start_only_object(t, opened);
        shape = scene_.objects[read_object_modifiers(std::move(shape), t, opened)];
        transform_object(shape, o.transform->inverse());
        l.projected_through = add_object(std::move(shape));
        break;
      }
      case w::photons: read_light_photons(l.photons, t); break;
      case w::color_map:
      case w::colour_map: l.colour = sum_of_colours(read_colour_map()); break;
      default: bad_setting(t, "light_source", word.span, light_settings);
    }
  }
  if (l.area.orient && l.has_area) settle_oriented(l, word.span);
}

/// Where a light shines: spotlights, cylinders, parallel light. False if `t` is none of that.
bool Interpreter::aiming_setting(scene::Light& l, const Token& t) {
  using Kind = scene::Light::Kind;
  const auto cone = [&](Kind kind, double radius, double falloff) {
    l.kind = kind;
    l.radius_deg = radius;
    l.falloff_deg = falloff;
    l.tightness = 0;
  };
  const auto shaped = [&](double& setting, bool by_parallel) {
    if (l.kind == Kind::point && !(by_parallel && l.parallel)) {
      fail(Code::unexpected_item, t.span,
           fmt::format("`{}` makes no sense in a point light", name_of(t.word)),
           "write `spotlight` before it");
    }
    setting = read_float();
  };
  switch (t.word) {
    case w::spotlight: cone(Kind::spotlight, 30, 45); return true;
    case w::cylinder:
      cone(Kind::cylinder, 0.75, 1);
      l.parallel = true;
      return true;
    case w::parallel: l.parallel = true; return true;
    case w::point_at:
      if (l.kind == Kind::point && !l.parallel) {
        fail(Code::unexpected_item, t.span, "`point_at` makes no sense in a point light",
             "write `spotlight` before it");
      }
      l.point_at = read_vector();
      return true;
    case w::radius: shaped(l.radius_deg, true); return true;
    case w::falloff: shaped(l.falloff_deg, true); return true;
    case w::tightness: shaped(l.tightness, true); return true;
    default: return false;
  }
}

/// What makes a lamp of some extent. False if `t` is none of that.
bool Interpreter::area_setting(scene::Light& l, const Token& t) {
  scene::LightArea& a = l.area;
  const auto after_area = [&] {
    if (l.has_area) return;
    warn(Code::scene, t.span, fmt::format("`{}` before `area_light`", name_of(t.word)));
  };
  switch (t.word) {
    case w::area_light: read_area(l, t.span); return true;
    case w::adaptive: a.adaptive = static_cast<int>(read_float()); return true;
    case w::jitter: a.jitter = true; return true;
    case w::circular:
      after_area();
      a.circular = true;
      if (l.has_area) check_circular(a, t.span);
      return true;
    case w::orient:
      after_area();
      a.orient = true;
      return true;
    case w::area_illumination:
      after_area();
      a.illumination = read_switch(true);
      return true;
    default: return false;
  }
}

void Interpreter::read_area(scene::Light& l, Span span) {
  scene::LightArea& a = l.area;
  l.has_area = true;
  a.u = read_vector();
  optional_comma();
  a.v = read_vector();
  optional_comma();
  a.n1 = static_cast<int>(read_float());
  optional_comma();
  a.n2 = static_cast<int>(read_float());
  constexpr int most = 4096;  // along one side: nobody waits for 16 million samples
  if (a.n1 == 0 || a.n2 == 0) {
    fail(Code::out_of_range, span, "an area light needs at least one sample along either side");
  }
  if (a.n1 < 0 || a.n2 < 0 || a.n1 > most || a.n2 > most) {
    fail(Code::out_of_range, span,
         fmt::format("an area light has 1 to {} samples along either side", most));
  }
  if (a.circular) check_circular(a, span);
}

void Interpreter::check_circular(const scene::LightArea& a, Span span) {
  if (a.n1 > 1 && a.n2 > 1) return;
  fail(Code::out_of_range, span, "a circular area light needs two samples along both sides");
}

/// A lamp that turns is round and of one size (shading §6.6).
void Interpreter::settle_oriented(scene::Light& l, Span span) {
  scene::LightArea& a = l.area;
  if (!a.circular) {
    warn(Code::scene, span, "an area light with `orient` is circular");
    a.circular = true;
    check_circular(a, span);
  }
  const double length = glm::length(a.u);
  if (std::abs(length - glm::length(a.v)) > epsilon || a.n1 != a.n2) {
    warn(Code::scene, span, "an area light with `orient` has equal sides; the first one counts");
  }
}

/// `{ OBJECT` after `looks_like` or `projected_through`; modifiers may follow.
scene::Object Interpreter::start_only_object(const Token& word, Span& opened) {
  opened = peek().span;
  expect_open(name_of(word.word));
  const Token t = next();
  if (starts_object(t)) return scene_.objects[read_object(t)];
  const Value* v = t.is_place() ? lookup(*t.tree, t.expr, true) : nullptr;
  if (v == nullptr || v->get<ObjectRef>() == nullptr) unexpected(t, "an object");
  return scene_.objects[v->get<ObjectRef>()->id];
}

/// The object stands where the light is by now, and will move with it.
void Interpreter::read_looks_like(scene::Object& o, const scene::Light& l, const Token& word) {
  if (!o.children.empty()) {
    fail(Code::scene, word.span, "a light source has one `looks_like` at most");
  }
  Span opened;
  scene::Object shape = start_only_object(word, opened);
  transform_object(shape, Transform::translate(o.transform->point(l.position)));
  shape = scene_.objects[read_object_modifiers(std::move(shape), word, opened)];
  transform_object(shape, o.transform->inverse());
  shape.no_shadow = true;
  o.children = {add_object(std::move(shape))};
}

/// What a colour map in place of a colour amounts to.
vec3 Interpreter::sum_of_colours(const ColourMap& map) {
  vec3 sum(0.0F);
  for (const scene::PigmentEntry& e : map.entries) sum += e.key * e.colour.rgb;
  return sum;
}

/// `light_group { … }` (shading §6.7).
scene::ObjectId Interpreter::read_light_group(const Token& word) {
  const Span opened = peek().span;
  expect_open("light_group");
  scene::Object o;
  o.kind = scene::NodeKind::light_group;
  o.origin = origin(word.span);
  std::vector<scene::ObjectId> children;
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) break;
    if (t.is_punct(';')) continue;
    if (starts_object(t)) {
      children.push_back(read_object(t));
    } else if (const auto transform = read_transformation(t)) {
      o.transform = o.transform.then(*transform);
    } else if (t.is(w::global_lights)) {
      o.global_lights = read_switch(true);
    } else if (t.is(w::photons)) {
      read_object_photons(o.extras.edit().photons, t);
    } else if (const Value* v = t.is_place() ? lookup(*t.tree, t.expr, true) : nullptr;
               v != nullptr && v->get<ObjectRef>() != nullptr) {
      children.push_back(v->get<ObjectRef>()->id);
    } else {
      bad_setting(t, "light_group", opened, "global_lights photons translate rotate scale matrix transform");
    }
  }
  o.children = children;
  return add_object(std::move(o));
}

}  // namespace durer::interpreter
