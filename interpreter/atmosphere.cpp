// Sky, fog and rainbows (shading §7).
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;

/// `sky_sphere { … }` (shading §7.2). Its pigments start from the factory pigment, not the default.
scene::SkySphere Interpreter::read_sky_sphere(Span span) {
  expect_open("sky_sphere");
  scene::SkySphere sky;
  sky.origin = origin(span);
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) break;
    if (t.is_punct(';')) continue;
    if (const auto transform = read_transformation(t)) {
      sky.transform = sky.transform.then(*transform);
    } else if (t.is(w::pigment)) {
      sky.pigments.push_back(read_pigment({}));
    } else if (t.is(w::emission)) {
      sky.emission = read_rgb();
    } else if (const Value* v =
                   t.kind == Token::Kind::expr ? lookup(*t.tree, t.expr, true) : nullptr;
               v != nullptr && v->get<Shared<scene::SkySphere>>() != nullptr) {
      sky = **v->get<Shared<scene::SkySphere>>();
    } else {
      unexpected(t, "a pigment, `emission` or a transformation in `sky_sphere`");
    }
  }
  if (sky.pigments.empty()) fail(Code::missing_argument, span, "`sky_sphere` needs a pigment");
  return sky;
}

/// `fog { … }` (shading §7.3).
scene::Fog Interpreter::read_fog(Span span) {
  static constexpr std::string_view settings =
      "color distance fog_type fog_offset fog_alt turbulence turb_depth octaves omega lambda up "
      "rotate scale matrix transform";
  expect_open("fog");
  scene::Fog fog;
  for (;;) {
    const Token t = peek();
    if (starts_colour(t)) {
      fog.colour = read_colour();
      continue;
    }
    if (t.kind == Token::Kind::expr) {
      const Value* v = lookup(*t.tree, t.expr, false);
      if (v != nullptr && v->get<Shared<scene::Fog>>() != nullptr) {
        fog = **v->get<Shared<scene::Fog>>();
        next();
        continue;
      }
      if (const auto* name = t.node<ast::Name>();
          name != nullptr && !symbols_.reserved(name->name) && env_.find(name->name) == nullptr) {
        bad_setting(t, "fog", span, settings);
      }
      const Num n = read_num(1);
      if (n.length == 5) {
        fog.colour = n.colour();
      } else if (n.length == 1) {
        fog.distance = n.v[0];
        warn(Code::deprecated, t.span, "a number alone in `fog`", "write `distance` before it");
      } else {
        fail(Code::wrong_kind, t.span, "expected a colour or a setting of `fog`, found a vector",
             "write `rgb` before it");
      }
      continue;
    }
    next();
    if (t.kind == Token::Kind::close) break;
    if (t.is_punct(';')) continue;
    if (t.kind != Token::Kind::word || !fog_setting(fog, t)) {
      bad_setting(t, "fog", span, settings);
    }
  }
  const double length = glm::length(fog.up);
  if (length > 0) fog.up /= length;
  fog.origin = origin(span);
  return fog;
}

/// False if `t` is no setting of a fog.
bool Interpreter::fog_setting(scene::Fog& fog, const Token& t) {
  if (t.is(w::translate)) {
    read_vector();
    warn(Code::scene, t.span, "a fog cannot be moved", "use `fog_offset`");
    return true;
  }
  if (const auto transform = read_transformation(t)) {
    fog.up = transform->vector(fog.up);
    return true;
  }
  switch (t.word) {
    case w::distance: fog.distance = read_float(); return true;
    case w::fog_type: {
      const double type = read_float();
      fog.kind = type == 2 ? scene::Fog::Kind::ground : scene::Fog::Kind::constant;
      if (type != 1 && type != 2) {
        warn(Code::out_of_range, t.span, "`fog_type` is 1 or 2; 1 is used");
      }
      return true;
    }
    case w::fog_offset: fog.offset = read_float(); return true;
    case w::fog_alt: fog.alt = read_float(); return true;
    case w::up: fog.up = read_vector(); return true;
    case w::turb_depth: fog.turb_depth = read_float(); return true;
    case w::turbulence: fog.turbulence = read_vector(); break;
    case w::octaves: fog.octaves = std::clamp(static_cast<int>(read_float()), 1, 10); break;
    case w::omega: fog.omega = read_float(); break;
    case w::lambda: fog.lambda = read_float(); break;
    default: return false;
  }
  fog.turbulent = true;
  return true;
}

/// `rainbow { … }` (shading §7.4).
scene::Rainbow Interpreter::read_rainbow(Span span) {
  static constexpr std::string_view settings =
      "direction angle width distance color_map jitter up arc_angle falloff_angle";
  expect_open("rainbow");
  scene::Rainbow bow;
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) break;
    if (t.is_punct(';')) continue;
    const Value* v = t.kind == Token::Kind::expr ? lookup(*t.tree, t.expr, false) : nullptr;
    if (v != nullptr && v->get<Shared<scene::Rainbow>>() != nullptr) {
      bow = **v->get<Shared<scene::Rainbow>>();
      continue;
    }
    if (t.kind != Token::Kind::word) bad_setting(t, "rainbow", span, settings);
    switch (t.word) {
      case w::direction: bow.direction = read_vector(); break;
      case w::up: bow.up = read_vector(); break;
      case w::angle: bow.angle_deg = read_float(); break;
      case w::width: bow.width_deg = read_float(); break;
      case w::distance: bow.distance = read_float(); break;
      case w::jitter: bow.jitter = read_float(); break;
      case w::arc_angle: bow.arc_angle_deg = read_float(); break;
      case w::falloff_angle: bow.falloff_angle_deg = read_float(); break;
      case w::color_map:
      case w::colour_map: bow.colours = read_colour_map().entries; break;
      default: bad_setting(t, "rainbow", span, settings);
    }
  }
  check_rainbow(bow, span);
  bow.origin = origin(span);
  return bow;
}

void Interpreter::check_rainbow(scene::Rainbow& bow, Span span) {
  const auto tiny = [](dvec3 v) { return glm::dot(v, v) < epsilon; };
  if (tiny(bow.direction)) fail(Code::missing_argument, span, "`rainbow` needs a `direction`");
  if (tiny(bow.up)) fail(Code::degenerate, span, "`up` of a rainbow must not be zero");
  bow.direction = glm::normalize(bow.direction);
  bow.up = glm::normalize(bow.up);
  if (tiny(glm::cross(bow.direction, bow.up))) {
    fail(Code::degenerate, span, "`direction` and `up` of a rainbow must not be parallel");
  }
  const auto out_of_turn = [](double angle) { return !(angle >= 0 && angle <= 360); };
  if (out_of_turn(bow.arc_angle_deg) || out_of_turn(bow.falloff_angle_deg)) {
    fail(Code::out_of_range, span, "angles of a rainbow's arc are 0 to 360 degrees");
  }
  // Without a `falloff_angle` nothing fades.
  if (bow.falloff_angle_deg == scene::Rainbow{}.falloff_angle_deg) {
    bow.falloff_angle_deg = bow.arc_angle_deg;
  }
  if (bow.arc_angle_deg < bow.falloff_angle_deg) {
    fail(Code::out_of_range, span, "`arc_angle` of a rainbow must not be below its `falloff_angle`");
  }
}

}  // namespace durer::interpreter
