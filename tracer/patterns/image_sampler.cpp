#include "tracer/patterns/image_sampler.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/gamma.h"
#include "functions/simd/inline.h"
#include "tracer/patterns/remainder.h"
#include "tracer/warps/orientation.h"

namespace durer::tracer {
namespace {

using Projection = scene::Image::Projection;
using Interpolation = scene::Image::Interpolation;

/// A share of a turn around the y axis.
double turn(double x, double z) { return warps::angle_about_y(x, z) / (2 * std::numbers::pi); }

double wrapped(double x, double size) {
  x = remainder_of_single(x, size);
  if (x < 0) x += size;
  return x < size ? x : 0;  // adding may have rounded up
}

/// The oracle keeps grey bytes of PNG files as bytes, of the weighted sum of three equal parts; it
/// is a little less than their value, and what is left behind the point is lost.
float weighed_grey(float x) {
  const float sum = 0.297F * x + 0.589F * x + 0.114F * x;
  return static_cast<float>(static_cast<int>(sum * 255.0F)) / 255.0F;
}

void change(std::vector<Colour>& palette, float Colour::*channel, const std::optional<float>& all,
            const std::vector<scene::PaletteChange>& single) {
  if (all) {
    for (Colour& c : palette) c.*channel = *all;
  }
  for (const scene::PaletteChange& p : single) {
    if (p.index < palette.size()) palette[p.index].*channel = p.value;
  }
}

}  // namespace

ImageSampler::ImageSampler(const scene::Image& image)
    : image_(image),
      picture_(image.picture.get()),
      size_(picture_->width, picture_->height),
      // Products in single precision, as the oracle has them.
      extent_(static_cast<float>(size_.x * image.repeat.x),
              static_cast<float>(size_.y * image.repeat.y)),
      width_(picture_->width),
      height_(picture_->height),
      has_alpha_(picture_->channels % 2 == 0) {
  if (!picture_->is_real()) make_codes();
  if (!picture_->palette.empty()) make_palette();
  opaque_ = !has_alpha_ && !image.once && image.filter_all.value_or(0) == 0 &&
            image.transmit_all.value_or(0) == 0 && image.filter.empty() && image.transmit.empty();
  plain_ = palette_.empty() && !picture_->is_real() && picture_->channels == 3;
}

void ImageSampler::make_codes() {
  const std::size_t count = picture_->bits == 8 ? 256 : 65536;
  const auto most = static_cast<float>(count - 1);
  codes_.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const float x = transcode(image_.stored, image_.working, static_cast<float>(i) / most);
    codes_.push_back(picture_->weighed_grey ? weighed_grey(x) : x);
  }
}

void ImageSampler::make_palette() {
  for (const auto& [red, green, blue, alpha] : picture_->palette) {
    const float transmit = 1 - static_cast<float>(alpha) / 255.0F;
    has_alpha_ = has_alpha_ || alpha != 255;
    palette_.push_back({{codes_[red], codes_[green], codes_[blue]}, 0, transmit});
  }
  change(palette_, &Colour::filter, image_.filter_all, image_.filter);
  change(palette_, &Colour::transmit, image_.transmit_all, image_.transmit);
}

std::optional<dvec2> ImageSampler::locate(dvec3 p) const {
  double u = 0;
  double v = 0;
  switch (image_.projection) {
    case Projection::planar:
      if (image_.once && (p.x < 0 || p.x > 1 || p.y < 0 || p.y > 1)) return std::nullopt;
      u = remainder_of_single(p.x * extent_.x, extent_.x);
      v = remainder_of_single(p.y * extent_.y, extent_.y);
      break;
    case Projection::spherical: {
      const double r = glm::length(p);
      if (r == 0) return std::nullopt;
      p /= r;
      const bool at_pole = p.x == 0 && p.z == 0;
      u = at_pole ? 0 : turn(p.x, p.z) * extent_.x;
      v = (0.5 + std::asin(std::clamp(p.y, -1.0, 1.0)) / std::numbers::pi) * extent_.y;
      break;
    }
    case Projection::cylindrical:
      if (image_.once && (p.y < 0 || p.y > 1)) return std::nullopt;
      if (p.x == 0 && p.z == 0) return std::nullopt;
      u = turn(p.x, p.z) * extent_.x;
      v = remainder_of_single(p.y * extent_.y, extent_.y);
      break;
    case Projection::toroidal: {
      const double l = std::sqrt(p.x * p.x + p.z * p.z);
      if (l == 0) return std::nullopt;
      u = turn(p.x, p.z) * extent_.x;
      const double x = l - 1;
      const double r = std::sqrt(x * x + p.y * p.y);
      double g = r == 0 ? 0 : std::acos(std::clamp(-x / r, -1.0, 1.0));
      if (p.y > 0) g = 2 * std::numbers::pi - g;
      v = g / (2 * std::numbers::pi) * extent_.y;
      break;
    }
  }
  u += epsilon - image_.offset.x * size_.x;
  v += epsilon - image_.offset.y * size_.y;
  if (image_.once && !(u >= 0 && u < size_.x && v >= 0 && v < size_.y)) return std::nullopt;
  return dvec2(wrapped(u, size_.x), wrapped(-v, size_.y));
}

