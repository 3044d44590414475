// Patterns, their modifiers and warps (textures §3, §4, §16).
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;

bool Interpreter::is_pattern_word(SymbolId word) const {
  if (pattern_words_.contains(word)) return true;
  switch (word) {
    case w::agate:
    case w::aoi:
    case w::average:
    case w::boxed:
    case w::bozo:
    case w::brick:
    case w::bumps:
    case w::cells:
    case w::checker:
    case w::crackle:
    case w::cubic:
    case w::cylindrical:
    case w::density_file:
    case w::dents:
    case w::facets:
    case w::function:
    case w::gradient:
    case w::granite:
    case w::hexagon:
    case w::image_map:
    case w::image_pattern:
    case w::julia:
    case w::leopard:
    case w::magnet:
    case w::mandel:
    case w::marble:
    case w::object:
    case w::onion:
    case w::pavement:
    case w::pigment_pattern:
    case w::planar:
    case w::quilted:
    case w::radial:
    case w::ripples:
    case w::slope:
    case w::spherical:
    case w::spiral1:
    case w::spiral2:
    case w::spotted:
    case w::square:
    case w::tiling:
    case w::triangular:
    case w::uv_mapping:
    case w::waves:
    case w::wood:
    case w::wrinkles:
    case w::bump_map: return true;
    default: return false;
  }
}

/// Skips the rest of a block, its closing mark included.
void Interpreter::skip_to(Token::Kind last) {
  for (int depth = 0;;) {
    const Token t = next();
    if (t.kind == last && depth == 0) return;
    if (t.kind == Token::Kind::open || t.kind == Token::Kind::bracket_open) ++depth;
    if (t.kind == Token::Kind::close || t.kind == Token::Kind::bracket_close) --depth;
    if (t.kind == Token::Kind::end) unexpected(t, "the end of this block");
  }
}

namespace {

/// Where the operand `name` lies in the arguments of a type, and what it is like.
struct ParamPlace {
  const scene::Param* param = nullptr;
  std::size_t offset = 0;
};
ParamPlace find_operand(const scene::TypeInfo& info, std::string_view name) {
  std::size_t offset = 0;
  for (const scene::Param& p : info.params) {
    if (p.name == name) return {&p, offset};
    offset += scene::width(p.kind);
  }
  return {};
}

std::vector<double> default_operands(const scene::TypeInfo& info) {
  std::vector<double> args;
  args.reserve(info.arg_count());
  for (const scene::Param& p : info.params) {
    args.insert(args.end(), p.fallback.begin(), p.fallback.begin() + scene::width(p.kind));
  }
  return args;
}

}  // namespace

/// Makes a pattern one of the registry's; what was set before stays (textures §3).
void Interpreter::choose_pattern(scene::Pattern& p, std::uint32_t index) {
  const scene::PatternInfo& info = *registry_.patterns[index];
  p.type = index;
  if (info.unwrapped || info.list_size > 0) p.frequency = 0;
  if (info.wave != scene::Wave::ramp) p.wave = info.wave;
  p.function = nullptr;
  p.pigment = nullptr;
  p.image = nullptr;
  p.voxels = nullptr;
}

/// Before the list of a block pattern: `object` has an object there, in braces around both.
void Interpreter::open_list(scene::Pattern& p, const Token& word) {
  if (!registry_.patterns[p.type]->takes_object) return;
  read_object_pattern(p, word.span);
  optional_comma();
}
void Interpreter::close_list(const scene::Pattern& p, const Token& word) {
  if (registry_.patterns[p.type]->takes_object) expect_close("object", word.span);
}

