// Normals and their maps (textures §13, §16).
#include "interpreter/maps.h"

namespace durer::interpreter {

namespace w = grammar::words;

namespace {
constexpr std::string_view normal_settings =
    "bumps dents wrinkles ripples waves quilted facets agate boxed bozo brick cells checker "
    "crackle cubic cylindrical gradient granite hexagon leopard marble onion planar radial "
    "spherical spiral1 spiral2 spotted wood average bump_map normal_map slope_map bump_size "
    "accuracy no_bump_scale turbulence frequency phase warp translate rotate scale matrix "
    "transform";
}  // namespace

const scene::Normal& Interpreter::default_normal() const {
  return *scene_.textures[default_texture_].layers.back().normal;
}

scene::Normal Interpreter::read_normal(scene::Normal start) {
  expect_open("normal");
  const Span span = last_span_ = peek().span;
  start.origin = origin(span);
  read_normal_body(start, Token::Kind::close);
  if (!start.pattern->exists() && start.unsupported.empty() && !reading_default_) {
    fail(Code::missing_argument, span, "expected a pattern in `normal`", "write `normal { bumps 0.5 }`");
  }
  if (start.no_bump_scale) keep_bump_scale(start);
  return start;
}

/// `no_bump_scale` goes for everything in a normal.
void Interpreter::keep_bump_scale(scene::Normal& n) {
  n.no_bump_scale = true;
  for (scene::Normal& child : n.children) keep_bump_scale(child);
}

/// Reads up to and including the closing mark `last`.
void Interpreter::read_normal_body(scene::Normal& n, Token::Kind last) {
  for (bool first = true;; first = false) {
    const Token t = peek();
    if (t.kind == last) break;
    if (t.is_punct(';')) {
      next();
      continue;
    }
    if (t.kind == Token::Kind::expr && first) {
      const Value* v = lookup(*t.tree, t.expr, false);
      if (v != nullptr && v->get<Boxed<scene::Normal>>() != nullptr) {
        const scene::OriginId at = n.origin;
        n = **v->get<Boxed<scene::Normal>>();
        if (n.unsupported.empty()) n.origin = at;
        next();
        continue;
      }
      if (v != nullptr && v->get<Shared<Unsupported>>() != nullptr) {
        n.unsupported = (*v->get<Shared<Unsupported>>())->feature;
        next();
        continue;
      }
    }
    if (t.kind != Token::Kind::word) bad_setting(t, "normal", {}, normal_settings);
    next();
    if (t.word == w::uv_mapping) {
      n = {};
      n.origin = origin(t.span);
      read_normal_body(n, last);
      n.uv_mapping = true;
      return;
    }
    if (const auto it = pattern_words_.find(t.word); it != pattern_words_.end() && !registry_.patterns[it->second]->only_pigment &&
        !registry_.patterns[it->second]->only_texture) {
      start_normal_pattern(n, it->second, t);
      continue;
    }
    if (normal_modifier(n, t)) continue;
    if (is_pattern_word(t.word)) {
      n.unsupported = fmt::format("`{}` as a normal", name_of(t.word));
      n.origin = origin(t.span);
      skip_to(last);
      return;
    }
    bad_setting(t, "normal", {}, normal_settings);
  }
  next();
  check_pattern(*n.pattern, n.entries.empty(), "normal_map");
}

void Interpreter::start_normal_pattern(scene::Normal& n, std::uint32_t index, const Token& word) {
  const scene::PatternInfo& info = *registry_.patterns[index];
  n.unsupported.clear();
  n.entries.clear();
  n.children.clear();
  choose_pattern(n.pattern.edit(), index);
  open_list(n.pattern.edit(), word);
  if (info.list_size > 0 && peek().is(w::normal)) {
    for (int i = 0; i < info.list_size; ++i) {
      n.entries.push_back({static_cast<float>(i), static_cast<std::uint32_t>(n.children.size())});
      if (!accept(w::normal)) {
        n.children.push_back(default_normal());
        continue;
      }
      n.children.push_back(read_normal(default_normal()));
      optional_comma();
    }
  }
  close_list(n.pattern.edit(), word);
  read_pattern_operands(n.pattern.edit(), word, &n.amount);
  optional_comma();
  if (starts_number(peek())) n.amount = static_cast<float>(read_scalar("amount"));
}

bool Interpreter::normal_modifier(scene::Normal& n, const Token& t) {
  if (pattern_modifier(n.pattern.edit(), t)) return true;
  const scene::PatternInfo* const info =
      n.pattern->exists() ? registry_.patterns[n.pattern->type] : nullptr;
  const bool block = info != nullptr && info->list_size > 0;
  switch (t.word) {
    case w::bump_size: n.amount = static_cast<float>(read_float()); return true;
    case w::accuracy: n.accuracy = static_cast<float>(read_float()); return true;
    case w::no_bump_scale: n.no_bump_scale = read_switch(true); return true;
    case w::normal_map: {
      if (info == nullptr || block || info->only_normal) bad_map(t, info);
      NormalMap map = read_normal_map(info->averages);
      n.entries = std::move(map.entries);
      n.children = std::move(map.children);
      return true;
    }
    case w::slope_map:
      if (info == nullptr || block || info->averages || (info->only_normal && info->takes_image)) bad_map(t, info);
      n.slopes = read_slope_map().entries;
      return true;
    default: return false;
  }
}

/// `normal_map { [key normal] … }` or `normal_map { Identifier }`.
NormalMap Interpreter::read_normal_map(bool weights) {
  NormalMap map;
  read_map("normal_map", map, weights, [&](float key) {
    scene::Normal child = default_normal();
    child.origin = origin(last_span_);
    read_normal_body(child, Token::Kind::bracket_close);
    map.entries.push_back({key, static_cast<std::uint32_t>(map.children.size())});
    map.children.push_back(std::move(child));
  });
  return map;
}

/// `slope_map { [key <height, slope>] … }` or `slope_map { Identifier }`.
SlopeMap Interpreter::read_slope_map() {
  SlopeMap map;
  read_map("slope_map", map, false, [&](float key) {
    last_span_ = peek().span;
    const Num v = fit(read_full(2), 2);
    map.entries.push_back({key, static_cast<float>(v.v[0]), static_cast<float>(v.v[1])});
    if (const Token close = next(); close.kind != Token::Kind::bracket_close) {
      unexpected(close, "`]`");
    }
  });
  return map;
}

}  // namespace durer::interpreter
