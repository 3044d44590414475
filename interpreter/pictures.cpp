// Pictures that scenes read from files or make of functions (textures §12, objects §10.11).
#include "interpreter/pictures.h"

#include <array>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "functions/evaluate.h"
#include "interpreter/interpreter.h"
#include "interpreter/user_function.h"

namespace durer::interpreter {

namespace w = grammar::words;

namespace {

/// The words that tell a picture's format.
constexpr std::array picture_formats = {
    grammar::words::gif, grammar::words::pot, grammar::words::sys,  grammar::words::tga,
    grammar::words::pgm, grammar::words::ppm, grammar::words::png,  grammar::words::jpeg,
    grammar::words::iff, grammar::words::bmp, grammar::words::tiff, grammar::words::exr,
    grammar::words::hdr};

/// More pixels than this are no picture but a mistake; it is half a gigabyte of them.
constexpr double most_pixels = 268435456.0;

/// The word for the format of a file with this name.
std::string kind_of(const std::string& path) {
  std::string kind = std::filesystem::path(path).extension().string();
  std::ranges::transform(kind, kind.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (!kind.empty()) kind.erase(0, 1);
  if (kind == "jpg") return "jpeg";
  if (kind == "tif") return "tiff";
  return kind;
}

/// A number as 16 bits keep it, towards zero; beyond 0…1 the oracle keeps the lower bits.
std::uint16_t lower_bits(double v) {
  const double code = std::trunc(65535 * v);
  return std::abs(code) < 9e18 ? static_cast<std::uint16_t>(static_cast<std::int64_t>(code))
                               : std::uint16_t{0};
}
std::uint16_t clamped(double v) {
  return static_cast<std::uint16_t>(std::trunc(std::clamp(v, 0.0, 1.0) * 65535));
}

}  // namespace

PictureFile Interpreter::read_picture_file() {
  PictureFile file;
  for (const auto word : picture_formats) {
    if (accept(word)) file.kind = name_of(word);
  }
  file.span = peek().span;
  const std::string name = read_text(true).bytes();
  for (;;) {
    if (accept(w::gamma)) {
      const Span span = peek().span;
      file.curve = GammaCurve::srgb();
      if (accept(w::srgb)) continue;
      const double g = read_scalar("a gamma");
      if (!(g > 0)) fail(Code::out_of_range, span, "a `gamma` must be positive");
      if (g < 1) warn(Code::out_of_range, span, "a `gamma` below 1 is hardly what you want");
      file.curve = GammaCurve::power(static_cast<float>(g));
    } else if (accept(w::premultiplied)) {
      file.premultiplied = read_switch(true);
    } else {
      break;
    }
  }
  const std::string suffix = file.kind.empty() ? "" : "." + file.kind;
  const std::array<std::string_view, 1> suffixes = {suffix};
  const std::span<const std::string_view> tried(suffixes.data(), file.kind.empty() ? 0U : 1U);
  const auto path = find_file(name, file.span, tried);
  if (!path) missing_file(name, file.span, tried);
  file.picture = load_picture(*path, file.kind, file.span);
  if (file.kind.empty()) file.kind = kind_of(*path);
  return file;
}

/// Reads every file once; those who show it share it.
std::shared_ptr<const Picture> Interpreter::load_picture(const std::string& path,
                                                         const std::string& kind, Span span) {
  if (!options_.read_picture) not_supported("reading pictures", span);
  PictureRead& known = pictures_[path];
  if (!known.picture && known.error.empty()) known = options_.read_picture(path, kind);
  if (!known.picture) {
    fail(Code::file_not_found, span, fmt::format("`{}` cannot be read: {}", path, known.error));
  }
  return known.picture;
}

/// After `function`: `columns, rows { … }` of x and y, 0 to 1 over the picture that it stands for;
/// y counts rows, from the top. A number becomes a grey of 16 bits, a colour four of them.
std::shared_ptr<const Picture> Interpreter::read_function_picture(double columns, double rows,
                                                                  Span span) {
  if (!(columns >= 2 && rows >= 2 && columns * rows <= most_pixels)) {
    fail(Code::out_of_range, span, fmt::format("there is no picture of {} by {} pixels", columns, rows));
  }
  const functions::FunctionRef function = read_picture_function(span);
  const auto parts = static_cast<std::size_t>(function->components());
  auto picture = std::make_shared<Picture>();
  picture->width = static_cast<std::uint32_t>(columns);
  picture->height = static_cast<std::uint32_t>(rows);
  picture->bits = 16;
  picture->channels = parts > 1 ? 4 : 1;
  picture->codes.reserve(std::size_t{picture->width} * picture->height * picture->channels);
  if (parts == 1) {
    sample_numbers(*function, *picture);
    return picture;
  }
  std::vector<double> colour(parts);
  for (std::uint32_t j = 0; j < picture->height; ++j) {
    for (std::uint32_t i = 0; i < picture->width; ++i) {
      const std::array<double, 3> at = {i / (columns - 1), j / (rows - 1), 0};
      functions::evaluate(*function, at, colour, workspace_);
      for (std::size_t k = 0; k < 3; ++k) picture->codes.push_back(clamped(colour[k]));
      picture->codes.push_back(clamped(1 - colour[4]));
    }
  }
  return picture;
}

void Interpreter::sample_numbers(const functions::Function& function, Picture& picture) {
  const std::uint32_t width = picture.width;
  std::vector<double> x(width);
  std::vector<double> y(width);
  const std::vector<double> z(width);
  std::vector<double> value(width);
  for (std::uint32_t i = 0; i < width; ++i) x[i] = i / (width - 1.0);
  for (std::uint32_t j = 0; j < picture.height; ++j) {
    std::fill(y.begin(), y.end(), j / (picture.height - 1.0));
    const std::array<const double*, 3> arguments = {x.data(), y.data(), z.data()};
    functions::evaluate_batch(function, arguments, value.size(), value.data(), workspace_);
    for (const double v : value) picture.codes.push_back(lower_bits(v));
  }
}

/// `{ … }`: a formula of x, y and z, a pattern, or a pigment.
functions::FunctionRef Interpreter::read_picture_function(Span span) {
  expect_open("function");
  const Token t = peek();
  if (!t.is(w::pigment) && !t.is(w::pattern)) {
    return std::make_shared<const functions::Function>(
        compile_function(std::array<SymbolId, 3>{w::x, w::y, w::z}));
  }
  const Value value = read_special_function(span);
  if (const auto* missing = value.get<Shared<Unsupported>>()) {
    not_supported((*missing)->feature, (*missing)->span);
  }
  return (*value.get<Shared<UserFunction>>())->tape;
}

}  // namespace durer::interpreter
