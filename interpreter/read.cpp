// Readers that pull from the stream: expressions operand by operand, strings, and values of any kind.
// Colours are in colours.cpp.
#include <cmath>

#include <fmt/format.h>

#include "base/suggest.h"
#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;

// ---- small things
// ---------------------------------------------------------------------------------

bool Interpreter::accept(SymbolId word) {
  if (!peek().is(word)) return false;
  next();
  return true;
}

bool Interpreter::accept_punct(char c) {
  if (!peek().is_punct(c)) return false;
  next();
  return true;
}

/// Commas between operands are optional (language §1.8).
void Interpreter::optional_comma() { accept_raw_comma_or_peek(); }

/// The same between arguments of functions: a comma that nothing follows has lost an argument. True
/// if there was one.
bool Interpreter::argument_comma() {
  const Token t = raw_next();
  optional_comma();
  if (!t.is_punct(',')) return false;
  if (peek().kind == Token::Kind::end) {
    fail(Code::missing_argument, t.span, "expected another argument after this comma",
         "remove the comma if the arguments are complete");
  }
  return true;
}

/// Takes a comma if one follows. Nothing is executed to find out when the next item tells.
void Interpreter::accept_raw_comma_or_peek() {
  if (Frame& f = frames_.back();
      unread_.size() <= unread_base_ && f.has_items() && f.pos < f.end) {
    const ast::Item& item = f.tree->items[f.pos];
    if (item.kind == ast::ItemKind::punct && item.detail == ',') {
      ++f.pos;
      return;
    }
    if (item.kind != ast::ItemKind::directive && item.kind != ast::ItemKind::expr) return;
  }
  const Token raw = raw_next();
  if (raw.is_punct(',')) {
    next();
  } else if (raw.kind == Token::Kind::end) {
    accept_punct(',');
  }
}

void Interpreter::expect_open(std::string_view block) {
  const Token t = next();
  if (t.kind != Token::Kind::open) unexpected(t, fmt::format("`{{` after `{}`", block));
}

void Interpreter::expect_close(std::string_view block, Span opened) {
  Token t = next();
  while (t.is_punct(';')) t = next();  // a stray `;` means nothing (language §1.7)
  if (t.kind == Token::Kind::close) return;
  Diagnostic d;
  d.code = t.kind == Token::Kind::word ? Code::unknown_setting : Code::unexpected_item;
  d.span = t.span;
  d.message = t.kind == Token::Kind::word
                  ? fmt::format("`{}` has no setting `{}`", block, name_of(t.word))
                  : fmt::format("expected `}}` at the end of `{}`, found {}", block, describe(t));
  if (opened.begin != 0) d.labels.push_back({opened, "in this block"});
  fail(std::move(d));
}

std::string Interpreter::describe(const Token& t) const {
  switch (t.kind) {
    case Token::Kind::end: return "the end";
    case Token::Kind::word: return fmt::format("`{}`", name_of(t.word));
    case Token::Kind::open: return "`{`";
    case Token::Kind::close: return "`}`";
    case Token::Kind::bracket_open: return "`[`";
    case Token::Kind::bracket_close: return "`]`";
    case Token::Kind::punct:
      return t.punct == 'l'   ? "`<=`"
             : t.punct == 'g' ? "`>=`"
             : t.punct == 'n' ? "`!=`"
                              : fmt::format("`{}`", t.punct);
    case Token::Kind::expr: {
      if (const auto* name = t.node<ast::Name>()) return fmt::format("`{}`", name_of(name->name));
      if (t.node<ast::Number>() != nullptr) return "a number";
      if (t.node<ast::String>() != nullptr) return "a string";
      if (t.node<ast::Vector>() != nullptr) return "a vector";
      return "an expression";
    }
  }
  return "something else";
}

