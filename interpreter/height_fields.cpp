// `height_field` (objects §10.11): heights from a picture or a function.
#include <cmath>

#include "interpreter/object_reader.h"
#include "interpreter/pictures.h"

namespace durer::interpreter {

namespace w = grammar::words;

namespace {

std::uint16_t height_of(double red, double green, double blue) {
  return static_cast<std::uint16_t>(
      std::clamp((0.297 * red + 0.589 * green + 0.114 * blue) * 65535, 0.0, 65535.0));
}

/// A stored number as light, stored again (objects §10.11): only if the scene says so.
std::uint16_t decoded(std::uint16_t code, std::uint32_t bits, const GammaCurve& curve) {
  const double most = bits == 8 ? 255 : 65535;
  return static_cast<std::uint16_t>(most * curve.decode(static_cast<float>(code / most)));
}

/// A grey of 8 bits in a PNG file: the oracle weighs its three equal parts in single precision,
/// which makes a third of them one less than 257 times as much.
std::uint16_t height_of_grey(std::uint16_t code) {
  const float x = static_cast<float>(code) / 255.0F;
  const float sum = 0.297F * x + 0.589F * x + 0.114F * x;
  return static_cast<std::uint16_t>(sum * 65535.0F);
}

/// What a pixel means as a height: colours of 8 bits hold a high and a low byte.
std::uint16_t height_of(const Picture& p, std::uint32_t x, std::uint32_t y,
                        const std::optional<GammaCurve>& curve) {
  const bool grey = p.channels < 3;
  const std::size_t at = p.index(x, y);
  if (p.is_real()) {
    const float* s = &p.samples[at];
    return grey ? height_of(s[0], s[0], s[0]) : height_of(s[0], s[1], s[2]);
  }
  if (!p.palette.empty()) return static_cast<std::uint16_t>(p.codes[at] * 256);
  const auto code = [&](std::size_t channel) {
    const std::uint16_t c = p.codes[at + channel];
    return curve ? decoded(c, p.bits, *curve) : c;
  };
  if (p.weighed_grey) return height_of_grey(code(0));
  if (p.bits == 8)
    return static_cast<std::uint16_t>(grey ? 257 * code(0) : 256 * code(0) + code(1));
  if (grey) return code(0);
  return height_of(code(0) / 65535.0, code(1) / 65535.0, code(2) / 65535.0);
}

/// A `pot` file: high bytes in the left half of a GIF, low bytes in the right one.
scene::HeightField high_and_low(const Picture& p) {
  scene::HeightField field{p.width / 2, p.height, {}};
  for (std::uint32_t y = 0; y < field.height; ++y) {
    for (std::uint32_t x = 0; x < field.width; ++x) {
      const unsigned high = p.codes[p.index(x, y)];
      field.heights.push_back(
          static_cast<std::uint16_t>(high * 256 + p.codes[p.index(x + field.width, y)]));
    }
  }
  return field;
}

scene::HeightField heights_of(const Picture& picture, const std::optional<GammaCurve>& curve) {
  scene::HeightField field{picture.width, picture.height, {}};
  field.heights.reserve(std::size_t{picture.width} * picture.height);
  for (std::uint32_t y = 0; y < picture.height; ++y) {
    for (std::uint32_t x = 0; x < picture.width; ++x)
      field.heights.push_back(height_of(picture, x, y, curve));
  }
  return field;
}

}  // namespace

void ObjectReader::height_field() {
  args_.assign(2, 0.0);
  object_.extras.edit().heights = std::make_shared<const scene::HeightField>(
      accept(w::function) ? function_heights() : picture_heights());
  for (;;) {
    if (accept(w::water_level)) {
      args_[0] = in_.read_scalar("the water level");
      if (in_.version() < 200) args_[0] /= 256;
    } else if (accept(w::smooth)) {
      args_[1] = in_.read_switch(true) ? 1 : 0;
    } else {
      return;
    }
  }
}

/// `[format] "file" [gamma …] [premultiplied …]`; heights have no alpha.
scene::HeightField ObjectReader::picture_heights() {
  const PictureFile file = in_.read_picture_file();
  const Picture& picture = *file.picture;
  if (file.kind == "pot") {
    if (picture.palette.empty())
      in_.fail(Code::file_not_found, file.span, "this is no GIF file, as `pot` files are");
    return high_and_low(picture);
  }
  return heights_of(picture, file.curve);
}

/// `function columns, rows { … }`.
scene::HeightField ObjectReader::function_heights() {
  const Span span = in_.peek().span;
  const double columns = std::trunc(number("the number of columns"));
  const double rows = std::trunc(in_.read_scalar("the number of rows"));
  return heights_of(*in_.read_function_picture(columns, rows, span), std::nullopt);
}

}  // namespace durer::interpreter
