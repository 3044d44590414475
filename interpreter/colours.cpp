// Colours as scenes write them: `rgb <…>`, `red 1`, names (language §2.6).
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/gamma.h"
#include "interpreter/colour_form.h"
#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;

bool Interpreter::starts_colour(const Token& t) {
  if (t.kind != Token::Kind::word) return false;
  switch (t.word) {
    case w::color:
    case w::colour:
    case w::rgb:
    case w::rgbf:
    case w::rgbt:
    case w::rgbft:
    case w::srgb:
    case w::srgbf:
    case w::srgbt:
    case w::srgbft:
    case w::red:
    case w::green:
    case w::blue:
    case w::filter:
    case w::transmit:
    case w::alpha: return true;
    default: return false;
  }
}

namespace {
int component_of(SymbolId word) {
  switch (word) {
    case w::red: return 0;
    case w::green: return 1;
    case w::blue: return 2;
    case w::filter:
    case w::alpha: return 3;
    case w::transmit: return 4;
    default: return -1;
  }
}
}  // namespace

/// The single-component words that may follow any colour: `C filter .5 red 1`.
void Interpreter::continue_colour(Num& c) {
  for (;;) {
    const Token raw = raw_next();
    const Token word = raw.kind == Token::Kind::end && !in_declared_value() ? peek() : raw;
    const int slot = word.kind == Token::Kind::word ? component_of(word.word) : -1;
    if (slot < 0) break;
    next();
    c.v[static_cast<std::size_t>(slot)] = read_float();
  }
}

ColourForm colour_form(SymbolId word) {
  switch (word) {
    case w::rgb: return {3};
    case w::rgbf: return {4};
    case w::rgbt: return {4, true};
    case w::rgbft: return {5};
    case w::srgb: return {3, false, true};
    case w::srgbf: return {4, false, true};
    case w::srgbt: return {4, true, true};
    case w::srgbft: return {5, false, true};
    default: return {};
  }
}

Num to_colour(const Num& n, const ColourForm& form) {
  Num c = n;
  c.length = 5;
  for (auto i = static_cast<std::size_t>(std::max(n.length, form.wanted)); i < 5; ++i) c.v[i] = 0;
  if (form.moves_transmit) c.v[4] = std::exchange(c.v[3], 0);
  return c;
}

/// Warns of components that `rgb` or its like does not take.
void Interpreter::check_components(const Num& n, int wanted, SymbolId word, Span span) {
  if (n.length <= wanted) return;
  warn(Code::evaluation, span,
       fmt::format("`{}` takes {} components, here are {}", name_of(word), wanted, n.length));
}

/// `strict`: a bare expression must be a colour, not just any vector.
Num Interpreter::read_colour_num(bool strict) {
  Num c;
  c.length = 5;
  if (!accept(w::color)) accept(w::colour);
  const Token t = peek();
  const ColourForm form = t.kind == Token::Kind::word ? colour_form(t.word) : ColourForm{};
  if (form.wanted > 0) {
    next();
    if (form.is_srgb && !assumed_gamma_given_ && !native_) {
      fail(Code::evaluation, t.span,
           fmt::format("`{}` needs `assumed_gamma` to be set before it", name_of(t.word)),
           "write `global_settings { assumed_gamma 1 }` at the top of the scene");
    }
    const Num n = read_full(form.wanted);
    check_components(n, form.wanted, t.word, t.span);
    c = to_colour(n, form);
    for (std::size_t i = 0; form.is_srgb && i < 3; ++i) {
      c.v[i] = scene_.settings.assumed_gamma.encode(
          GammaCurve::srgb().decode(static_cast<float>(c.v[i])));
    }
  } else if (t.kind == Token::Kind::expr) {
    const Num n = read_full(strict ? 1 : 5);
    if (strict && n.length != 5) {
      fail(Code::wrong_kind, t.span,
           fmt::format("expected a colour, found a {}", n.length == 1 ? "number" : "vector"),
           "write `rgb` before it");
    }
    c = to_colour(n, {});
  }
  continue_colour(c);
  return c;
}

/// If the next block holds one colour and nothing else, takes the block. None, with nothing done,
/// if it holds anything else.
std::optional<Colour> Interpreter::quick_colour_block() {
  Frame& f = frames_.back();
  if (unread_.size() > unread_base_ || !f.has_items() || f.pos >= f.end || !takes_shortcuts()) {
    return std::nullopt;
  }
  const ast::Tree& tree = *f.tree;
  const ast::Item& block = tree.items[f.pos];
  if (block.kind != ast::ItemKind::braces) return std::nullopt;
  const ast::Range items = tree.groups[block.ref].items;
  const auto word = [&](std::uint32_t i) {
    const ast::Item& item = tree.items[items.first + i];
    return i < items.count && item.kind == ast::ItemKind::word ? item.ref
                                                               : grammar::SymbolTable::none;
  };
  std::uint32_t words = word(0) == w::color || word(0) == w::colour ? 1 : 0;
  const ColourForm form = colour_form(word(words));
  if (form.is_srgb) return std::nullopt;
  if (form.wanted > 0) ++words;
  if (words + 1 != items.count) return std::nullopt;
  const ast::Item& last = tree.items[items.first + words];
  if (last.kind != ast::ItemKind::expr) return std::nullopt;
  if (tree.exprs[last.ref].may_expand && needs_expansion(tree, last.ref)) return std::nullopt;
  Num n;
  if (words == 0) {
    // Something declared: it may be a colour, a pigment, or an error.
    const auto* name = std::get_if<ast::Name>(&tree.exprs[last.ref].node);
    const Value* v = name == nullptr ? nullptr : Environment::value_of(env_.find(name->name));
    const Num* known = v == nullptr ? nullptr : v->get<Num>();
    if (name == nullptr) {
      const Operand* element = array_of(tree.exprs[last.ref]) ? quick(tree, last.ref, 1) : nullptr;
      if (element == nullptr || element->is_text()) return std::nullopt;
      n = element->number();
    } else if (known != nullptr && !env_.find(name->name)->deprecated) {
      n = *known;
    }
    if (n.length != 5) return std::nullopt;
  } else {
    n = evaluate_full(tree, last.ref, form.wanted > 0 ? form.wanted : 5);
    if (form.wanted > 0) {
      const ast::Item& keyword = tree.items[items.first + words - 1];
      check_components(n, form.wanted, keyword.ref, keyword.span);
    }
  }
  ++frames_.back().pos;
  return to_colour(n, form).colour();
}

Colour Interpreter::read_colour() { return read_colour_num().colour(); }

/// Where only red, green and blue are wanted: a float means grey.
vec3 Interpreter::read_rgb() {
  const Token t = peek();
  if (starts_colour(t)) {
    const Colour c = read_colour();
    if (c.filter != 0 || c.transmit != 0) {
      warn(Code::evaluation, t.span, "filter and transmit mean nothing here and are dropped");
    }
    return c.rgb;
  }
  const Num n = read_full(3);
  if (n.length > 3 && (n.v[3] != 0 || n.v[4] != 0)) {
    warn(Code::evaluation, t.span, "filter and transmit mean nothing here and are dropped");
  }
  return n.colour().rgb;
}

}  // namespace durer::interpreter
