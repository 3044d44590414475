// Lights, cameras, backgrounds, global settings: the things of a scene that are no objects (shading
// §2, §6.1, §7.1; language §8).
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "interpreter/camera.h"
#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;

// ---- lights
// -----------------------------------------------------------------------------------------

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

void Interpreter::read_light_items(scene::Object& o, scene::Light& l, const Token& word) {
  bool aimed = l.kind == scene::Light::Kind::spotlight || l.parallel;
  bool cylinder = false;
  const auto unsupported = [&](std::string_view what) {
    if (o.extras->unsupported.empty()) o.extras.edit().unsupported = what;
  };
  const auto needs_aim = [&](const Token& t) {
    if (aimed || cylinder) return;
    fail(Code::unexpected_item, t.span,
         fmt::format("`{}` makes no sense in a point light", name_of(t.word)),
         "write `spotlight` before it");
  };
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) return;
    if (t.is_punct(';')) continue;
    if (const auto transform = read_transformation(t)) {
      o.transform = o.transform.then(*transform);
      continue;
    }
    static constexpr std::string_view settings =
        "spotlight cylinder parallel shadowless point_at radius falloff tightness area_light "
        "adaptive "
        "jitter circular orient area_illumination fade_distance fade_power media_attenuation "
        "media_interaction looks_like projected_through translate rotate scale transform";
    if (t.kind != Token::Kind::word) bad_setting(t, "light_source", word.span, settings);
    switch (t.word) {
      case w::spotlight:
        l.kind = scene::Light::Kind::spotlight;
        l.radius_deg = 30;
        l.falloff_deg = 45;
        l.tightness = 0;
        aimed = true;
        break;
      case w::parallel: l.parallel = aimed = true; break;
      case w::shadowless: l.shadowless = true; break;
      case w::point_at:
        needs_aim(t);
        l.point_at = read_vector();
        break;
      case w::radius:
        needs_aim(t);
        l.radius_deg = read_float();
        break;
      case w::falloff:
        needs_aim(t);
        l.falloff_deg = read_float();
        break;
      case w::tightness:
        needs_aim(t);
        l.tightness = read_float();
        break;
      case w::fade_distance: l.fade_distance = read_float(); break;
      case w::fade_power: l.fade_power = read_float(); break;
      case w::media_attenuation: l.media_attenuation = read_switch(true); break;
      case w::media_interaction: l.media_interaction = read_switch(true); break;
      case w::cylinder:
        cylinder = true;
        unsupported("a cylinder light");
        break;
      case w::area_light:
        unsupported("`area_light`");
        read_vector();
        optional_comma();
        read_vector();
        optional_comma();
        read_float();
        optional_comma();
        read_float();
        break;
      case w::adaptive: read_float(); break;  // of area lights, like the next four
      case w::jitter:
      case w::circular:
      case w::orient: break;
      case w::area_illumination: read_switch(true); break;
      case w::looks_like:
      case w::projected_through: {
        unsupported(fmt::format("`{}` of a light source", name_of(t.word)));
        expect_open(name_of(t.word));
        skip_block();
        break;
      }
      case w::photons:
        expect_open("photons");
        skip_block();
        break;
      case w::color_map:
      case w::colour_map:
        unsupported("a colour map in a light source");
        read_colour_map();
        break;
      default: bad_setting(t, "light_source", word.span, settings);
    }
  }
}

// ---- cameras
// ----------------------------------------------------------------------------------------

namespace {
constexpr std::string_view camera_settings =
    "perspective orthographic fisheye ultra_wide_angle omnimax panoramic cylinder spherical "
    "location "
    "direction right up sky look_at angle aperture blur_samples focal_point confidence variance "
    "bokeh "
    "normal translate rotate scale matrix transform";
}  // namespace

