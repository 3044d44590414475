// Matter that rays travel through: which bodies a ray is inside of, how it bends between them, and
// what the way through them costs (shading §5).
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <span>

#include "base/vec.h"
#include "scene/texture.h"
#include "tracer/shading/media.h"

namespace durer::tracer {

/// One body of matter, compiled from its interior and the legacy words of its finish.
struct Interior {
  double ior = 1;
  double dispersion = 1;
  int dispersion_samples = 7;
  double caustics = 0;  // exponent of the factor; 0: none
  double fade_distance = 0;
  double fade_power = 0;
  vec3 fade_colour{0.0F};
  float refraction = 1;
  bool hollow = false;
  MediaRange media;
};

/// `finish`: of the outermost layer of the body's texture, or null if its texture is patterned.
[[nodiscard]] Interior compile_interior(const scene::Interior* interior, bool hollow,
                                        const scene::Finish* finish);

/// The bodies a ray is inside of, in the order of entering; the last one is the innermost. Ids are
/// indices of interior instances. Room is for far more bodies than a scene nests; entering another
/// one then has no effect.
class Containment {
 public:
  static constexpr std::size_t capacity = 128;

  Containment() { std::memset(ids_.data(), 0, usual * sizeof ids_[0]); }
  Containment(const Containment& other) : size_(other.size_) { copy(other); }
  Containment& operator=(const Containment& other) {
    size_ = other.size_;
    copy(other);
    return *this;
  }

  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::uint32_t innermost() const { return ids_[size_ - 1]; }
  [[nodiscard]] std::span<const std::uint32_t> ids() const { return {ids_.data(), size_}; }
  [[nodiscard]] bool contains(std::uint32_t id) const { return first(id) < size_; }
  void append(std::uint32_t id) {
    if (size_ < capacity) ids_[size_++] = id;
  }
  /// Removes the first occurrence of `id`; false if there is none.
  bool remove(std::uint32_t id) {
    std::uint32_t i = first(id);
    if (i == size_) return false;
    for (--size_; i < size_; ++i) ids_[i] = ids_[i + 1];
    return true;
  }
  /// Leaves the body if the ray is inside of it, else enters it.
  void toggle(std::uint32_t id) {
    if (!remove(id)) append(id);
  }
  /// Where `id` occurs first in ids(); their number if it does not.
  [[nodiscard]] std::uint32_t first(std::uint32_t id) const {
    std::uint32_t i = 0;
    while (i < size_ && ids_[i] != id) ++i;
    return i;
  }

 private:
  static constexpr std::uint32_t usual = 4;  // these are copied as one block, however many are set

  void copy(const Containment& other) {
    std::memcpy(ids_.data(), other.ids_.data(), usual * sizeof ids_[0]);
    for (std::uint32_t i = usual; i < size_; ++i) ids_[i] = other.ids_[i];
  }

  std::uint32_t size_ = 0;
  std::array<std::uint32_t, capacity> ids_;  // beyond `usual`, only the first size_ are set
};

/// Ratio of two media across a surface, n before over n behind.
struct IndexRatio {
  double ior = 1;
  double dispersion = 1;
};

/// Passes through a surface of body `id`: changes `inside` and returns the ratio (shading §5.1).
IndexRatio pass(std::span<const Interior> interiors, std::uint32_t id, Containment& inside);
/// The ratio alone, as it would be.
[[nodiscard]] IndexRatio index_ratio(std::span<const Interior> interiors, std::uint32_t id,
                                     const Containment& inside);

/// n behind over n before a surface, as fresnel reflection sees it (shading §4.8).
[[nodiscard]] double fresnel_index(std::span<const Interior> interiors, std::uint32_t id,
                                   const Containment& inside);

/// What remains of light after `depth` world units inside; only if the body fades at all.
[[nodiscard]] vec3 fade(const Interior& interior, double depth);
[[nodiscard]] inline bool fades(const Interior& interior) {
  return interior.fade_distance > epsilon || interior.fade_distance < -epsilon;
}

}  // namespace durer::tracer
