// Looking points up in a picture (textures §12).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "base/colour.h"
#include "base/vec.h"
#include "scene/image.h"

namespace durer::tracer {

/// A picture as a texture sees it: numbers of the file become colours through tables.
class ImageSampler {
 public:
  explicit ImageSampler(const scene::Image& image);

  /// Where a point of the pattern's space falls, in pixels from the upper left corner, wrapped into
  /// the picture. Empty where there is nothing to see.
  [[nodiscard]] std::optional<dvec2> locate(dvec3 p) const;

  /// The colour at a place that `locate` found, as `image_map` shows it.
  [[nodiscard]] Colour colour(dvec2 at) const;
  /// How high `bump_map` is there: brightness, or the number in the palette if it wants that.
  [[nodiscard]] double height(dvec2 at) const;
  /// What `image_pattern` makes of it, 0 to 1.
  [[nodiscard]] double value(dvec2 at) const;
  /// The number of a material: that in the palette, or how red it is, 0 to 255.
  [[nodiscard]] int material(dvec2 at) const;

  /// True if no colour lets light through.
  [[nodiscard]] bool opaque() const { return opaque_; }
  /// Pixels of the picture.
  [[nodiscard]] dvec2 size() const { return size_; }

 private:
  // Pixels are numbered row by row.
  [[nodiscard]] std::size_t inside(std::int64_t i, std::int64_t size) const;
  [[nodiscard]] Colour pixel(std::size_t at) const;
  [[nodiscard]] Colour stored_pixel(std::size_t at) const;
  [[nodiscard]] Colour interpolated(dvec2 at) const;
  [[nodiscard]] vec3 plain_interpolated(dvec2 at) const;
  [[nodiscard]] int palette_index(dvec2 at) const;
  template <std::size_t n, typename Visit>
  void weigh_square(std::int64_t x, std::int64_t y, const std::array<double, n>& wx,
                    const std::array<double, n>& wy, Visit visit) const;
  template <typename Sum>
  [[nodiscard]] auto weigh(dvec2 at, Sum sum) const;

  void make_codes();
  void make_palette();

  scene::Image image_;
  const Picture* picture_;
  dvec2 size_;    // of one copy, in pixels
  dvec2 extent_;  // of all copies that `repeat` asks for
  std::int64_t width_, height_;
  std::vector<float> codes_;     // what stored numbers mean; empty: samples are real
  std::vector<Colour> palette_;  // empty: colours are stored in the pixels
  bool has_alpha_ = false;
  bool opaque_ = false;
  bool plain_ = false;  // codes of three channels
};

}  // namespace durer::tracer
