// Colours: five single-precision components in the scene's working space.
#pragma once

#include <glm/vec3.hpp>

namespace durer {

/// Red, green, blue, filter, transmit. Unclamped: negative and greater-than-one values are legal.
struct Colour {
  glm::vec3 rgb{0.0F};
  float filter = 0;
  float transmit = 0;

  /// Share of the light that the surface itself stops, 1 - filter - transmit (shading §0).
  [[nodiscard]] float opacity() const { return 1 - filter - transmit; }
  /// What light is multiplied by when it passes: rgb·filter + transmit (shading §0).
  [[nodiscard]] glm::vec3 transmission() const { return rgb * filter + glm::vec3(transmit); }

  friend bool operator==(const Colour&, const Colour&) = default;
};

/// The only luminance used anywhere (shading §9); not the usual textbook weights.
[[nodiscard]] inline float grey(const glm::vec3& c) {
  return 0.297F * c.x + 0.589F * c.y + 0.114F * c.z;
}

}  // namespace durer