Shared<CameraSpec> Interpreter::read_camera(Span span) {
  expect_open("camera");
  CameraSpec c = default_camera_ ? *default_camera_ : CameraSpec{};
  c.span = span;
  c.origin = origin(span);
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) break;
    if (t.is_punct(';')) continue;
    if (const auto transform = read_transformation(t)) {
      c.transform = c.transform.then(*transform);
      continue;
    }
    if (t.kind == Token::Kind::expr) {
      if (const auto* name = t.node<ast::Name>();
          name != nullptr && name->name == grammar::additions::user_defined && version() >= 380) {
        c.kind = scene::Camera::Kind::user_defined;
        continue;
      }
      const Value* v = lookup(*t.tree, t.expr, false);
      const auto* ref = v == nullptr ? nullptr : v->get<Shared<CameraSpec>>();
      if (ref == nullptr) bad_setting(t, "camera", span, camera_settings);
      c = **ref;
      continue;
    }
    if (t.kind != Token::Kind::word) bad_setting(t, "camera", span, camera_settings);
    switch (t.word) {
      case w::perspective: c.kind = scene::Camera::Kind::perspective; break;
      case w::orthographic: c.kind = scene::Camera::Kind::orthographic; break;
      case w::location:
        if (!read_camera_functions(c, c.location_functions)) c.location = read_vector();
        break;
      case w::direction:
        if (!read_camera_functions(c, c.direction_functions)) c.direction = read_vector();
        break;
      case w::right:
        c.right = read_vector();
        c.right_or_up_given = true;
        break;
      case w::up:
        c.up = read_vector();
        c.right_or_up_given = true;
        break;
      case w::sky: c.sky = read_vector(); break;
      case w::look_at: c.look_at = read_vector(); break;
      case w::angle: {
        const double a = read_float();
        if (a < 0) fail(Code::out_of_range, t.span, "`angle` must not be negative");
        c.angle_deg = a;
        break;
      }
      case w::aperture:
        if (read_float() != 0) not_supported("focal blur (`aperture`)", t.span);
        break;
      case w::blur_samples:
        read_float();
        optional_comma();
        if (starts_number(peek())) read_float();
        break;
      case w::focal_point: read_vector(); break;  // these act through `aperture` only
      case w::confidence:
      case w::variance: read_float(); break;
      case w::fisheye:
      case w::ultra_wide_angle:
      case w::omnimax:
      case w::panoramic:
      case w::spherical:
      case w::cylinder:
      case w::mesh_camera:
      case w::bokeh:
      case w::normal: not_supported(fmt::format("`{}` in a camera", name_of(t.word)), t.span);
      default: bad_setting(t, "camera", span, camera_settings);
    }
  }
  return std::make_shared<const CameraSpec>(std::move(c));
}

/// `{ function {…} function {…} function {…} }` after `location` or `direction` of a camera that is
/// user_defined (shading §12); false if a vector stands there.
bool Interpreter::read_camera_functions(const CameraSpec& c,
                                        std::array<functions::FunctionRef, 3>& out) {
  if (c.kind != scene::Camera::Kind::user_defined || peek().kind != Token::Kind::open) return false;
  const Token open = next();
  for (functions::FunctionRef& f : out) {
    const Token t = next();
    if (!t.is(w::function)) unexpected(t, "three functions of u and v");
    f = read_scene_function(std::array<SymbolId, 2>{w::u, w::v});
    optional_comma();
  }
  expect_close("camera", open.span);
  return true;
}

/// Angle, look_at, scaling of orthographic views and transformations, in this order (shading §2.2).
scene::Camera Interpreter::finish_camera(const CameraSpec& c) {
  dvec3 direction = c.direction;
  dvec3 right = c.right;
  dvec3 up = c.up;
  const auto deg = 3.14159265358979323846 / 180;
  if (c.angle_deg && *c.angle_deg > 0) {
    if (*c.angle_deg >= 180)
      fail(Code::out_of_range, c.span, "`angle` must be below 180 degrees for this camera");
    direction =
        glm::normalize(direction) * (glm::length(right) / (2 * std::tan(*c.angle_deg * deg / 2)));
  }
  const dvec3 target = c.look_at.value_or(dvec3(0, 0, 1));
  if (c.look_at) {
    const double ld = glm::length(direction);
    const double lr = glm::length(right);
    const double lu = glm::length(up);
    const double handedness = glm::dot(glm::cross(up, direction), right);
    const dvec3 to = *c.look_at - c.location;
    if (glm::dot(to, to) < epsilon) {
      fail(Code::degenerate, c.span, "`look_at` and `location` of the camera are the same point");
    }
    direction = glm::normalize(to);
    const dvec3 across = glm::cross(c.sky, direction);
    if (std::abs(across.x) < epsilon && std::abs(across.y) < epsilon &&
        std::abs(across.z) < epsilon) {
      warn(Code::degenerate, c.span,
           "the camera looks along its `sky` vector; `right` stays as it is", "give another `sky`");
    } else {
      right = across;
    }
    right = glm::normalize(right);
    up = glm::cross(direction, right);
    direction *= ld;
    right *= handedness > 0 ? lr : -lr;
    up *= lu;
  }
  if (c.kind == scene::Camera::Kind::orthographic && (!c.right_or_up_given || c.angle_deg)) {
    const double to = glm::length(target - c.location);
    const double along = glm::length(direction);
    if (to > epsilon && along > epsilon) {
      right *= to / along;
      up *= to / along;
    }
  }
  if (std::abs(glm::dot(right, up)) > epsilon || std::abs(glm::dot(right, direction)) > epsilon ||
      std::abs(glm::dot(up, direction)) > epsilon) {
    warn(Code::scene, c.span, "the camera's `right`, `up` and `direction` are not perpendicular");
  }
  scene::Camera out;
  out.kind = c.kind;
  out.location = c.transform.point(c.location);
  out.direction = c.transform.vector(direction);
  out.right = c.transform.vector(right);
  out.up = c.transform.vector(up);
  if (c.kind == scene::Camera::Kind::user_defined) {
    out.location_functions = c.location_functions;
    out.direction_functions = c.direction_functions;
    out.transform = SharedTransform(c.transform);
  }
  out.origin = c.origin;
  return out;
}

