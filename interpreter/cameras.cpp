// Cameras (shading §2.1, §2.2).
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "interpreter/camera.h"
#include "interpreter/interpreter.h"
#include "scene/fields.h"

namespace durer::interpreter {

namespace w = grammar::words;

namespace {

using Kind = scene::Camera::Kind;

/// The kind that a word names.
std::optional<Kind> camera_kind(std::string_view word) {
  const auto& names = scene::Words<Kind>::all;
  const auto found = std::find(names.begin(), names.end(), word);
  if (found == names.end()) return std::nullopt;
  return static_cast<Kind>(found - names.begin());
}

/// Kinds whose angle is that of their vectors.
bool is_flat(Kind kind) { return kind == Kind::perspective || kind == Kind::orthographic; }

constexpr std::string_view camera_settings =
    "perspective orthographic fisheye ultra_wide_angle omnimax panoramic cylinder spherical "
    "location "
    "direction right up sky look_at angle aperture blur_samples focal_point confidence variance "
    "bokeh mesh_camera normal translate rotate scale matrix transform";
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
    if (const auto kind = camera_kind(name_of(t.word)); kind && t.word != w::mesh_camera) {
      c.kind = *kind;
      if (t.word == w::cylinder) read_cylinder_type(c, t.span);
      continue;
    }
    switch (t.word) {
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
        if (c.kind != scene::Camera::Kind::spherical) break;
        optional_comma();
        c.vertical_angle_deg = starts_number(peek()) ? read_float() : a / 2;
        break;
      }
      case w::aperture: c.lens.edit().aperture = read_float(); break;
      case w::blur_samples: read_blur_samples(c.lens.edit(), t.span); break;
      case w::focal_point: c.focal_point = read_vector(); break;
      case w::confidence: {
        const double x = read_float();
        if (x > 0 && x < 1) {
          c.lens.edit().confidence = x;
        } else {
          warn(Code::out_of_range, t.span, "`confidence` is between 0 and 1; it stays as it was");
        }
        break;
      }
      case w::variance: {
        const double x = read_float();
        if (x >= 0 && x <= 1) {
          c.lens.edit().variance = x;
        } else {
          warn(Code::out_of_range, t.span, "`variance` is 0 to 1; it stays as it was");
        }
        break;
      }
      case w::bokeh: {
        expect_open("bokeh");
        const Token pigment = next();
        if (!pigment.is(w::pigment)) unexpected(pigment, "`pigment` in `bokeh`");
        scene::Lens& lens = c.lens.edit();
        lens.bokeh = read_pigment(*scene_.textures[default_texture_].layers.back().pigment);
        lens.has_bokeh = true;
        expect_close("bokeh", t.span);
        break;
      }
      case w::normal: c.normal = read_normal(default_normal()); break;
      case w::mesh_camera:
        c.kind = scene::Camera::Kind::mesh_camera;
        read_mesh_camera(c, t.span);
        break;
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

void Interpreter::read_cylinder_type(CameraSpec& c, Span span) {
  const double type = read_float();
  c.cylinder_type = static_cast<int>(type);
  if (c.cylinder_type < 1 || c.cylinder_type > 4) {
    fail(Code::out_of_range, span, "a `cylinder` camera is of type 1, 2, 3 or 4");
  }
}

/// `blur_samples MOST` or `blur_samples LEAST, MOST`.
void Interpreter::read_blur_samples(scene::Lens& lens, Span span) {
  lens.least_samples = 0;
  lens.most_samples = static_cast<int>(read_float());
  optional_comma();
  if (starts_number(peek())) {
    lens.least_samples = lens.most_samples;
    lens.most_samples = static_cast<int>(read_float());
  }
  if (lens.most_samples <= 0 || lens.least_samples < 0) {
    fail(Code::out_of_range, span, "`blur_samples` must be positive");
  }
  if (lens.least_samples > lens.most_samples) {
    fail(Code::out_of_range, span, "the first number of `blur_samples` must not exceed the second");
  }
}

/// `mesh_camera { rays distribution [max distance] meshes [smooth] }` (shading §2.5).
void Interpreter::read_mesh_camera(CameraSpec& c, Span span) {
  expect_open("mesh_camera");
  scene::MeshCamera m;
  m.rays = static_cast<int>(read_float());
  optional_comma();
  m.distribution = static_cast<int>(read_float());
  optional_comma();
  if (starts_number(peek())) m.reach = read_float();
  const auto need = [&](bool ok, const char* message) {
    if (!ok) fail(Code::out_of_range, span, message);
  };
  need(m.rays > 0, "a `mesh_camera` has at least one ray per pixel");
  need(m.distribution >= 0 && m.distribution <= 3, "`mesh_camera` knows the distributions 0 to 3");
  need(m.rays == 1 || m.distribution < 2, "this distribution of a `mesh_camera` has one ray per pixel");
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) break;
    if (t.is_punct(';')) continue;
    if (t.is(w::smooth)) {
      need(m.distribution == 3, "`smooth` goes with distribution 3 of a `mesh_camera` alone");
      m.smooth = true;
      continue;
    }
    const Value* v = t.is_place() ? lookup(*t.tree, t.expr, true) : nullptr;
    scene::ObjectId id = scene::none;
    if (v != nullptr && v->get<ObjectRef>() != nullptr) {
      id = v->get<ObjectRef>()->id;
    } else if (starts_object(t)) {
      id = read_object(t);
    }
    if (id == scene::none || scene_.objects[id].extras->mesh == nullptr) {
      unexpected(t, "a mesh in `mesh_camera`");
    }
    m.meshes.push_back(scene_.objects[id].extras->mesh);
    m.transforms.push_back(scene_.objects[id].transform);
  }
  need(!m.meshes.empty(), "`mesh_camera` needs a mesh");
  need(m.distribution != 0 || static_cast<std::size_t>(m.rays) <= m.meshes.size(),
       "distribution 0 of a `mesh_camera` needs a mesh for every ray");
  c.mesh = Boxed<scene::MeshCamera>(std::move(m));
}

/// Angle, look_at, scaling of orthographic views and transformations, in this order (shading §2.2).
scene::Camera Interpreter::finish_camera(const CameraSpec& c) {
  dvec3 direction = c.direction;
  dvec3 right = c.right;
  dvec3 up = c.up;
  const auto deg = 3.14159265358979323846 / 180;
  if (is_flat(c.kind) && c.angle_deg && *c.angle_deg > 0) {
    if (*c.angle_deg >= 180)
      fail(Code::out_of_range, c.span, "`angle` must be below 180 degrees for this camera");
    direction =
        glm::normalize(direction) * (glm::length(right) / (2 * std::tan(*c.angle_deg * deg / 2)));
  }
  double focal_distance = is_flat(c.kind) && c.angle_deg ? glm::length(direction) : 1;
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
    focal_distance = ld;
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
  if (c.angle_deg && *c.angle_deg > 0) out.angle_deg = *c.angle_deg;
  if (c.kind == Kind::spherical) {
    out.angle_deg = c.angle_deg.value_or(360);
    out.vertical_angle_deg = c.vertical_angle_deg.value_or(180);
  }
  out.cylinder_type = c.cylinder_type;
  out.normal = c.normal;
  out.mesh = c.mesh;
  out.lens = c.lens;
  if (c.lens->aperture != 0) {
    if (c.focal_point) focal_distance = glm::length(*c.focal_point - c.location);
    out.lens.edit().focal_distance = focal_distance == 0 ? 1 : focal_distance;
  }
  out.origin = c.origin;
  return out;
}

}  // namespace durer::interpreter
