// Transfer curves between stored numbers and light (shading §1.2, §1.5).
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>

namespace durer {

/// The IEC 61966-2-1 curve or a power law; `linear` is the exact identity.
struct GammaCurve {
  enum class Kind : std::uint8_t { linear, power, srgb };
  Kind kind = Kind::linear;
  float gamma = 1;  // power: decoding exponent

  /// A power law; becomes the identity when |1 - 1/gamma| <= 0.01.
  [[nodiscard]] static GammaCurve power(float gamma);
  [[nodiscard]] static GammaCurve srgb() { return {Kind::srgb, 2.2F}; }

  /// Stored number → linear light. Power laws take max(x, 0); sRGB is linear below 0.
  [[nodiscard]] float decode(float x) const;
  /// Linear light → stored number.
  [[nodiscard]] float encode(float x) const;
  [[nodiscard]] glm::vec3 decode(const glm::vec3& c) const {
    return {decode(c.x), decode(c.y), decode(c.z)};
  }
  [[nodiscard]] glm::vec3 encode(const glm::vec3& c) const {
    return {encode(c.x), encode(c.y), encode(c.z)};
  }
  friend bool operator==(const GammaCurve&, const GammaCurve&) = default;
};

/// Number in space `from` → the same light in space `to`. Equal curves give the identity, two power
/// laws combine into one (identity within 1 %).
[[nodiscard]] float transcode(const GammaCurve& from, const GammaCurve& to, float x);

}  // namespace durer
