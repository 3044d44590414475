// `height_field` (objects §10.11): heights from a picture or a function.
#include <array>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "functions/evaluate.h"
#include "interpreter/object_reader.h"
#include "interpreter/user_function.h"

namespace durer::interpreter {

namespace w = grammar::words;

namespace {

/// More points than this are no landscape but a mistake; it is half a gigabyte of heights.
constexpr double most_points = 268435456.0;

/// The words that tell a picture's format.
constexpr std::array formats = {w::gif, w::pot,  w::sys,  w::tga, w::pgm, w::ppm,
                                w::png, w::jpeg, w::tiff, w::bmp, w::exr, w::hdr};

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
                        const std::optional<GammaCurve>& curve, bool png) {
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
  if (p.bits == 8 && png && p.channels == 1) return height_of_grey(code(0));
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

/// `[format] "file" [gamma …] [premultiplied …]`.
scene::HeightField ObjectReader::picture_heights() {
  std::string kind;
  for (const auto word : formats) {
    if (accept(word)) kind = in_.name_of(word);
  }
  const Span span = in_.peek().span;
  const std::string name = in_.read_text(true).bytes();
  std::optional<GammaCurve> curve;
  for (;;) {
    if (accept(w::gamma)) {
      curve = accept(w::srgb) ? GammaCurve::srgb()
                              : GammaCurve::power(static_cast<float>(in_.read_scalar("a gamma")));
    } else if (accept(w::premultiplied)) {
      in_.read_switch(true);  // heights have no alpha
    } else {
      break;
    }
  }
  const std::string suffix = kind.empty() ? "" : "." + kind;
  const std::array<std::string_view, 1> suffixes = {suffix};
  const std::span<const std::string_view> tried(suffixes.data(), kind.empty() ? 0U : 1U);
  const auto path = in_.find_file(name, span, tried);
  if (!path) in_.missing_file(name, span, tried);
  if (!in_.options_.read_picture) in_.not_supported("a height field from a picture", span);
  const PictureRead read = in_.options_.read_picture(*path, kind);
  if (!read.picture) {
    in_.fail(Code::file_not_found, span, fmt::format("`{}` cannot be read: {}", *path, read.error));
  }
  const Picture& picture = *read.picture;
  if (kind == "pot" || std::filesystem::path(*path).extension() == ".pot") {
    if (picture.palette.empty())
      in_.fail(Code::file_not_found, span, fmt::format("`{}` is no GIF file", *path));
    return high_and_low(picture);
  }
  const bool png = kind == "png" || std::filesystem::path(*path).extension() == ".png";
  scene::HeightField field{picture.width, picture.height, {}};
  field.heights.reserve(std::size_t{picture.width} * picture.height);
  for (std::uint32_t y = 0; y < picture.height; ++y) {
    for (std::uint32_t x = 0; x < picture.width; ++x)
      field.heights.push_back(height_of(picture, x, y, curve, png));
  }
  return field;
}

/// `function w, h { … }` of x and y, 0 to 1 over the picture that it stands for.
scene::HeightField ObjectReader::function_heights() {
  const Span span = in_.peek().span;
  const double columns = std::trunc(number("the number of columns"));
  const double rows = std::trunc(in_.read_scalar("the number of rows"));
  if (!(columns >= 2 && rows >= 2 && columns * rows <= most_points)) {
    in_.fail(Code::out_of_range, span,
             fmt::format("there is no height field of {} by {} points", columns, rows));
  }
  const functions::FunctionRef function = read_heights_function(span);
  if (function->components() > 1) return colour_heights(*function, columns, rows);
  scene::HeightField field{
      static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows), {}};
  field.heights.reserve(std::size_t{field.width} * field.height);
  std::vector<double> x(field.width);
  std::vector<double> y(field.width);
  const std::vector<double> z(field.width);
  std::vector<double> value(field.width);
  for (std::uint32_t i = 0; i < field.width; ++i) x[i] = i / (columns - 1);
  for (std::uint32_t j = 0; j < field.height; ++j) {
    std::fill(y.begin(), y.end(), j / (rows - 1));
    const std::array<const double*, 3> arguments = {x.data(), y.data(), z.data()};
    functions::evaluate_batch(*function, arguments, value.size(), value.data(), in_.workspace_);
    for (const double v : value) {
      // Beyond 0…1 the oracle keeps the lower 16 bits.
      const double h = std::trunc(65535 * v);
      field.heights.push_back(std::abs(h) < 9e18
                                  ? static_cast<std::uint16_t>(static_cast<std::int64_t>(h))
                                  : std::uint16_t{0});
    }
  }
  return field;
}

/// `{ … }`: a formula of x, y and z, a pattern, or a pigment.
functions::FunctionRef ObjectReader::read_heights_function(Span span) {
  in_.expect_open("function");
  const Token t = in_.peek();
  if (!t.is(w::pigment) && !t.is(w::pattern)) {
    return std::make_shared<const functions::Function>(
        in_.compile_function(std::array<SymbolId, 3>{w::x, w::y, w::z}));
  }
  const Value value = in_.read_special_function(span);
  if (const auto* missing = value.get<Shared<Unsupported>>()) {
    in_.not_supported((*missing)->feature, (*missing)->span);
  }
  return (*value.get<Shared<UserFunction>>())->tape;
}

/// The colours of a pigment as a picture of 16 bits would hold them.
scene::HeightField ObjectReader::colour_heights(const functions::Function& function, double columns,
                                                double rows) {
  scene::HeightField field{
      static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows), {}};
  std::vector<double> colour(static_cast<std::size_t>(function.components()));
  const auto stored = [](double x) { return std::trunc(std::clamp(x, 0.0, 1.0) * 65535) / 65535; };
  for (std::uint32_t j = 0; j < field.height; ++j) {
    for (std::uint32_t i = 0; i < field.width; ++i) {
      const std::array<double, 3> at = {i / (columns - 1), j / (rows - 1), 0};
      functions::evaluate(function, at, colour, in_.workspace_);
      field.heights.push_back(height_of(stored(colour[0]), stored(colour[1]), stored(colour[2])));
    }
  }
  return field;
}

}  // namespace durer::interpreter
