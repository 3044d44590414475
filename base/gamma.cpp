#include "base/gamma.h"

#include <algorithm>

namespace durer {

GammaCurve GammaCurve::power(float gamma) {
  if (std::abs(1 - 1 / gamma) <= 0.01F) return {};
  return {Kind::power, gamma};
}

float GammaCurve::decode(float x) const {
  switch (kind) {
    case Kind::linear: return x;
    case Kind::power: return std::pow(std::max(x, 0.0F), gamma);
    case Kind::srgb: return x < 0.04045F ? x / 12.92F : std::pow((x + 0.055F) / 1.055F, 2.4F);
  }
  return x;
}

float GammaCurve::encode(float x) const {
  switch (kind) {
    case Kind::linear: return x;
    case Kind::power: return std::pow(std::max(x, 0.0F), 1 / gamma);
    case Kind::srgb: return x <= 0.0031308F ? 12.92F * x : 1.055F * std::pow(x, 1 / 2.4F) - 0.055F;
  }
  return x;
}

float transcode(const GammaCurve& from, const GammaCurve& to, float x) {
  using Kind = GammaCurve::Kind;
  if (from == to) return x;
  const bool powers = from.kind != Kind::srgb && to.kind != Kind::srgb;
  if (powers) {
    const float exponent = from.gamma / to.gamma;
    if (std::abs(1 - exponent) <= 0.01F) return x;
    return std::pow(std::max(x, 0.0F), exponent);
  }
  return to.encode(from.decode(x));
}

}  // namespace durer