// Columns and rows are at most a few pixels outside.
std::size_t ImageSampler::inside(std::int64_t i, std::int64_t size) const {
  if (image_.once) return static_cast<std::size_t>(std::clamp(i, std::int64_t{0}, size - 1));
  while (i < 0) i += size;
  while (i >= size) i -= size;
  return static_cast<std::size_t>(i);
}

Colour ImageSampler::stored_pixel(std::size_t at) const {
  const std::uint32_t n = picture_->channels;
  at *= n;
  Colour c;
  if (picture_->is_real()) {
    const float* s = &picture_->samples[at];
    const auto decoded = [&](float x) { return transcode(image_.stored, image_.working, x); };
    c.rgb = n < 3 ? vec3(decoded(s[0])) : vec3(decoded(s[0]), decoded(s[1]), decoded(s[2]));
    if (has_alpha_) c.transmit = 1 - s[n - 1];
    return c;
  }
  const std::uint16_t* s = &picture_->codes[at];
  c.rgb = n < 3 ? vec3(codes_[s[0]]) : vec3(codes_[s[0]], codes_[s[1]], codes_[s[2]]);
  if (has_alpha_) {
    c.transmit = 1 - static_cast<float>(s[n - 1]) / (picture_->bits == 8 ? 255.0F : 65535.0F);
  }
  return c;
}

Colour ImageSampler::pixel(std::size_t at) const {
  if (!palette_.empty()) {
    return palette_[std::min<std::size_t>(picture_->codes[at], palette_.size() - 1)];
  }
  return stored_pixel(at);
}

/// Calls visit(pixel, weight) for a square of pixels, of which (x, y) is the upper left one.
template <std::size_t n, typename Visit>
DURER_INLINE void ImageSampler::weigh_square(std::int64_t x, std::int64_t y, const std::array<double, n>& wx,
                                const std::array<double, n>& wy, Visit visit) const {
  std::array<std::size_t, n> columns;
  for (std::size_t i = 0; i < n; ++i) columns[i] = inside(x + static_cast<int>(i), width_);
  for (std::size_t j = 0; j < n; ++j) {
    const std::size_t row = inside(y + static_cast<int>(j), height_) * picture_->width;
    for (std::size_t i = 0; i < n; ++i) visit(row + columns[i], wx[i] * wy[j]);
  }
}

/// Adds the pixels around a place with their weights to `sum` (textures §12.3); gives sum.result().
// The sum is a local copy, so that it stays in registers.
template <typename Sum>
auto ImageSampler::weigh(dvec2 at, Sum sum) const {
  if (image_.interpolation == Interpolation::nearest) {
    sum.add(inside(static_cast<std::int64_t>(at.y), height_) * picture_->width +
                inside(static_cast<std::int64_t>(at.x), width_),
            1.0);
    return sum.result();
  }
  const auto visit = [&](std::size_t pixel, double weight)
                         DURER_LAMBDA_INLINE { sum.add(pixel, weight); };
  // Pixels have their centres at halves.
  const auto i = static_cast<std::int64_t>(at.x + 0.5);
  const auto j = static_cast<std::int64_t>(at.y + 0.5);
  const double p = at.x + 0.5 - static_cast<double>(i);
  const double q = at.y + 0.5 - static_cast<double>(j);
  switch (image_.interpolation) {
    case Interpolation::nearest: break;
    case Interpolation::bilinear:
      weigh_square<2>(i - 1, j - 1, {1 - p, p}, {1 - q, q}, visit);
      break;
    case Interpolation::distance: {
      const auto near = [](double x, double y) { return 1 / (x * x + y * y); };
      // Upper left, upper right, lower left, lower right.
      const std::array<double, 4> w = {near(p, q), near(1 - p, q), near(p, 1 - q),
                                       near(1 - p, 1 - q)};
      const double all = w[3] + w[2] + w[1] + w[0];
      std::size_t next = 0;
      weigh_square<2>(i - 1, j - 1, {1, 1}, {1, 1},
                      [&](std::size_t pixel, double) { visit(pixel, w[next++] / all); });
      break;
    }
    case Interpolation::bicubic: {
      const auto weights = [](double t) {
        const double r = 1 - t;
        return std::array<double, 4>{-0.5 * t * r * r, 0.5 * r * (r * (3 * t + 1) + 1),
                                     0.5 * t * (t * (3 * r + 1) + 1), -0.5 * r * t * t};
      };
      weigh_square<4>(i - 2, j - 2, weights(p), weights(q), visit);
      break;
    }
  }
  return sum.result();
}

