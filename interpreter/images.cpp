// `image_map`, `image_pattern`, `bump_map` and `material_map`: a picture and how it lies (textures
// §12).
#include <cmath>

#include <fmt/format.h>

#include "interpreter/interpreter.h"
#include "interpreter/pictures.h"
#include "scene/image.h"

namespace durer::interpreter {

namespace w = grammar::words;

namespace {

constexpr std::string_view image_settings =
    "once interpolate map_type filter transmit use_color use_index use_alpha repeat offset "
    "bump_size";

/// True for formats whose numbers are light as it is.
bool is_linear_format(const std::string& kind) { return kind == "hdr" || kind == "exr"; }

/// True for formats that nobody says anything about: their numbers are taken as the scene's.
bool is_bare_format(const std::string& kind) {
  return kind == "ppm" || kind == "pgm" || kind == "tiff" || kind == "iff";
}

}  // namespace

/// `{ … }` of a picture. A `material_map` is left in front of its textures.
void Interpreter::read_image(scene::Pattern& pattern, const Token& word, float* bump_size) {
  const bool is_map = word.word == w::image_map;
  scene::Image image;
  expect_open(name_of(word.word));
  if (peek().node<ast::Vector>() != nullptr) {
    warn(Code::deprecated, peek().span, "pictures have no orientation any more; this is ignored");
    read_vector();
    optional_comma();
  }
  read_image_source(image, is_map);
  for (;;) {
    const Token t = peek();
    if (word.word == w::material_map && t.is(w::texture)) break;
    next();
    if (t.kind == Token::Kind::close) break;
    if (t.is_punct(';')) continue;
    if (t.kind == Token::Kind::word && image_setting(image, t, word.word)) continue;
    if (t.is(w::bump_size) && bump_size != nullptr) {
      *bump_size = static_cast<float>(read_float());
      continue;
    }
    bad_setting(t, name_of(word.word), word.span, image_settings);
  }
  pattern.image = std::make_shared<const scene::Image>(std::move(image));
}

/// A file or `function`, and the curves of its numbers.
void Interpreter::read_image_source(scene::Image& image, bool is_map) {
  const Span span = peek().span;
  if (accept(w::function)) {
    const double columns = std::round(read_scalar("the number of columns"));
    optional_comma();
    const double rows = std::round(read_scalar("the number of rows"));
    image.picture = read_function_picture(columns, rows, span);
    return;
  }
  const PictureFile file = read_picture_file();
  image.picture = file.picture;
  image.premultiplied = file.premultiplied.value_or(file.picture->premultiplied);
  set_curves(image, file, is_map);
}

/// What the numbers of the file mean (textures §15.3). Only image maps are about light.
void Interpreter::set_curves(scene::Image& image, const PictureFile& file, bool is_map) const {
  if (is_map) image.working = scene_.settings.assumed_gamma;
  const bool modern = version() >= 370;
  if (file.curve) {
    image.stored = *file.curve;
    return;
  }
  const bool says_nothing = is_bare_format(file.kind) || (!modern && !assumed_gamma_given_);
  if (!is_map || says_nothing) {
    image.stored = image.working;
    return;
  }
  const Picture& picture = *file.picture;
  if (is_linear_format(file.kind)) {
    image.stored = {};
  } else if (file.kind == "png" && picture.file_gamma && !picture.file_srgb) {
    image.stored = GammaCurve::power(static_cast<float>(*picture.file_gamma));
  } else if (modern || (file.kind == "png" && picture.file_srgb)) {
    image.stored = GammaCurve::srgb();
  } else {
    image.stored = image.working;
  }
}

/// One setting of a picture; false if `t` is something else.
bool Interpreter::image_setting(scene::Image& image, const Token& t, SymbolId block) {
  const bool is_map = block == w::image_map;
  switch (t.word) {
    case w::once: image.once = true; return true;
    case w::interpolate:
    case w::map_type: image_kind(image, t, block); return true;
    case w::use_color:
    case w::use_colour: image.use_index = image.use_alpha = false; return true;
    case w::use_index: image.use_index = true; return true;
    case w::use_alpha:
      if (block != w::image_pattern) return false;
      image.use_alpha = true;
      return true;
    case w::repeat:
    case w::offset: {
      last_span_ = peek().span;
      const Num v = fit(read_num(2), 2);
      const dvec2 uv(v.v[0], v.v[1]);
      if (t.word == w::repeat && !(uv.x > 0 && uv.y > 0)) {
        fail(Code::out_of_range, t.span, "a picture is repeated more than 0 times");
      }
      (t.word == w::repeat ? image.repeat : image.offset) = uv;
      return true;
    }
    case w::filter:
    case w::alpha:
    case w::transmit:
      if (!is_map) return false;
      palette_setting(image, t);
      return true;
    default: return false;
  }
}

/// `interpolate N` or `map_type N`. Only image maps mind what N is.
void Interpreter::image_kind(scene::Image& image, const Token& t, SymbolId block) {
  using Projection = scene::Image::Projection;
  using Interpolation = scene::Image::Interpolation;
  const int n = static_cast<int>(read_float());
  const bool is_map = block == w::image_map;
  if (t.word == w::map_type) {
    switch (n) {
      case 1: image.projection = Projection::spherical; return;
      case 2: image.projection = Projection::cylindrical; return;
      case 5: image.projection = Projection::toroidal; return;
      default: image.projection = Projection::planar; break;
    }
    if (is_map && n != 0) fail(Code::out_of_range, t.span, "`map_type` is 0, 1, 2 or 5");
    return;
  }
  switch (n) {
    case 2: image.interpolation = Interpolation::bilinear; return;
    case 3: image.interpolation = Interpolation::bicubic; return;
    case 4: image.interpolation = Interpolation::distance; return;
    default: image.interpolation = Interpolation::nearest; break;
  }
  if (is_map) fail(Code::out_of_range, t.span, "`interpolate` is 2, 3 or 4");
  if (n != 0) warn(Code::out_of_range, t.span, "`interpolate` is 2, 3 or 4; nothing is interpolated");
}

/// `filter all F` or `filter INDEX, F`, likewise `transmit`.
void Interpreter::palette_setting(scene::Image& image, const Token& t) {
  const bool is_transmit = t.word == w::transmit;
  if (t.word == w::alpha) {
    warn(Code::deprecated, t.span, "`alpha` is an old word for `filter`", "write `filter`");
  }
  if (accept(w::all)) {
    const auto value = static_cast<float>(read_float());
    (is_transmit ? image.transmit_all : image.filter_all) = value;
    return;
  }
  const double index = std::trunc(read_scalar("the number of a colour"));
  optional_comma();
  const auto value = static_cast<float>(read_float());
  const std::size_t colours = image.picture->palette.size();
  if (!(index >= 0 && index < static_cast<double>(colours))) {
    fail(Code::out_of_range, t.span,
         colours == 0 ? "this picture has no palette, its colours have no numbers"
                      : fmt::format("this picture has colours 0 to {}", colours - 1),
         colours == 0 ? fmt::format("write `{} all {}`", name_of(t.word), value) : "");
  }
  (is_transmit ? image.transmit : image.filter)
      .push_back({static_cast<std::uint32_t>(index), value});
}

}  // namespace durer::interpreter