void Interpreter::unexpected(const Token& t, std::string_view expected) {
  if (const auto* name = t.node<ast::Name>();
      name != nullptr && !symbols_.reserved(name->name) && env_.find(name->name) == nullptr) {
    unknown_name(name->name, t.span);
  }
  fail(t.kind == Token::Kind::end ? Code::missing_argument : Code::unexpected_item, t.span,
       fmt::format("expected {}, found {}", expected, describe(t)));
}

void Interpreter::bad_setting(const Token& t, std::string_view block, Span opened,
                              std::string_view settings) {
  const auto* name = t.node<ast::Name>();
  const bool undeclared =
      name != nullptr && !symbols_.reserved(name->name) && env_.find(name->name) == nullptr;
  if (t.kind != Token::Kind::word && !undeclared) {
    unexpected(t, fmt::format("a setting of `{}` or `}}`", block));
  }
  const std::string_view word = name_of(undeclared ? name->name : t.word);
  Diagnostic d;
  d.code = Code::unknown_setting;
  d.span = t.span;
  d.message = fmt::format("`{}` has no setting `{}`", block, word);
  d.at = "unknown setting";
  if (opened.begin != 0) d.labels.push_back({opened, "in this block"});
  std::vector<std::string_view> words;
  for (std::size_t at = 0; at < settings.size();) {
    const std::size_t end = std::min(settings.find(' ', at), settings.size());
    words.push_back(settings.substr(at, end - at));
    at = end + 1;
  }
  if (const auto near = closest(word, words))
    d.help.push_back(fmt::format("did you mean `{}`?", *near));
  fail(std::move(d));
}

void Interpreter::skip_block() {
  for (std::size_t depth = 1; depth > 0;) {
    const Token t = next();
    if (t.kind == Token::Kind::open) ++depth;
    if (t.kind == Token::Kind::close) --depth;
    if (t.kind == Token::Kind::end) unexpected(t, "`}`");
  }
}

Value Interpreter::skip_unsupported(std::string_view feature, Span span) {
  expect_open(feature);
  skip_block();
  return Value(std::make_shared<const Unsupported>(Unsupported{std::string(feature), span}));
}

// ---- expressions
// ----------------------------------------------------------------------------------

namespace {

bool is_operator(char c) { return c == '+' || c == '-' || c == '*' || c == '/'; }
bool is_full_operator(char c) {
  return c == '<' || c == '>' || c == 'l' || c == 'g' || c == '=' || c == 'n' || c == '&' ||
         c == '|' || c == '?';
}

ast::Op op_of(char c) {
  switch (c) {
    case '+': return ast::Op::add;
    case '-': return ast::Op::sub;
    case '*': return ast::Op::mul;
    case '/': return ast::Op::div;
    case '<': return ast::Op::lt;
    case '>': return ast::Op::gt;
    case 'l': return ast::Op::le;
    case 'g': return ast::Op::ge;
    case '=': return ast::Op::eq;
    case 'n': return ast::Op::ne;
    case '&': return ast::Op::and_;
    default: return ast::Op::or_;
  }
}

/// The sign that the expression begins with, as written: in operator position it is an operator.
const ast::Unary* leading_sign(const ast::Tree& tree, ast::ExprId id) {
  for (;;) {
    const ast::Expr& e = tree.exprs[id];
    if (const auto* b = std::get_if<ast::Binary>(&e.node)) {
      id = b->left;
    } else if (const auto* u = std::get_if<ast::Unary>(&e.node)) {
      return u->op == ast::Op::not_ ? nullptr : u;
    } else {
      return nullptr;
    }
  }
}

}  // namespace