// ---- background and settings
// ---------------------------------------------------------------------------

void Interpreter::read_background() {
  expect_open("background");
  Colour c = read_colour();
  expect_close("background", {});
  // The effective version of this moment decides (shading §7.1).
  const int effective = version_given_ ? declared_version_ : 362;
  if (effective < 370) {
    c.filter = 0;
    c.transmit = options_.output_alpha ? 1.0F : 0.0F;
  } else if (!options_.output_alpha) {
    c.rgb *= 1 - c.transmit;
    c.filter = c.transmit = 0;
  }
  scene_.background = c;
}

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

void Interpreter::read_global_settings(Span span) {
  expect_open("global_settings");
  scene::Settings& s = scene_.settings;
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) return;
    if (t.is_punct(';')) continue;
    static constexpr std::string_view settings =
        "adc_bailout ambient_light assumed_gamma charset hf_gray_16 irid_wavelength "
        "max_intersections "
        "max_trace_level mm_per_unit noise_generator number_of_waves photons radiosity subsurface";
    if (t.kind != Token::Kind::word) bad_setting(t, "global_settings", span, settings);
    switch (t.word) {
      case w::adc_bailout: s.adc_bailout = static_cast<float>(read_float()); break;
      case w::ambient_light: s.ambient_light = read_rgb(); break;
      case w::irid_wavelength: s.irid_wavelength = read_rgb(); break;
      case w::assumed_gamma: read_assumed_gamma(t); break;
      case w::max_trace_level: read_max_trace_level(t); break;
      case w::max_intersections:
        read_float();
        if (version() >= 370) warn(Code::deprecated, t.span, "`max_intersections` has no effect");
        break;
      case w::hf_gray_16:
        read_switch(true);
        warn(Code::deprecated, t.span, "`hf_gray_16` has no effect", "use `Grayscale_Output=on`");
        break;
      case w::mm_per_unit: s.mm_per_unit = read_float(); break;
      case w::noise_generator: {
        const int n = static_cast<int>(read_float());
        if (n < 1 || n > 3) fail(Code::out_of_range, t.span, "`noise_generator` is 1, 2 or 3");
        s.noise_generator = n;
        break;
      }
      case w::number_of_waves:
        s.number_of_waves = static_cast<int>(read_float());
        if (s.number_of_waves <= 0) {
          warn(Code::out_of_range, t.span, "`number_of_waves` must be positive; 1 is used");
          s.number_of_waves = 1;
        }
        break;
      case w::charset:
        if (accept(w::utf8)) {
          charset_ = Charset::utf8;
        } else if (accept(w::ascii)) {
          charset_ = Charset::ascii;
        } else if (accept(w::sys)) {
          charset_ = Charset::system;
        } else {
          unexpected(peek(), "`ascii`, `utf8` or `sys`");
        }
        break;
      case w::photons:
      case w::radiosity:
      case w::subsurface:
        not_supported(fmt::format("`{}` in global_settings", name_of(t.word)), t.span);
      default: bad_setting(t, "global_settings", span, settings);
    }
  }
}

void Interpreter::read_max_trace_level(const Token& word) {
  int n = static_cast<int>(read_float());
  if (n > 256) {
    warn(Code::out_of_range, word.span, "`max_trace_level` is at most 256");
    n = 256;
  }
  scene_.settings.max_trace_level = std::max(n, 1);
}

void Interpreter::read_assumed_gamma(const Token& word) {
  GammaCurve curve = GammaCurve::srgb();
  if (!accept(w::srgb)) {
    const double g = read_float();
    if (g <= 0) fail(Code::out_of_range, word.span, "`assumed_gamma` must be positive");
    if (g < 1)
      warn(Code::out_of_range, word.span, "an `assumed_gamma` below 1 is hardly what you want");
    curve = GammaCurve::power(static_cast<float>(g));
  }
  if (assumed_gamma_given_) {
    warn(Code::scene, word.span, "only the first `assumed_gamma` counts");
    return;
  }
  assumed_gamma_given_ = true;
  scene_.settings.assumed_gamma = curve;
}

/// What only the end of the scene decides: gamma mode and effective version (shading §1.1, §1.2).
void Interpreter::finish_settings() {
  scene::Settings& s = scene_.settings;
  s.declared_version = std::max(declared_version_, 350);
  s.effective_version = version_given_ ? s.declared_version : 362;
  const bool modern = s.effective_version >= 370;
  if (assumed_gamma_given_) {
    s.gamma_mode = modern ? scene::GammaMode::explicit_ : scene::GammaMode::legacy;
  } else {
    s.gamma_mode = modern ? scene::GammaMode::implied : scene::GammaMode::off;
    s.assumed_gamma = GammaCurve{};
  }
  if (s.noise_generator == 0) s.noise_generator = declared_version_ >= 350 ? 2 : 1;
  if (scene_.background == Colour{.rgb = vec3(0.0F), .filter = 0, .transmit = 1} &&
      !options_.output_alpha) {
    scene_.background.transmit = 0;
  }
}

}  // namespace durer::interpreter