/// `bump_size`: takes what a picture of bumps may say about their height.
void Interpreter::read_pattern_operands(scene::Pattern& p, const Token& word, float* bump_size) {
  const scene::PatternInfo& info = *registry_.patterns[p.type];
  if (word.word == w::slope) return read_slope(p, word.span);
  if (word.word == w::magnet) return read_magnet(p, word.span);
  if (info.takes_image) {
    p.args = default_operands(info);
    return read_image(p, word, bump_size);
  }
  if (info.takes_voxels) p.voxels = read_voxels();
  p.args = read_operands(info, word);
  if (info.takes_function) {
    p.function = read_scene_function(std::array<SymbolId, 3>{w::x, w::y, w::z});
  }
  if (info.takes_pigment) {
    p.pigment = std::make_shared<const scene::Pigment>(read_pigment({}));
  }
}

/// At the end of its block, where all operands are known. `average` is nothing without a map.
void Interpreter::check_pattern(const scene::Pattern& p, bool none, std::string_view map) {
  if (!p.exists()) return;
  const scene::PatternInfo& info = *registry_.patterns[p.type];
  if (info.validate != nullptr) {
    if (const auto problem = info.validate(p.args)) fail(Code::degenerate, last_span_, *problem);
  }
  if (none && info.averages) {
    fail(Code::missing_argument, peek().span, fmt::format("`{}` needs a `{}`", info.name, map));
  }
}

/// A map where the pattern (null: none yet) takes none.
void Interpreter::bad_map(const Token& word, const scene::PatternInfo* info) {
  std::string message = info == nullptr ? fmt::format("`{}` needs a pattern before it", name_of(word.word))
                        : info->list_size > 0
                            ? fmt::format("`{}` takes a list, not a map", info->name)
                            : fmt::format("`{}` takes no `{}`", info->name, name_of(word.word));
  fail(Code::unexpected_item, word.span, std::move(message));
}

/// What may follow any pattern; false if `t` is something else.
bool Interpreter::pattern_modifier(scene::Pattern& p, const Token& t) {
  if (const auto transform = read_transformation(t)) {
    p.transform = p.transform.then(*transform);
    return true;
  }
  if (p.exists()) {
    const ParamPlace place = find_operand(*registry_.patterns[p.type], name_of(t.word));
    if (place.param != nullptr && !place.param->positional) {
      read_operand(*place.param, &p.args[place.offset]);
      return true;
    }
  }
  switch (t.word) {
    case w::frequency: p.frequency = static_cast<float>(read_float()); return true;
    case w::phase: p.phase = static_cast<float>(read_float()); return true;
    case w::ramp_wave: p.wave = scene::Wave::ramp; return true;
    case w::sine_wave: p.wave = scene::Wave::sine; return true;
    case w::triangle_wave: p.wave = scene::Wave::triangle; return true;
    case w::scallop_wave: p.wave = scene::Wave::scallop; return true;
    case w::cubic_wave: p.wave = scene::Wave::cubic; return true;
    case w::poly_wave:
      p.wave = scene::Wave::poly;
      if (starts_number(peek())) p.wave_exponent = static_cast<float>(read_float());
      return true;
    case w::turbulence:
    case w::octaves:
    case w::omega:
    case w::lambda: read_turbulence(p, t); return true;
    case w::noise_generator: read_noise_generator(p, t); return true;
    case w::warp: read_warp(p, t.span); return true;
    default: return false;
  }
}

/// `slope V` or `slope { [point_at] V [, low, high] [altitude V [, low, high]] }`.
void Interpreter::read_slope(scene::Pattern& p, Span span) {
  const scene::TypeInfo& info = *registry_.patterns[p.type];
  p.args = default_operands(info);
  const auto at = [&](std::string_view name) { return &p.args[find_operand(info, name).offset]; };
  const auto vector = [&](std::string_view name) {
    const dvec3 v = read_vector();
    std::copy_n(&v.x, 3, at(name));
  };
  if (peek().kind != Token::Kind::open) return vector("direction");
  next();
  const auto range = [&](std::string_view low, std::string_view high) {
    for (const std::string_view name : {low, high}) {
      optional_comma();
      if (starts_number(peek())) *at(name) = read_scalar("slope or altitude");
    }
    if (*at(low) == *at(high) && *at(low) != 0) {
      warn(Code::degenerate, span, "both ends of this range are the same; it is ignored");
    }
  };
  const bool to_point = accept(w::point_at);
  if (to_point) *at("point_at") = 1;
  vector("direction");
  range("low_slope", "high_slope");
  if (accept(w::altitude)) {
    if (to_point) fail(Code::unexpected_item, span, "`altitude` does not go with `point_at`");
    vector("altitude");
    range("low_altitude", "high_altitude");
  }
  expect_close("slope", span);
}