/// True if what is written at `pos` of the frame cannot continue an expression, whatever directives
/// would do. `full`: nor as a relation.
bool Interpreter::ends_expression(const Frame& f, std::uint32_t pos, bool full) {
  if (pos >= f.end) return f.kind == Frame::Kind::group || f.kind == Frame::Kind::barrier;
  const ast::Item& item = f.tree->items[pos];
  switch (item.kind) {
    case ast::ItemKind::word:
    case ast::ItemKind::braces:
    case ast::ItemKind::brackets: return true;
    case ast::ItemKind::directive:
    case ast::ItemKind::literals: return false;
    case ast::ItemKind::expr:  // the body of a macro may begin with an operator
      return leading_sign(*f.tree, item.ref) == nullptr && !f.tree->exprs[item.ref].may_expand;
    case ast::ItemKind::punct:
      return !is_operator(item.detail) && item.detail != '.' &&
             !(full && (is_full_operator(item.detail) || item.detail == ':'));
  }
  return false;
}

/// The commonest case by far: the next item is a whole expression that needs no spelling out, and
/// nothing that could continue it follows. Takes it and says which; `none` otherwise.
ast::ExprId Interpreter::take_plain(const ast::Tree*& tree, bool full) {
  Frame& f = frames_.back();
  if (!f.has_items() || f.flatten || (version() < 150 && !full)) return ast::none;
  if (unread_.size() > unread_base_) {
    // It has been looked at already: then it stands before what the frame delivers next.
    const Token& seen = unread_.back();
    if (unread_.size() > unread_base_ + 1 || seen.kind != Token::Kind::expr || f.pos == f.first ||
        seen.tree != f.tree || f.tree->items[f.pos - 1].ref != seen.expr ||
        f.tree->items[f.pos - 1].kind != ast::ItemKind::expr || !ends_expression(f, f.pos, full)) {
      return ast::none;
    }
    const ast::ExprId id = seen.expr;
    last_span_ = seen.span;
    unread_.pop_back();
    tree = f.tree;
    return id;
  }
  if (f.pos >= f.end) return ast::none;
  const ast::Item& item = f.tree->items[f.pos];
  if (item.kind != ast::ItemKind::expr || !ends_expression(f, f.pos + 1, full) ||
      needs_expansion(*f.tree, item.ref)) {
    return ast::none;
  }
  ++f.pos;
  last_span_ = item.span;
  tree = f.tree;
  return item.ref;
}

/// True if what follows continues an expression; then it has been peeked at. Directives are
/// executed only where the next item does not tell, and never behind the value of a #declare.
bool Interpreter::at_operator() {
  Token t = raw_next();
  if (t.kind == Token::Kind::end) {
    const Frame& f = frames_.back();
    const bool items_left = f.has_items() && f.pos < f.end;
    if (f.kind == Frame::Kind::barrier && !items_left) return false;
    if (in_declared_value()) {
      leave_ended_frames();
      t = raw_next();
    } else {
      t = peek();
    }
  }
  if (t.kind == Token::Kind::punct) return is_operator(t.punct);
  return t.kind == Token::Kind::expr && leading_sign(*t.tree, t.expr) != nullptr;
}

/// True if the value of a #declare is being read, outside of any block or delimiter in it.
bool Interpreter::in_declared_value() const {
  if (declare_depth_ == 0) return false;
  for (std::size_t i = frames_.size(); i > declare_depth_; --i) {
    if (frames_[i - 1].kind == Frame::Kind::group) return false;
  }
  return true;
}

/// Closes the bodies and branches that have been read to their ends, executing nothing.
void Interpreter::leave_ended_frames() {
  while (frames_.size() > declare_depth_) {
    const Frame& f = frames_.back();
    const bool ended =
        f.kind == Frame::Kind::expansion ? pieces_.size() == f.pieces : f.pos >= f.end;
    const bool closes = f.kind == Frame::Kind::expansion || f.kind == Frame::Kind::macro ||
                        f.kind == Frame::Kind::branch;
    if (!ended || !closes) return;
    pop();
  }
}

bool Interpreter::at_full_operator() {
  if (at_operator()) return true;
  const Token t = unread_.size() > unread_base_ ? unread_.back() : raw_next();
  return t.kind == Token::Kind::punct && is_full_operator(t.punct);
}

