// Finishes, interiors and materials (shading §4.1, §5.1).
#include <fmt/format.h>

#include <cmath>

#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;

// ---- finishes (shading §4.1)
// --------------------------------------------------------------------------

scene::Finish Interpreter::read_finish(scene::Finish f) {
  static constexpr std::string_view settings =
      "ambient emission diffuse brilliance phong phong_size specular roughness metallic crand "
      "conserve_energy reflection reflection_exponent irid subsurface ior caustics refraction";
  const Span opened = peek().span;
  expect_open("finish");
  bool diffuse_albedo = false;
  bool phong_albedo = false;
  bool specular_albedo = false;
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) break;
    if (t.is_punct(';')) continue;
    if (t.kind == Token::Kind::expr) {
      const Value* v = lookup(*t.tree, t.expr, false);
      const auto* ref = v == nullptr ? nullptr : v->get<Boxed<scene::Finish>>();
      if (ref == nullptr) bad_setting(t, "finish", opened, settings);
      f = **ref;
      continue;
    }
    if (t.kind != Token::Kind::word) bad_setting(t, "finish", opened, settings);
    const auto number = [&] { return static_cast<float>(read_float()); };
    switch (t.word) {
      case w::ambient: f.ambient = read_rgb(); break;
      case w::emission: f.emission = read_rgb(); break;
      case w::diffuse:
        diffuse_albedo = accept(w::albedo);
        f.diffuse = number();
        f.diffuse_back = 0;
        optional_comma();
        if (starts_number(peek())) f.diffuse_back = number();
        f.indirect = f.diffuse;
        f.indirect_back = f.diffuse_back;
        break;
      case w::brilliance: f.brilliance = number(); break;
      case w::phong:
        phong_albedo = accept(w::albedo);
        f.phong = number();
        break;
      case w::phong_size: f.phong_size = number(); break;
      case w::specular:
        specular_albedo = accept(w::albedo);
        f.specular = number();
        break;
      case w::roughness:
        f.roughness = number();
        if (f.roughness == 0) warn(Code::out_of_range, t.span, "`roughness 0` makes no highlight");
        break;
      case w::metallic: f.metallic = starts_number(peek()) ? number() : 1; break;
      case w::crand: f.crand = number(); break;
      case w::conserve_energy: f.conserve_energy = true; break;
      case w::reflection: read_reflection(f); break;
      case w::reflection_exponent: f.reflection_exponent = number(); break;
      case w::irid: {
        expect_open("irid");
        f.irid = number();
        for (Token i = next(); i.kind != Token::Kind::close; i = next()) {
          if (i.is(w::thickness)) {
            f.irid_thickness = number();
          } else if (i.is(w::turbulence)) {
            f.irid_turbulence = static_cast<float>(read_vector().x);
          } else {
            unexpected(i, "`thickness` or `turbulence`");
          }
        }
        break;
      }
      case w::subsurface: read_translucency(f, t); break;
      case w::ior: f.ior = number(); break;
      case w::caustics: f.caustics = number(); break;
      case w::refraction: f.refraction = number(); break;
      default: bad_setting(t, "finish", opened, settings);
    }
  }
  // `albedo` uses the final exponents, whatever the order they were written in.
  if (diffuse_albedo) {
    f.diffuse *= (f.brilliance + 1) / 2;
    f.diffuse_back *= (f.brilliance + 1) / 2;
  }
  if (phong_albedo) f.phong *= (f.phong_size + 1) / 2;
  if (specular_albedo) {
    const double m = f.roughness == 0 ? 0.0 : 1.0 / f.roughness;
    f.specular *= static_cast<float>((m + 2) / (4 * (2 - std::exp2(-m / 2))));
  }
  return f;
}

/// `reflection c` or `reflection { c1, c2 fresnel … }`.
void Interpreter::read_reflection(scene::Finish& f) {
  f.reflection_falloff = 1;
  f.fresnel = false;
  if (raw_next().kind != Token::Kind::open) {
    f.reflection_min = f.reflection_max = read_rgb();
    return;
  }
  next();
  f.reflection_exponent = 1;
  f.reflection_metallic = 0;
  f.reflection_max = read_rgb();
  f.reflection_min = f.reflection_max;
  bool two = false;
  optional_comma();
  if (const Token t = peek(); starts_colour(t) || starts_number(t)) {
    f.reflection_max = read_rgb();
    two = true;
  }
  for (Token t = next(); t.kind != Token::Kind::close; t = next()) {
    const auto number = [&] { return static_cast<float>(read_float()); };
    if (t.is_punct(';')) continue;
    if (t.is(w::fresnel)) {
      const float on = starts_number(peek()) ? number() : 1;
      if (on != 0 && on != 1) {
        fail(Code::out_of_range, t.span, "`fresnel` is 0 or 1");
      }
      f.fresnel = on == 1;
    } else if (t.is(w::falloff)) {
      f.reflection_falloff = number();
    } else if (t.is(w::exponent)) {
      f.reflection_exponent = number();
    } else if (t.is(w::metallic)) {
      f.reflection_metallic = starts_number(peek()) ? number() : 1;
    } else {
      unexpected(t, "a setting of `reflection`");
    }
  }
  if (f.fresnel && !two) f.reflection_min = vec3(0.0F);
}