/// `magnet 1 mandel N` or `magnet 2 julia <c>, N`.
void Interpreter::read_magnet(scene::Pattern& p, Span span) {
  const scene::TypeInfo& info = *registry_.patterns[p.type];
  p.args = default_operands(info);
  const auto at = [&](std::string_view name) { return &p.args[find_operand(info, name).offset]; };
  *at("type") = std::trunc(read_scalar("the type of magnet"));
  if (*at("type") != 1 && *at("type") != 2) fail(Code::out_of_range, span, "`magnet` is 1 or 2");
  if (accept(w::julia)) {
    *at("julia") = 1;
    last_span_ = peek().span;
    const Num c = fit(read_num(2), 2);
    std::copy_n(c.v.begin(), 2, at("constant"));
    optional_comma();
  } else if (!accept(w::mandel)) {
    unexpected(peek(), "`mandel` or `julia` after the type of `magnet`");
  }
  *at("iterations") = read_scalar("the number of iterations");
}

/// `noise_generator N`; the oracle combines the bits of several.
void Interpreter::read_noise_generator(scene::Pattern& p, const Token& word) {
  const double n = std::trunc(read_scalar("the number of a noise generator"));
  if (!(n >= 0 && n <= 3)) fail(Code::out_of_range, word.span, "`noise_generator` is 0, 1, 2 or 3");
  p.noise_generator |= static_cast<int>(n);
}

/// `turbulence`, `octaves`, `omega` or `lambda` outside of any warp. They make one step that is
/// nearest to the pattern wherever they stand (textures §4.1).
void Interpreter::read_turbulence(scene::Pattern& p, const Token& word) {
  const auto known = warp_words_.find(w::turbulence);
  if (known == warp_words_.end()) not_supported("`turbulence`", word.span);
  const scene::TypeInfo& info = *registry_.warps[known->second];
  if (p.warps.empty() || !p.warps.front().classic) {
    scene::Warp warp;
    warp.type = known->second;
    warp.args = default_operands(info);
    warp.classic = true;
    p.warps.insert(p.warps.begin(), std::move(warp));
  }
  const bool amount = word.word == w::turbulence;
  const ParamPlace place = find_operand(info, amount ? info.params.front().name : name_of(word.word));
  read_operand(*place.param, &p.warps.front().args[place.offset]);
}

/// `{ repeat x }` and the like.
void Interpreter::read_warp(scene::Pattern& p, Span span) {
  expect_open("warp");
  const Token t = next();
  const auto known = t.kind == Token::Kind::word ? warp_words_.find(t.word) : warp_words_.end();
  if (known == warp_words_.end()) {
    std::string names;
    for (const scene::TypeInfo* info : registry_.warps) {
      names += names.empty() ? "" : " ";
      names += info->name;
    }
    bad_setting(t, "warp", span, names);
  }
  // Transformations so far lie between the pattern and this warp.
  if (!p.transform.is_identity()) {
    scene::Warp moved;
    moved.transform = p.transform;
    p.transform = {};
    p.warps.push_back(std::move(moved));
  }
  scene::Warp warp;
  warp.type = known->second;
  warp.args = read_operands(*registry_.warps[known->second], t);
  p.warps.push_back(std::move(warp));
  expect_close("warp", span);
}

}  // namespace durer::interpreter