/// The next token; an expression that begins with a sign is spelled out, so that the sign can be an
/// operator.
Token Interpreter::next_operator() {
  Token t = next();
  if (t.kind == Token::Kind::expr) {
    expand(*t.tree, t.expr, true);
    t = next();
  }
  return t;
}

Num Interpreter::read_factor(int length) {
  const Token t = next();
  if (t.kind == Token::Kind::punct) {
    if (t.punct == '-') return unary(ast::Op::neg, read_factor(length));
    if (t.punct == '+') return read_factor(length);
    if (t.punct == '!') return unary(ast::Op::not_, read_factor(length));
  }
  if (t.kind != Token::Kind::expr) unexpected(t, "a number or vector");
  const ast::Expr& e = t.expression();
  const bool compound = std::holds_alternative<ast::Binary>(e.node) ||
                        std::holds_alternative<ast::Unary>(e.node) ||
                        std::holds_alternative<ast::Conditional>(e.node);
  if (compound) {
    expand(*t.tree, t.expr, true);
    return read_factor(length);
  }
  Num n = evaluate(*t.tree, t.expr, length);
  if (raw_next().is_punct('.') ||
      (raw_next().kind == Token::Kind::end && frames_.back().kind != Frame::Kind::barrier &&
       flatten_context() && peek().is_punct('.'))) {
    next();
    const Token name = next();
    n = member(n, name.word, name.span, length);
  }
  return n;
}

/// True while an expression with macro calls is being spelled out: its operators may follow the end
/// of a macro body.
bool Interpreter::flatten_context() const {
  for (std::size_t i = frames_.size(); i-- > 0;) {
    if (frames_[i].kind == Frame::Kind::expansion) return true;
    if (frames_[i].kind == Frame::Kind::barrier) return false;
    if (!frames_[i].flatten) return false;
  }
  return false;
}

Num Interpreter::read_product(int length) {
  Num n = read_factor(length);
  for (;;) {
    if (!at_operator()) return n;
    const Token t = peek();
    if (t.kind != Token::Kind::punct || (t.punct != '*' && t.punct != '/')) return n;
    next();
    n = binary(op_of(t.punct), n, read_factor(n.length), t.span);
  }
}

Num Interpreter::read_num(int length) {
  const ast::Tree* tree = nullptr;
  if (const ast::ExprId id = take_plain(tree, false); id != ast::none) {
    return evaluate(*tree, id, length);
  }
  if (version() < 150) return read_factor(length);  // as in version 1: `-1 -1` is two numbers
  // The common case: one closed expression, nothing after it.
  const Token t = next();
  if (t.kind == Token::Kind::expr && !flatten_context()) {
    const ast::Expr& e = t.expression();
    const auto* sum = std::get_if<ast::Binary>(&e.node);
    const bool is_sum = sum != nullptr && (sum->op == ast::Op::add || sum->op == ast::Op::sub);
    if (!is_sum) {
      const Num n = evaluate(*t.tree, t.expr, length);
      if (!at_operator()) return n;
      return continue_sum(continue_product(n));
    }
    // The last term is kept apart until it is clear that no `*` follows.
    const Num left = evaluate(*t.tree, sum->left, length);
    Num term = evaluate(*t.tree, sum->right, left.length);
    if (at_operator()) term = continue_product(term);
    return continue_sum(binary(sum->op, left, term, e.span));
  }
  unread(t);
  return continue_sum(read_product(length));
}

Num Interpreter::continue_product(Num n) {
  while (at_operator()) {
    const Token t = peek();
    if (t.kind != Token::Kind::punct || (t.punct != '*' && t.punct != '/')) break;
    next();
    n = binary(op_of(t.punct), n, read_factor(n.length), t.span);
  }
  return n;
}

Num Interpreter::continue_sum(Num n) {
  while (at_operator()) {
    const Token op = next_operator();
    n = binary(op_of(op.punct), n, read_product(n.length), op.span);
  }
  return n;
}