// ---- interiors and materials
// ---------------------------------------------------------------------------

scene::InteriorId Interpreter::read_interior() {
  static constexpr std::string_view settings =
      "ior dispersion dispersion_samples caustics fade_distance fade_power fade_color refraction "
      "media";
  const Span opened = peek().span;
  expect_open("interior");
  scene::Interior i;
  i.origin = origin(peek().span);
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) break;
    if (t.is_punct(';')) continue;
    if (t.kind == Token::Kind::expr) {
      const Value* v = lookup(*t.tree, t.expr, false);
      if (v != nullptr && v->get<InteriorRef>() != nullptr) {
        i = scene_.interiors[v->get<InteriorRef>()->id];
      } else if (v != nullptr && v->get<Shared<Unsupported>>() != nullptr) {
        i.unsupported = (*v->get<Shared<Unsupported>>())->feature;
      } else {
        bad_setting(t, "interior", opened, settings);
      }
      continue;
    }
    if (t.kind != Token::Kind::word) bad_setting(t, "interior", opened, settings);
    switch (t.word) {
      case w::ior: i.ior = read_float(); break;
      case w::dispersion: i.dispersion = read_float(); break;
      case w::dispersion_samples:
        i.dispersion_samples = static_cast<int>(read_float());
        if (i.dispersion_samples < 2)
          fail(Code::out_of_range, t.span, "`dispersion_samples` must be at least 2");
        break;
      case w::caustics: i.caustics = static_cast<float>(read_float()); break;
      case w::fade_distance: i.fade_distance = read_float(); break;
      case w::fade_power: i.fade_power = read_float(); break;
      case w::fade_color:
      case w::fade_colour: i.fade_colour = read_rgb(); break;
      case w::refraction: i.refraction = static_cast<float>(read_float()); break;
      case w::media: i.media.edit().push_back(read_media(t.span)); break;
      default: bad_setting(t, "interior", opened, settings);
    }
  }
  scene_.interiors.push_back(std::move(i));
  return static_cast<scene::InteriorId>(scene_.interiors.size() - 1);
}

/// An interior as it is after a transformation; itself if it has nothing to be moved.
scene::InteriorId Interpreter::moved_interior(scene::InteriorId id, const Transform& by) {
  if (id == scene::none || scene_.interiors[id].media->empty()) return id;
  scene::Interior moved = scene_.interiors[id];
  for (scene::Media& m : moved.media.edit()) move_densities(m, by);
  scene_.interiors.push_back(std::move(moved));
  return static_cast<scene::InteriorId>(scene_.interiors.size() - 1);
}

Material Interpreter::read_material() {
  expect_open("material");
  Material m;
  scene::TextureUse texture;
  scene::TextureUse inner;
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) break;
    if (t.is_punct(';')) continue;
    if (t.kind == Token::Kind::expr) {
      const Value* v = lookup(*t.tree, t.expr, true);
      const auto* ref = v == nullptr ? nullptr : v->get<Shared<Material>>();
      if (ref == nullptr) unexpected(t, "a material, texture or interior");
      m = **ref;
      texture = {m.texture, {}};
      inner = {m.interior_texture, {}};
      continue;
    }
    if (const auto transform = read_transformation(t)) {
      // Moves the texture and what is inside, but not the interior texture (textures §14.3).
      texture.transform = texture.transform.then(*transform);
      m.interior = moved_interior(m.interior, *transform);
      continue;
    }
    if (t.is(w::texture)) {
      add_layers(texture, read_texture("texture"));
    } else if (t.is(w::interior_texture)) {
      add_layers(inner, read_texture("interior_texture"));
    } else if (t.is(w::interior)) {
      m.interior = read_interior();
    } else if (t.is(w::pigment) || t.is(w::finish) || t.is(w::normal)) {
      edit_texture(texture, t);
    } else {
      unexpected(t, "a texture, interior or transformation in `material`");
    }
  }
  own_texture_ = scene::none;
  const auto settle = [&](const scene::TextureUse& use) {
    if (use.texture == scene::none || use.transform.is_identity()) return use.texture;
    return add_texture(materialize(use));
  };
  m.texture = settle(texture);
  m.interior_texture = settle(inner);
  return m;
}

}  // namespace durer::interpreter
