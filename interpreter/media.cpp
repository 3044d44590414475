// Media and their densities (participating-and-global §1.1, §1.2).
#include <cmath>

#include "interpreter/maps.h"

namespace durer::interpreter {

namespace w = grammar::words;

namespace {

constexpr std::string_view media_settings =
    "method intervals samples confidence variance ratio jitter aa_threshold aa_level absorption "
    "emission scattering collect density translate rotate scale matrix transform";
constexpr std::string_view density_settings =
    "agate boxed bozo cells crackle cylindrical gradient granite leopard marble onion planar "
    "radial ripples spherical spotted waves wood wrinkles density_file function average color rgb "
    "color_map density_map turbulence frequency phase warp translate rotate scale matrix transform";

// What `media {` starts from depends on the version in force (participating-and-global §1.1).
scene::Media initial_media(int version) {
  scene::Media m;
  if (version >= 350) return m;
  m.method = 1;
  m.intervals = 10;
  m.min_samples = m.max_samples = 1;
  return m;
}

}  // namespace

void move_densities(scene::Media& media, const Transform& by) {
  for (scene::Pigment& d : media.densities) d.pattern.edit().transform = d.pattern->transform.then(by);
}

scene::Media Interpreter::read_media(Span span) {
  expect_open("media");
  scene::Media m = initial_media(version());
  if (const Token t = peek(); t.kind == Token::Kind::expr) {
    const Value* v = lookup(*t.tree, t.expr, false);
    const auto* known = v == nullptr ? nullptr : v->get<Shared<scene::Media>>();
    if (known == nullptr) bad_setting(t, "media", span, media_settings);
    m = **known;
    next();
  }
  m.origin = origin(span);
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) return m;
    if (t.is_punct(';')) continue;
    if (const auto transform = read_transformation(t)) {
      move_densities(m, *transform);
      continue;
    }
    if (t.kind != Token::Kind::word) bad_setting(t, "media", span, media_settings);
    switch (t.word) {
      case w::absorption: m.absorption = read_rgb(); break;
      case w::emission: m.emission = read_rgb(); break;
      case w::scattering: read_scattering(m); break;
      case w::collect: m.collect = read_switch(true); break;
      case w::density: m.densities.push_back(read_density()); break;
      default:
        if (!sampling_setting(m, t)) bad_setting(t, "media", span, media_settings);
    }
  }
}

/// How a medium is sampled; false if `t` says something else.
bool Interpreter::sampling_setting(scene::Media& m, const Token& t) {
  const auto number = [&](auto legal, std::string_view rule) {
    const double x = read_float();
    if (!legal(x)) {
      fail(Code::out_of_range, t.span, fmt::format("`{}` must be {}", name_of(t.word), rule));
    }
    return x;
  };
  const auto whole = [&](double least, double most, std::string_view rule) {
    const auto legal = [&](double x) { return std::trunc(x) >= least && std::trunc(x) <= most; };
    return static_cast<int>(number(legal, rule));
  };
  constexpr double many = 1e9;
  switch (t.word) {
    case w::method: m.method = whole(1, 3, "1, 2 or 3"); return true;
    case w::intervals: m.intervals = whole(1, many, "at least 1"); return true;
    case w::samples:
      m.min_samples = m.max_samples = whole(1, many, "at least 1");
      optional_comma();
      if (starts_number(peek())) {
        m.max_samples = whole(m.min_samples, many, "a minimum and a maximum");
      }
      return true;
    case w::confidence:
      m.confidence = number([](double x) { return x >= 0 && x < 1; }, "0 or more, and below 1");
      return true;
    case w::variance: m.variance = read_float(); return true;
    case w::ratio: m.ratio = read_float(); return true;
    case w::jitter: m.jitter = read_float(); return true;
    case w::aa_threshold:
      m.aa_threshold = number([](double x) { return x > 0; }, "positive");
      return true;
    case w::aa_level: m.aa_level = whole(1, many, "at least 1"); return true;
    default: return false;
  }
}

/// `{ type, colour [eccentricity E] [extinction X] }`.
void Interpreter::read_scattering(scene::Media& m) {
  const Span opened = peek().span;
  expect_open("scattering");
  const Span at = peek().span;
  const double type = std::trunc(read_float());
  const bool known = type >= 1 && type <= 5;
  if (!known) {
    warn(Code::out_of_range, at, "the type of `scattering` is 1, 2, 3, 4 or 5; 1 is used");
  }
  m.phase = known ? static_cast<scene::Phase>(static_cast<int>(type) - 1) : scene::Phase::isotropic;
  optional_comma();
  m.scattering = read_rgb();
  for (Token t = next(); t.kind != Token::Kind::close; t = next()) {
    if (t.is_punct(';')) continue;
    if (t.is(w::extinction)) {
      m.extinction = read_float();
    } else if (t.is(w::eccentricity)) {
      if (m.phase != scene::Phase::henyey_greenstein) {
        fail(Code::unexpected_item, t.span, "`eccentricity` belongs to scattering of type 5");
      }
      m.eccentricity = read_float();
    } else {
      bad_setting(t, "scattering", opened, "eccentricity extinction");
    }
  }
}