/// Full level without the final replication.
Num Interpreter::read_full_in_place(int length) {
  if (const Token& t = peek(); t.kind == Token::Kind::expr && is_text(*t.tree, t.expr)) {
    const Text left = read_text();
    const Token op = next();
    if (op.kind != Token::Kind::punct || !is_full_operator(op.punct)) {
      unexpected(op, "a comparison after this string");
    }
    const Text right = read_text();
    const int order = left < right ? -1 : (right < left ? 1 : 0);
    return Num::filled(binary(op_of(op.punct), Num(order), Num(0.0), op.span).v[0], length);
  }
  const auto relation = [&] {
    Num n = read_num(length);
    while (at_full_operator()) {
      const Token op = peek();
      if (op.punct == '&' || op.punct == '|' || op.punct == '?') break;
      next();
      n = binary(op_of(op.punct), n, read_num(n.length), op.span);
    }
    return n;
  };
  Num n = relation();
  while (at_full_operator()) {
    const Token op = peek();
    if (op.punct == '?') break;
    next();
    n = binary(op_of(op.punct), n, relation(), op.span);
  }
  if (!at_full_operator() || !peek().is_punct('?')) return n;
  const Span at = next().span;
  if (n.length != 1 && length == 1)
    fail(Code::wrong_kind, at, "the condition of `?:` must be a float");
  const bool first = std::abs(n.v[0]) > epsilon;
  const Num yes = read_full(length);
  const Token colon = next();
  if (!colon.is_punct(':')) unexpected(colon, "`:`");
  const Num no = read_full(length);
  return first ? yes : no;
}

Num Interpreter::read_full(int length) {
  const ast::Tree* tree = nullptr;
  if (const ast::ExprId id = take_plain(tree, true); id != ast::none) {
    return evaluate_full(*tree, id, length);
  }
  const Num n = read_full_in_place(length);
  return n.length == 1 && length > 1 ? Num::filled(n.v[0], length) : n;
}

/// Checks the length against what the place wants; shorter vectors are zero-padded already.
const Num& Interpreter::fit(const Num& n, int length) {
  if (n.length <= length) return n;
  fail(Code::wrong_kind, last_span_,
       length == 1
           ? fmt::format("expected a float, found a {}", n.length == 5 ? "colour" : "vector")
           : fmt::format("expected {} components, found {}", length, n.length),
       length == 1 ? "pick a component, as in `V.x`" : "");
}

double Interpreter::read_scalar(std::string_view what) {
  const ast::Tree* tree = nullptr;
  if (const ast::ExprId id = take_plain(tree, false); id != ast::none) {
    return work_out_float(*tree, id, what);
  }
  const Span at = peek().span;
  const Num n = read_num(1);
  if (n.length != 1) {
    fail(Code::wrong_kind, at,
         fmt::format("expected a float as {}, found a value of {} components", what, n.length),
         "pick a component, as in `V.x`");
  }
  return n.v[0];
}

double Interpreter::read_float() { return read_scalar("operand"); }

dvec3 Interpreter::read_vector() {
  const ast::Tree* tree = nullptr;
  if (const ast::ExprId id = take_plain(tree, false); id != ast::none) {
    Num n;
    n.length = work_out(*tree, id, 3, n.v.data());
    return fit(n, 3).vec();
  }
  last_span_ = peek().span;
  return fit(read_num(3), 3).vec();
}

bool Interpreter::starts_number(const Token& t) {
  if (t.kind == Token::Kind::punct) return t.punct == '-' || t.punct == '+' || t.punct == '!';
  if (t.kind != Token::Kind::expr) return false;
  if (t.node<ast::Name>() != nullptr || t.node<ast::Index>() != nullptr) {
    const Value* v = lookup(*t.tree, t.expr, false);
    return v == nullptr
               ? t.node<ast::Name>() != nullptr && symbols_.reserved(t.node<ast::Name>()->name)
               : v->get<Num>() != nullptr;
  }
  return !is_text(*t.tree, t.expr);
}

