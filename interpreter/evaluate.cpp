// Closed expressions: parts of a syntax tree without macro calls at their operator level. What
// stands inside delimiters and does hold macro calls or directives is read by a nested reader.
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/gamma.h"
#include "base/suggest.h"
#include "interpreter/interpreter.h"
#include "interpreter/macro_value.h"

namespace durer::interpreter {

namespace w = grammar::words;

// ---- arithmetic (language §2.4, §2.5)
// ------------------------------------------------------------

namespace {

/// Makes both sides equally long: a float is replicated, a shorter vector padded with zeros.
void match_lengths(Num& a, Num& b) {
  const auto stretch = [](Num& n, int length) {
    for (int i = n.length; i < length; ++i) {
      n.v[static_cast<std::size_t>(i)] = n.length == 1 ? n.v[0] : 0.0;
    }
    n.length = length;
  };
  if (a.length < b.length) stretch(a, b.length);
  if (b.length < a.length) stretch(b, a.length);
}

/// What parentheses leave: their content is read without knowing the length wanted, then a float
/// fills it and a shorter vector is padded with zeros.
Num widened(Num n, int length) {
  if (n.length == 1) return Num::filled(n.v[0], length);
  if (n.length < length) n.length = length;
  return n;
}

double truth(bool b) { return b ? 1.0 : 0.0; }

double apply(ast::Op op, double a, double b) {
  switch (op) {
    case ast::Op::add: return a + b;
    case ast::Op::sub: return a - b;
    case ast::Op::mul: return a * b;
    case ast::Op::div: return b == 0 ? std::numeric_limits<double>::infinity() : a / b;
    case ast::Op::lt: return truth(a < b);
    case ast::Op::le: return truth(a < b || !(std::abs(a - b) > epsilon));
    case ast::Op::eq: return truth(!(std::abs(a - b) > epsilon));  // true for NaN, as in the oracle
    case ast::Op::ne: return truth(std::abs(a - b) > epsilon);
    case ast::Op::ge: return truth(a > b || !(std::abs(a - b) > epsilon));
    case ast::Op::gt: return truth(a > b);
    case ast::Op::and_: return truth(std::abs(a) > epsilon && std::abs(b) > epsilon);
    case ast::Op::or_: return truth(std::abs(a) > epsilon || std::abs(b) > epsilon);
    case ast::Op::neg:
    case ast::Op::pos:
    case ast::Op::not_: break;
  }
  return 0;
}

/// Strings are compared code by code.
double compare(ast::Op op, const Text& l, const Text& r) {
  return apply(op, l < r ? -1 : (r < l ? 1 : 0), 0);
}

}  // namespace

Num Interpreter::binary(ast::Op op, Num left, Num right, Span span) {
  match_lengths(left, right);
  const auto n = static_cast<std::size_t>(left.length);
  for (std::size_t i = 0; i < n; ++i) {
    if (op == ast::Op::div && right.v[i] == 0) {
      warn(Code::evaluation, span, "division by zero; the result is infinite");
    }
    left.v[i] = apply(op, left.v[i], right.v[i]);
  }
  return left;
}

Num Interpreter::unary(ast::Op op, Num operand) {
  const auto n = static_cast<std::size_t>(operand.length);
  for (std::size_t i = 0; i < n; ++i) {
    if (op == ast::Op::neg) operand.v[i] = -operand.v[i];
    if (op == ast::Op::not_) operand.v[i] = truth(!(std::abs(operand.v[i]) > epsilon));
  }
  return operand;
}

/// `.x`: slot 0 gets the component, the others keep what they held (language §2.4).
Num Interpreter::member(Num object, SymbolId name, Span span, int length) {
  int slot = -1;
  switch (name) {
    case w::x:
    case w::u:
    case w::red: slot = 0; break;
    case w::y:
    case w::v:
    case w::green: slot = 1; break;
    case w::z:
    case w::blue: slot = 2; break;
    case w::t:
    case w::filter: slot = 3; break;
    case w::transmit: slot = 4; break;
    case w::gray:
      object.v[0] = 0.297 * object.v[0] + 0.589 * object.v[1] + 0.114 * object.v[2];
      object.length = 1;
      return object;
    default:
      fail(Code::unknown_name, span, fmt::format("`{}` is no component", name_of(name)),
           "components are x y z t, u v, red green blue filter transmit, gray");
  }
  if (slot >= object.length) {
    fail(Code::wrong_kind, span,
         fmt::format("there is no component `{}` in a value of {} component{}", name_of(name),
                     object.length, object.length == 1 ? "" : "s"));
  }
  if (object.length == 1) return Num::filled(object.v[0], length);
  object.v[0] = object.v[static_cast<std::size_t>(slot)];
  object.length = 1;
  return object;
}

// ---- names --------------------------------------------------------------------------------------

void Interpreter::unknown_name(SymbolId name, Span span) {
  std::vector<std::string_view> names;
  for (const SymbolId id : env_.visible_names()) names.push_back(name_of(id));
  for (SymbolId id = 0; id < w::count_; ++id) names.push_back(name_of(id));
  const auto near = closest(name_of(name), names);
  fail(Code::unknown_name, span, fmt::format("`{}` is not declared", name_of(name)),
       near ? fmt::format("did you mean `{}`?", *near) : std::string());
}

Num Interpreter::value_as_num(const Value& v, Span span, int length) {
  if (const Num* n = v.get<Num>()) return n->length == 1 ? Num::filled(n->v[0], length) : *n;
  if (const auto* u = v.get<Shared<Unsupported>>()) not_supported((*u)->feature, span);
  fail(Code::wrong_kind, span, fmt::format("expected a number or vector, found {}", kind_name(v)));
}

Num Interpreter::evaluate_name(const ast::Expr& e, SymbolId name, int length) {
  if (!symbols_.reserved(name)) {
    Slot* slot = env_.find(name);
    const Value* v = Environment::value_of(slot);
    if (v == nullptr) unknown_name(name, e.span);
    note_use(slot, e.span);
    return value_as_num(*v, e.span, length);
  }
  const auto vector = [](double a, double b, double c) { return Num(dvec3(a, b, c)); };
  switch (name) {
    case w::x: return vector(1, 0, 0);
    case w::y: return vector(0, 1, 0);
    case w::z: return vector(0, 0, 1);
    case w::u:
    case w::v: {
      Num n;
      n.v = {name == w::u ? 1.0 : 0.0, name == w::v ? 1.0 : 0.0};
      n.length = 2;
      return n;
    }
    case w::t: {
      Num n;
      n.v = {0, 0, 0, 1};
      n.length = 4;
      return n;
    }
    case w::pi: return Num::filled(3.14159265358979323846, length);
    case w::true_:
    case w::yes:
    case w::on: return Num::filled(1, length);
    case w::false_:
    case w::no:
    case w::off: return Num::filled(0, length);
    case w::clock: return Num::filled(static_cast<float>(options_.clock), length);
    case w::clock_on: return Num::filled(options_.clock_on ? 1 : 0, length);
    case w::version: return Num::filled(declared_version_ / 100.0, length);
    case w::now: return Num::filled(days_since_2000(), length);
    default:
      fail(Code::unexpected_item, e.span,
           fmt::format("expected a value, found the word `{}`", name_of(name)));
  }
}

Value* Interpreter::lookup(const ast::Tree& tree, ast::ExprId id, bool must_exist) {
  const ast::Expr& e = tree.exprs[id];
  if (const auto* name = std::get_if<ast::Name>(&e.node)) {
    if (symbols_.reserved(name->name)) return nullptr;
    Slot* slot = env_.find(name->name);
    Value* v = Environment::value_of(slot);
    if (v == nullptr && must_exist) unknown_name(name->name, e.span);
    note_use(slot, e.span);
    return v;
  }
  if (const auto array = array_of(e)) {
    return element(*array, read_subscripts(tree, id), e.span, false, must_exist);
  }
  return nullptr;
}

// ---- expressions
// ----------------------------------------------------------------------------------

Num Interpreter::evaluate(const ast::Tree& tree, ast::ExprId id, int length) {
  const ast::Expr& e = tree.exprs[id];
  if (e.may_expand && needs_expansion(tree, id)) {
    Nested part(*this, tree, id);
    const Num n = read_full_in_place(length);
    part.finish("an operator or the end of this expression");
    return n;
  }
  return evaluate_closed(tree, id, length);
}

/// No call at the operator level needs to be spelled out: see needs_expansion.
Num Interpreter::evaluate_closed(const ast::Tree& tree, ast::ExprId id, int length) {
  const ast::Expr& e = tree.exprs[id];
  // A switch over the alternatives, most frequent first in mind: this is the interpreter's inner
  // loop.
  enum Kind : std::size_t {
    number,
    string,
    name,
    paren,
    vector,
    unary_,
    binary_,
    conditional,
    call,
    index,
    member_,
    open
  };
  switch (e.node.index()) {
    case number: return Num::filled(std::get_if<ast::Number>(&e.node)->value, length);
    case string: fail(Code::wrong_kind, e.span, "expected a number or vector, found a string");
    case name: return evaluate_name(e, std::get_if<ast::Name>(&e.node)->name, length);
    case paren:
      return widened(evaluate_full(tree, std::get_if<ast::Paren>(&e.node)->inner, 1), length);
    case vector: return evaluate_vector(tree, *std::get_if<ast::Vector>(&e.node), e.span);
    case unary_: {
      const auto& u = *std::get_if<ast::Unary>(&e.node);
      return unary(u.op, evaluate_closed(tree, u.operand, length));
    }
    case binary_: return evaluate_binary(tree, e, *std::get_if<ast::Binary>(&e.node), length);
    case conditional:
      return evaluate_conditional(tree, e, *std::get_if<ast::Conditional>(&e.node), length);
    case call: return evaluate_call(tree, e, *std::get_if<ast::Call>(&e.node), length);
    case index: {
      const auto& i = *std::get_if<ast::Index>(&e.node);
      return value_as_num(*element(i.name, read_subscripts(tree, i.subscripts), e.span, false),
                          e.span, length);
    }
    case member_: {
      const auto& m = *std::get_if<ast::Member>(&e.node);
      return member(evaluate_closed(tree, m.object, 1), m.member, e.span, length);
    }
    case open: return evaluate_open(tree, e, *std::get_if<ast::OpenGroup>(&e.node), length);
    default: break;
  }
  fail(Code::syntax, e.span, "an expression that cannot be evaluated");
}

Num Interpreter::evaluate_binary(const ast::Tree& tree, const ast::Expr& e, const ast::Binary& b,
                                 int length) {
  const bool relation = b.op >= ast::Op::lt && b.op <= ast::Op::gt;
  if (relation && is_text(tree, b.left)) {
    return Num::filled(
        compare(b.op, evaluate_text(tree, b.left), evaluate_text(tree, b.right)), length);
  }
  Num left;
  if (relation && tree.exprs[b.left].may_expand && is_macro_call(tree, b.left)) {
    // Only its value tells whether numbers or strings are compared.
    const Value v = evaluate_value(tree, b.left);
    if (const auto* text = v.get<Shared<Text>>()) {
      return Num::filled(compare(b.op, **text, evaluate_text(tree, b.right)), length);
    }
    left = value_as_num(v, tree.exprs[b.left].span, length);
  } else {
    left = evaluate_closed(tree, b.left, length);
  }
  const Num right = evaluate_closed(tree, b.right, left.length);
  if (left.length == 1 && right.length == 1) {  // floats, by far the commonest
    if (b.op == ast::Op::div && right.v[0] == 0) {
      warn(Code::evaluation, e.span, "division by zero; the result is infinite");
    }
    left.v[0] = apply(b.op, left.v[0], right.v[0]);
    return left;
  }
  return binary(b.op, left, right, e.span);
}

Num Interpreter::evaluate_conditional(const ast::Tree& tree, const ast::Expr& e,
                                      const ast::Conditional& c, int length) {
  // Both branches are always evaluated: random streams advance (language §2.2).
  const Num condition = evaluate_full(tree, c.condition, 1);
  if (condition.length != 1)
    fail(Code::wrong_kind, e.span, "the condition of `?:` must be a float");
  const bool first = std::abs(condition.v[0]) > epsilon;
  const Num yes = evaluate_full(tree, c.yes, length);
  const Num no = evaluate_full(tree, c.no, length);
  return first ? yes : no;
}

Num Interpreter::evaluate_full(const ast::Tree& tree, ast::ExprId id, int length) {
  Num n = evaluate(tree, id, length);
  if (n.length == 1 && length > 1) n = Num::filled(n.v[0], length);
  return n;
}

Num Interpreter::evaluate_vector(const ast::Tree& tree, const ast::Vector& v, Span span) {
  bool expands = false;
  for (std::uint32_t i = 0; i < v.components.count && !expands; ++i) {
    expands = needs_expansion(tree, tree.expr_lists[v.components.first + i], true);
  }
  if (expands) return read_components(tree, v.components, span);
  if (v.components.count > 5 || v.components.count < 2) {
    fail(Code::evaluation, span,
         fmt::format("a vector has 2 to 5 components, here are {}", v.components.count));
  }
  Num n;
  n.length = static_cast<int>(v.components.count);
  for (std::uint32_t i = 0; i < v.components.count; ++i) {
    const ast::ExprId id = tree.expr_lists[v.components.first + i];
    const Num c = evaluate(tree, id, 1);
    if (c.length != 1) {
      fail(Code::wrong_kind, tree.exprs[id].span,
           fmt::format("expected a float as component, found a value of {} components", c.length));
    }
    n.v[i] = c.v[0];
  }
  return n;
}

/// Components of a vector some of which are macro calls: a body may hold `1, 2`.
Num Interpreter::read_components(const ast::Tree& tree, ast::Range components, Span span) {
  Num n;
  n.length = 0;
  for (std::uint32_t i = 0; i < components.count; ++i) {
    const Nested part(*this, tree, tree.expr_lists[components.first + i]);
    while (peek().kind != Token::Kind::end) {
      if (n.length == 5) fail(Code::evaluation, span, "a vector has at most 5 components");
      n.v[static_cast<std::size_t>(n.length++)] = read_scalar("a component");
      optional_comma();
    }
  }
  if (n.length < 2) fail(Code::evaluation, span, "a vector has at least 2 components");
  return n;
}

Num Interpreter::evaluate_open(const ast::Tree& tree, const ast::Expr& e, const ast::OpenGroup& g,
                               int length) {
  using Kind = ast::OpenGroup::Kind;
  if (g.kind == Kind::call) {
    const auto* name = std::get_if<ast::Name>(&tree.exprs[g.callee].node);
    if (name != nullptr && symbols_.reserved(name->name)) {
      return call_builtin(tree, e, name->name, {}, &g, length);
    }
    const Value* v = lookup(tree, g.callee, true);
    call_value(*v, e.span);
  }
  if (g.kind == Kind::index) {
    const ast::ExprId id = static_cast<ast::ExprId>(&e - tree.exprs.data());
    return value_as_num(*lookup(tree, id, true), e.span, length);
  }
  Nested part(*this, tree, g.items);
  if (g.kind == Kind::paren) {
    const Num n = read_full(1);
    part.finish("`)`");
    return widened(n, length);
  }
  Num n;
  n.length = 0;
  while (peek().kind != Token::Kind::end) {
    if (n.length == 5) fail(Code::evaluation, e.span, "a vector has at most 5 components");
    n.v[static_cast<std::size_t>(n.length++)] = read_scalar("a component");
    optional_comma();
  }
  if (n.length < 2) fail(Code::evaluation, e.span, "a vector has at least 2 components");
  return n;
}

Num Interpreter::evaluate_call(const ast::Tree& tree, const ast::Expr& e, const ast::Call& call,
                               int length) {
  const auto* name = std::get_if<ast::Name>(&tree.exprs[call.callee].node);
  if (name != nullptr && symbols_.reserved(name->name)) {
    const std::span args(tree.expr_lists.data() + call.args.first, call.args.count);
    return call_builtin(tree, e, name->name, args, nullptr, length);
  }
  if (const MacroRef* macro = macro_of(tree, call.callee)) {
    const auto id = static_cast<ast::ExprId>(&e - tree.exprs.data());
    return macro_value(tree, id, *macro, [&](const ast::Tree& t, ast::ExprId value) {
      return evaluate(t, value, length);
    });
  }
  const Value* v = lookup(tree, call.callee, true);
  call_value(*v, e.span);
}

void Interpreter::call_value(const Value& v, Span span) {
  if (const auto* u = v.get<Shared<Unsupported>>()) not_supported((*u)->feature, span);
  fail(Code::wrong_kind, span,
       fmt::format("expected a macro or function to call, found {}", kind_name(v)));
}

/// Whatever the expression stands for: a number, a string, an object, a texture …
Value Interpreter::evaluate_value(const ast::Tree& tree, ast::ExprId id) {
  const ast::Expr& e = tree.exprs[id];
  if (e.may_expand && needs_expansion(tree, id, true)) {
    Nested part(*this, tree, id);
    Value v = read_value();
    accept_punct(';');
    part.finish("the end of this value");
    return v;
  }
  if (const auto* name = std::get_if<ast::Name>(&e.node); name != nullptr) {
    if (!symbols_.reserved(name->name)) {
      const Value* v = lookup(tree, id, true);
      if (!v->defined())
        fail(Code::evaluation, e.span, fmt::format("`{}` has no value", name_of(name->name)));
      return copy_of(*v);
    }
  } else if (array_of(e)) {
    return copy_of(*lookup(tree, id, true));
  }
  if (e.may_expand) {
    if (const MacroRef* macro = value_macro(tree, id, true)) {
      return macro_value(tree, id, *macro, [&](const ast::Tree& t, ast::ExprId value) {
        return evaluate_value(t, value);
      });
    }
  }
  if (is_text(tree, id)) return Value(std::make_shared<const Text>(evaluate_text(tree, id)));
  return Value(evaluate_closed(tree, id, 1));
}

/// Assignment copies; arrays are shared until one of the copies is written.
Value Interpreter::copy_of(const Value& v) { return v; }

// ---- strings
// --------------------------------------------------------------------------------------

bool Interpreter::is_text(const ast::Tree& tree, ast::ExprId id) {
  const ast::Expr& e = tree.exprs[id];
  if (std::holds_alternative<ast::Binary>(e.node) || std::holds_alternative<ast::Number>(e.node) ||
      std::holds_alternative<ast::Vector>(e.node)) {
    return false;
  }
  if (std::holds_alternative<ast::String>(e.node)) return true;
  if (const auto* p = std::get_if<ast::Paren>(&e.node)) return is_text(tree, p->inner);
  if (std::holds_alternative<ast::Name>(e.node) || array_of(e)) {
    const Value* v = lookup(tree, id, false);
    return v != nullptr && v->get<Shared<Text>>() != nullptr;
  }
  ast::ExprId callee = ast::none;
  if (const auto* c = std::get_if<ast::Call>(&e.node)) callee = c->callee;
  if (const auto* g = std::get_if<ast::OpenGroup>(&e.node)) {
    if (g->kind == ast::OpenGroup::Kind::call) callee = g->callee;
  }
  if (callee == ast::none) return false;
  const auto* name = std::get_if<ast::Name>(&tree.exprs[callee].node);
  if (name == nullptr) return false;
  switch (name->name) {
    case w::chr:
    case w::concat:
    case w::datetime:
    case w::str:
    case w::strlwr:
    case w::strupr:
    case w::substr:
    case w::vstr: return true;
    default: return false;
  }
}

Text Interpreter::evaluate_text(const ast::Tree& tree, ast::ExprId id, bool file_name) {
  const ast::Expr& e = tree.exprs[id];
  if (e.may_expand && needs_expansion(tree, id, true)) {
    Nested part(*this, tree, id);
    Text t = read_text(file_name);
    part.finish("the end of this string");
    return t;
  }
  if (const auto* s = std::get_if<ast::String>(&e.node)) {
    return decode_literal(tree.strings[s->index], e.span, file_name);
  }
  if (const auto* p = std::get_if<ast::Paren>(&e.node))
    return evaluate_text(tree, p->inner, file_name);
  if (e.may_expand) {
    if (const MacroRef* macro = value_macro(tree, id, true)) {
      return macro_value(tree, id, *macro, [&](const ast::Tree& t, ast::ExprId value) {
        return evaluate_text(t, value, file_name);
      });
    }
  }
  if (!is_text(tree, id)) {
    if (const Value* v = lookup(tree, id, true); v != nullptr) {
      fail(Code::wrong_kind, e.span, fmt::format("expected a string, found {}", kind_name(*v)),
           v->get<Num>() != nullptr ? "turn numbers into strings with `str(X, 0, 3)`" : "");
    }
    fail(Code::wrong_kind, e.span, "expected a string",
         "turn numbers into strings with `str(X, 0, 3)`");
  }
  if (const Value* v = lookup(tree, id, true)) return **v->get<Shared<Text>>();
  if (const auto* c = std::get_if<ast::Call>(&e.node)) {
    const std::span args(tree.expr_lists.data() + c->args.first, c->args.count);
    return call_text_builtin(tree, e, std::get<ast::Name>(tree.exprs[c->callee].node).name, args,
                             nullptr);
  }
  const auto& g = std::get<ast::OpenGroup>(e.node);
  return call_text_builtin(tree, e, std::get<ast::Name>(tree.exprs[g.callee].node).name, {}, &g);
}

/// The second stage of string literals (language §1.4).
Text Interpreter::decode_literal(std::string_view bytes, Span span, bool file_name) {
  Text out;
  const auto hex = [](char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
  };
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const auto c = static_cast<unsigned char>(bytes[i]);
    if (c > 127) {
      if (!utf8_) {
        out += version() < 350 ? static_cast<char16_t>(c) : u' ';
        continue;
      }
      const int extra = c >= 0xF0 ? 3 : c >= 0xE0 ? 2 : 1;
      std::uint32_t code = c & (0x3FU >> extra);
      for (int k = 0; k < extra && i + 1 < bytes.size(); ++k) {
        code = code << 6 | (static_cast<unsigned char>(bytes[++i]) & 0x3FU);
      }
      out += code > 0xFFFF ? u'\uFFFD' : static_cast<char16_t>(code);
      continue;
    }
    if (c != '\\' || file_name || i + 1 >= bytes.size()) {
      out += static_cast<char16_t>(c);
      continue;
    }
    const char e = bytes[++i];
    switch (e) {
      case 'a': out += u'\a'; break;
      case 'b': out += u'\b'; break;
      case 'f': out += u'\f'; break;
      case 'n': out += u'\n'; break;
      case 'r': out += u'\r'; break;
      case 't': out += u'\t'; break;
      case 'v': out += u'\v'; break;
      case '\'': out += u'\''; break;
      case '"': out += u'"'; break;
      case '\\': out += u'\\'; break;
      case 'u': {
        int code = 0;
        for (int k = 0; k < 4; ++k) {
          const int digit = i + 1 < bytes.size() ? hex(bytes[i + 1]) : -1;
          if (digit < 0) fail(Code::syntax, span, "`\\u` needs four hexadecimal digits");
          code = code * 16 + digit;
          ++i;
        }
        out += static_cast<char16_t>(code);
        break;
      }
      default:
        fail(Code::syntax, span, fmt::format("unknown escape `\\{}` in a string", e),
             "write `\\\\` for a backslash");
    }
  }
  return out;
}

}  // namespace durer::interpreter