scene::Pigment Interpreter::read_density() {
  expect_open("density");
  scene::Pigment d;
  d.origin = origin(peek().span);
  read_density_body(d, Token::Kind::close);
  return d;
}

/// Reads up to and including the closing mark `last`. Like a pigment, but without anything it is
/// nothing: black.
void Interpreter::read_density_body(scene::Pigment& d, Token::Kind last) {
  for (bool first = true;; first = false) {
    const Token t = peek();
    if (t.kind == last) break;
    if (t.is_punct(';')) {
      next();
      continue;
    }
    if (first && t.kind == Token::Kind::expr) {
      const Value* v = lookup(*t.tree, t.expr, false);
      if (v != nullptr && v->get<Shared<Density>>() != nullptr) {
        d = (*v->get<Shared<Density>>())->pigment;
        next();
        continue;
      }
    }
    if (first && (starts_colour(t) || t.kind == Token::Kind::expr || t.is_punct('-'))) {
      d.colour = read_colour_num(t.kind != Token::Kind::word).colour();
      continue;
    }
    if (t.kind != Token::Kind::word) bad_setting(t, "density", {}, density_settings);
    next();
    if (const auto it = pattern_words_.find(t.word);
        it != pattern_words_.end() && !registry_.patterns[it->second]->only_normal) {
      start_density_pattern(d, it->second, t);
      continue;
    }
    if (density_modifier(d, t)) continue;
    if (t.word == w::uv_mapping) {
      fail(Code::unexpected_item, t.span, "a density lies in space and takes no `uv_mapping`");
    }
    if (is_pattern_word(t.word)) {
      d.unsupported = fmt::format("`{}` as a density", name_of(t.word));
      d.origin = origin(t.span);
      return skip_to(last);
    }
    bad_setting(t, "density", {}, density_settings);
  }
  next();
  check_pattern(*d.pattern, d.entries.empty(), "density_map");
}

void Interpreter::start_density_pattern(scene::Pigment& d, std::uint32_t index, const Token& word) {
  const scene::PatternInfo& info = *registry_.patterns[index];
  if (info.list_size == 0) return start_pigment_pattern(d, index, word);
  d.entries.clear();
  d.children.clear();
  choose_pattern(d.pattern.edit(), index);
  for (int i = 0; i < info.list_size; ++i) {
    if (!accept(w::density)) {
      fail(Code::missing_argument, word.span,
           fmt::format("as a density, `{}` needs {} densities after it", info.name,
                       info.list_size));
    }
    d.entries.push_back({static_cast<float>(i), {}, static_cast<std::uint32_t>(i)});
    d.children.push_back(read_density());
    optional_comma();
  }
  read_pattern_operands(d.pattern.edit(), word);
}

bool Interpreter::density_modifier(scene::Pigment& d, const Token& t) {
  if (pattern_modifier(d.pattern.edit(), t)) return true;
  if (t.word != w::color_map && t.word != w::colour_map && t.word != w::density_map) return false;
  const bool colours = t.word != w::density_map;
  const scene::PatternInfo* const info =
      d.pattern->exists() ? registry_.patterns[d.pattern->type] : nullptr;
  if (info == nullptr || info->list_size > 0 || (colours && info->averages)) bad_map(t, info);
  if (colours) {
    ColourMap map = read_colour_map();
    d.entries = std::move(map.entries);
    d.children = std::move(map.children);
  } else {
    DensityMap map = read_density_map(info->averages);
    d.entries = std::move(map.entries);
    d.children = std::move(map.children);
  }
  return true;
}

/// `density_map { [key density] … }` or `density_map { Identifier }`.
DensityMap Interpreter::read_density_map(bool weights) {
  DensityMap map;
  read_map("density_map", map, weights, [&](float key) {
    scene::Pigment child;
    child.origin = origin(last_span_);
    read_density_body(child, Token::Kind::bracket_close);
    map.entries.push_back({key, {}, static_cast<std::uint32_t>(map.children.size())});
    map.children.push_back(std::move(child));
  });
  return map;
}

}  // namespace durer::interpreter