bool Interpreter::read_switch(bool fallback) {
  return starts_number(peek()) ? read_float() > 0 : fallback;
}

Text Interpreter::read_text(bool file_name) {
  const Token t = next();
  if (t.kind != Token::Kind::expr) unexpected(t, "a string");
  return evaluate_text(*t.tree, t.expr, file_name);
}

// ---- values of any kind
// ------------------------------------------------------------------------------

Value Interpreter::read_value() {
  check_stack(last_span_);
  const Token t = peek();
  if (t.kind == Token::Kind::expr) {
    if (starts_dictionary(t)) return read_dictionary();
    if (t.node<ast::Name>() != nullptr || t.node<ast::Index>() != nullptr ||
        t.node<ast::Call>() != nullptr || additions_) {
      const Value* v = lookup(*t.tree, t.expr, false);
      if (v != nullptr && v->defined() && v->get<Num>() == nullptr) {
        next();
        return *v;
      }
    }
    if (is_text(*t.tree, t.expr)) return text_value(read_text());
    return Value(read_num(1));
  }
  if (t.kind == Token::Kind::punct) return Value(read_num(1));
  if (t.kind != Token::Kind::word) unexpected(t, "a value");
  if (starts_colour(t)) return Value(read_colour_num());
  if (starts_object(t)) {
    next();
    return Value(ObjectRef{read_object(t)});
  }
  next();
  switch (t.word) {
    case w::texture: {
      scene::TextureUse use{read_texture("texture"), {}};
      while (raw_next().is(w::texture)) {
        next();
        add_layers(use, read_texture("texture"));
      }
      return Value(TextureRef{use.texture});
    }
    case w::pigment:
      return Value(Boxed<scene::Pigment>(
          read_pigment(*scene_.textures[default_texture_].layers.back().pigment)));
    case w::finish:
      return Value(Boxed<scene::Finish>(
          read_finish(*scene_.textures[default_texture_].layers.back().finish)));
    case w::color_map:
    case w::colour_map: return Value(std::make_shared<const ColourMap>(read_colour_map()));
    case w::pigment_map: return Value(std::make_shared<const ColourMap>(read_pigment_map(true)));
    case w::normal: return Value(Boxed<scene::Normal>(read_normal(default_normal())));
    case w::normal_map: return Value(std::make_shared<const NormalMap>(read_normal_map(true)));
    case w::slope_map: return Value(std::make_shared<const SlopeMap>(read_slope_map()));
    case w::texture_map: return Value(std::make_shared<const TextureMap>(read_texture_map(true)));
    case w::media: return Value(std::make_shared<const scene::Media>(read_media(t.span)));
    case w::density: return Value(std::make_shared<const Density>(Density{read_density()}));
    case w::density_map: return Value(std::make_shared<const DensityMap>(read_density_map(true)));
    case w::interior: return Value(InteriorRef{read_interior()});
    case w::material: return Value(std::make_shared<const Material>(read_material()));
    case w::transform: return Value(std::make_shared<const Transform>(read_transform_block()));
    case w::camera: return Value(read_camera(t.span));
    case w::sky_sphere:
      return Value(std::make_shared<const scene::SkySphere>(read_sky_sphere(t.span)));
    case w::fog: return Value(std::make_shared<const scene::Fog>(read_fog(t.span)));
    case w::rainbow: return Value(std::make_shared<const scene::Rainbow>(read_rainbow(t.span)));
    case w::array: return Value(read_array(t.span));
    case w::function: return read_function(t.span);
    case w::spline: return Value(read_spline(t.span));
    case w::bump_map:
    case w::material_map: return skip_unsupported(name_of(t.word), t.span);
    default: unexpected(t, "a value");
  }
}

}  // namespace durer::interpreter