Colour ImageSampler::interpolated(dvec2 at) const {
  if (image_.interpolation == Interpolation::nearest) {
    struct Found {
      const ImageSampler& sampler;
      std::size_t place = 0;
      void add(std::size_t pixel, double) { place = pixel; }
      [[nodiscard]] Colour result() const { return sampler.pixel(place); }
    };
    return weigh(at, Found{*this});
  }
  if (plain_) return {plain_interpolated(at), 0, 0};
  struct Sum {
    const ImageSampler& sampler;
    dvec3 rgb{0.0};
    double filter = 0;
    double transmit = 0;
    void add(std::size_t place, double weight) {
      const Colour c = sampler.pixel(place);
      rgb += weight * dvec3(c.rgb);
      filter += weight * c.filter;
      transmit += weight * c.transmit;
    }
    [[nodiscard]] Colour result() const {
      return {vec3(rgb), static_cast<float>(filter), static_cast<float>(transmit)};
    }
  };
  return weigh(at, Sum{*this});
}

/// The same for codes of three channels.
vec3 ImageSampler::plain_interpolated(dvec2 at) const {
  struct Sum {
    const std::uint16_t* stored;
    const float* codes;
    double r = 0;
    double g = 0;
    double b = 0;
    DURER_INLINE void add(std::size_t place, double weight) {
      const std::uint16_t* const s = stored + 3 * place;
      r += weight * static_cast<double>(codes[s[0]]);
      g += weight * static_cast<double>(codes[s[1]]);
      b += weight * static_cast<double>(codes[s[2]]);
    }
    [[nodiscard]] vec3 result() const {
      return {static_cast<float>(r), static_cast<float>(g), static_cast<float>(b)};
    }
  };
  return weigh(at, Sum{picture_->codes.data(), codes_.data()});
}

int ImageSampler::palette_index(dvec2 at) const {
  struct Sum {
    const std::uint16_t* stored;
    double index = 0;
    void add(std::size_t place, double weight) { index += weight * stored[place]; }
    [[nodiscard]] int result() const { return static_cast<int>(index); }
  };
  return weigh(at, Sum{picture_->codes.data()});
}

Colour ImageSampler::colour(dvec2 at) const {
  Colour c = interpolated(at);
  if (palette_.empty()) {
    c.filter += image_.filter_all.value_or(0);
    c.transmit += image_.transmit_all.value_or(0);
  }
  if (image_.premultiplied) {
    const float alpha = 1 - c.transmit;
    if (alpha > epsilon) c.rgb /= alpha;
  }
  return c;
}

double ImageSampler::height(dvec2 at) const {
  if (image_.use_index && !palette_.empty()) return palette_index(at);
  const bool plain = plain_ && image_.interpolation != Interpolation::nearest;
  return grey(plain ? plain_interpolated(at) : interpolated(at).rgb);
}

double ImageSampler::value(dvec2 at) const {
  const Colour c = interpolated(at);
  const float v = !image_.use_alpha                     ? grey(c.rgb)
                  : has_alpha_ || !palette_.empty() ? c.transmit
                                                    : c.rgb.x;
  return std::clamp(v, 0.0F, 1.0F);
}

int ImageSampler::material(dvec2 at) const {
  return palette_.empty() ? static_cast<int>(interpolated(at).rgb.x * 255) : palette_index(at);
}

}  // namespace durer::tracer
