// Scenes by hand, for tests: short words for the common cases, plain data for the rest.
#pragma once

#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace durer::test {

/// Colour with filter and transmit.
[[nodiscard]] inline Colour rgbft(float r, float g, float b, float f = 0, float t = 0) {
  return {vec3(r, g, b), f, t};
}

/// A plain pigment.
[[nodiscard]] inline scene::Pigment plain(const Colour& colour) {
  scene::Pigment p;
  p.colour = colour;
  return p;
}

/// A finish that neither glows nor answers to lights.
[[nodiscard]] inline scene::Finish dull() {
  scene::Finish f;
  f.ambient = vec3(0.0F);
  f.diffuse = 0;
  return f;
}

/// A finish that shows the pigment as it is.
[[nodiscard]] inline scene::Finish luminous() {
  scene::Finish f = dull();
  f.emission = vec3(1.0F);
  return f;
}

/// Builds a scene; language version 3.7 and linear numbers unless changed.
class SceneBuilder {
 public:
  explicit SceneBuilder(const scene::Registry& registry) : registry_(&registry) {
    scene.settings.effective_version = 370;
    scene.settings.gamma_mode = scene::GammaMode::explicit_;
    scene.background = rgbft(0, 0, 0);
  }

  scene::Scene scene;

  scene::TextureId texture(const scene::Pigment& pigment, const scene::Finish& finish) {
    return layers({{pigment, finish, {}}});
  }
  /// Innermost first, as written.
  scene::TextureId layers(std::vector<scene::Layer> all) {
    scene.textures.push_back({std::move(all), 0, {}});
    return static_cast<scene::TextureId>(scene.textures.size() - 1);
  }
  scene::InteriorId interior(const scene::Interior& interior) {
    scene.interiors.push_back(interior);
    return static_cast<scene::InteriorId>(scene.interiors.size() - 1);
  }
  /// A primitive by the language's name, as an object of the top level. Change it right away:
  /// the reference lives until the next object is added.
  scene::Object& add(std::string_view type, std::vector<double> args, scene::TextureId texture,
                     scene::InteriorId interior = scene::none) {
    scene::Object object;
    object.type = primitive(type);
    args.resize(registry_->primitives[object.type]->arg_count());
    object.args = args;
    object.texture.texture = texture;
    object.interior = interior;
    return root(object);
  }
  /// Any node, as an object of the top level.
  scene::Object& root(const scene::Object& object) {
    scene.objects.push_back(object);
    scene.roots.push_back({static_cast<scene::ObjectId>(scene.objects.size() - 1), scene::none});
    return scene.objects.back();
  }
  scene::Light& light(dvec3 position, vec3 colour = vec3(1.0F)) {
    scene::Light light;
    light.position = position;
    light.colour = colour;
    scene.lights.push_back(light);
    scene::Object node;
    node.kind = scene::NodeKind::light;
    node.light = static_cast<scene::LightId>(scene.lights.size() - 1);
    root(node);
    return scene.lights.back();
  }
  /// Looks from `location` at `target`, the picture `angle_deg` wide; both sides of unit aspect.
  void look(dvec3 location, dvec3 target, double angle_deg = 1) {
    scene::Camera& c = scene.camera;
    c.location = location;
    c.direction = glm::normalize(target - location);
    const dvec3 sky = std::abs(c.direction.y) > 0.999 ? dvec3(0, 0, 1) : dvec3(0, 1, 0);
    c.right = glm::normalize(glm::cross(sky, c.direction));
    c.up = glm::cross(c.direction, c.right);
    c.direction *= 0.5 / std::tan(glm::radians(angle_deg) / 2);
  }
  /// Parallel rays, the picture `size` wide and high.
  void look_straight(dvec3 location, dvec3 direction, double size = 1e-3) {
    look(location, location + direction);
    scene::Camera& c = scene.camera;
    c.kind = scene::Camera::Kind::orthographic;
    c.direction = direction;
    c.right *= size;
    c.up *= size;
  }

  [[nodiscard]] std::uint32_t primitive(std::string_view name) const {
    return index_of(registry_->primitives, name);
  }
  [[nodiscard]] std::uint32_t pattern(std::string_view name) const {
    return index_of(registry_->patterns, name);
  }

 private:
  template <typename Types>
  static std::uint32_t index_of(const Types& types, std::string_view name) {
    for (std::size_t i = 0; i < types.size(); ++i) {
      if (types[i]->name == name) return static_cast<std::uint32_t>(i);
    }
    std::abort();  // a test that asks for what is not there
  }

  const scene::Registry* registry_;
};

}  // namespace durer::test
