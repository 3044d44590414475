// Closed expressions: parts of a syntax tree without macro calls at their operator level. What
// stands inside delimiters and does hold macro calls or directives is read by a nested reader.
#include <algorithm>
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
//
// Numbers are worked out in place: `double* v` has room for five components, and a function returns
// how many of them count. The slots beyond keep what they held, which the language can see (§2.4).

namespace {

double truth(bool b) { return b ? 1.0 : 0.0; }

double apply(ast::Op op, double a, double b) {
  switch (op) {
    case ast::Op::add: return a + b;
    case ast::Op::sub: return a - b;
    case ast::Op::mul: return a * b;
    case ast::Op::div: return b == 0 ? std::numeric_limits<double>::infinity() : a / b;
    case ast::Op::lt: return truth(a < b);
    case ast::Op::le: return truth(a < b || nearly_equal(a, b));
    case ast::Op::eq: return truth(nearly_equal(a, b));
    case ast::Op::ne: return truth(!nearly_equal(a, b));
    case ast::Op::ge: return truth(a > b || nearly_equal(a, b));
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

/// A float where `want` components are wanted fills them all.
int fill(double x, int want, double* v) {
  for (int i = 0; i < want; ++i) v[i] = x;
  return want;
}

/// Makes an operand longer: a float is replicated, a shorter vector padded with zeros.
void stretch(double* v, int from, int to) {
  for (int i = from; i < to; ++i) v[i] = from == 1 ? v[0] : 0.0;
}

/// What parentheses leave: their content is read without knowing the length wanted, then a float
/// fills it and a shorter vector is padded with zeros.
int widen(double* v, int n, int want) {
  if (n >= want) return n;
  stretch(v, n, want);
  return want;
}

}  // namespace

int Interpreter::apply_binary(ast::Op op, double* v, int n, double* r, int m, Span span) {
  if (n == 1 && m == 1) {  // floats, by far the commonest
    if (op == ast::Op::div && r[0] == 0) warn_division(span);
    v[0] = apply(op, v[0], r[0]);
    return 1;
  }
  if (n < m) stretch(v, n, m);
  if (m < n) stretch(r, m, n);
  const int both = std::max(n, m);
  for (int i = 0; i < both; ++i) {
    if (op == ast::Op::div && r[i] == 0) warn_division(span);
    v[i] = apply(op, v[i], r[i]);
  }
  return both;
}

void Interpreter::warn_division(Span span) {
  warn(Code::evaluation, span, "division by zero; the result is infinite");
}

Num Interpreter::binary(ast::Op op, Num left, Num right, Span span) {
  left.length = apply_binary(op, left.v.data(), left.length, right.v.data(), right.length, span);
  return left;
}

namespace {
void apply_unary(ast::Op op, double* v, int n) {
  for (int i = 0; i < n; ++i) {
    if (op == ast::Op::neg) v[i] = -v[i];
    if (op == ast::Op::not_) v[i] = truth(!(std::abs(v[i]) > epsilon));
  }
}
}  // namespace

Num Interpreter::unary(ast::Op op, Num operand) {
  apply_unary(op, operand.v.data(), operand.length);
  return operand;
}

/// `.x`: slot 0 gets the component, the others keep what they held (language §2.4).
int Interpreter::take_member(double* v, int n, SymbolId name, Span span, int want) {
  if (name == w::gray) {
    stretch(v, n, 3);
    v[0] = 0.297 * v[0] + 0.589 * v[1] + 0.114 * v[2];
    return 1;
  }
  const int slot = component_slot(name);
  if (slot < 0) {
    fail(Code::unknown_name, span, fmt::format("`{}` is no component", name_of(name)),
         "components are x y z t, u v, red green blue filter transmit, gray");
  }
  if (slot >= n) {
    fail(Code::wrong_kind, span,
         fmt::format("there is no component `{}` in a value of {} component{}", name_of(name), n,
                     n == 1 ? "" : "s"));
  }
  if (n == 1) return fill(v[0], want, v);
  v[0] = v[slot];
  return 1;
}

Num Interpreter::member(Num object, SymbolId name, Span span, int length) {
  object.length = take_member(object.v.data(), object.length, name, span, length);
  return object;
}

// ---- names --------------------------------------------------------------------------------------

void Interpreter::unknown_name(SymbolId name, Span span) {
  std::vector<std::string_view> names;
  for (const SymbolId id : env_.visible_names()) names.push_back(name_of(id));
  for (SymbolId id = 0; id < w::count_; ++id) names.push_back(name_of(id));
  const auto near = closest(name_of(name), names);
  Diagnostic d;
  d.code = Code::unknown_name;
  d.span = span;
  d.message = fmt::format("`{}` is not declared", name_of(name));
  if (near) d.help.push_back(fmt::format("did you mean `{}`?", *near));
  report(std::move(d));
  poison(name, 0, false);  // told once
  stop_here(false);
}

int Interpreter::take_value(const Value& value, Span span, int want, double* v) {
  if (const Num* n = value.get<Num>()) {
    if (n->length == 1) return fill(n->v[0], want, v);
    for (int i = 0; i < n->length; ++i) v[i] = n->v[static_cast<std::size_t>(i)];
    return n->length;
  }
  if (const auto* u = value.get<Shared<Unsupported>>()) not_supported((*u)->feature, span);
  fail(Code::wrong_kind, span,
       fmt::format("expected a number or vector, found {}", kind_name(value)));
}

int Interpreter::take_name(SymbolId name, Span span, int want, double* v) {
  if (!symbols_.reserved(name)) {
    Slot* slot = env_.find(name);
    const Value* value = Environment::value_of(slot);
    if (value == nullptr) unknown_name(name, span);
    if (slot->deprecated) note_use(slot, span);
    return take_value(*value, span, want, v);
  }
  const auto vector = [v](double a, double b, double c) {
    v[0] = a;
    v[1] = b;
    v[2] = c;
    return 3;
  };
  switch (name) {
    case w::x: return vector(1, 0, 0);
    case w::y: return vector(0, 1, 0);
    case w::z: return vector(0, 0, 1);
    case w::u:
    case w::v: {
      v[0] = name == w::u ? 1.0 : 0.0;
      v[1] = name == w::v ? 1.0 : 0.0;
      return 2;
    }
    case w::t: {
      v[3] = 1;
      vector(0, 0, 0);
      return 4;
    }
    case w::pi: return fill(3.14159265358979323846, want, v);
    case w::true_:
    case w::yes:
    case w::on: return fill(1, want, v);
    case w::false_:
    case w::no:
    case w::off: return fill(0, want, v);
    case w::clock: return fill(static_cast<float>(options_.clock), want, v);
    case w::clock_on: return fill(options_.clock_on ? 1 : 0, want, v);
    case w::version: return fill(declared_version_ / 100.0, want, v);
    case w::now: return fill(days_since_2000(), want, v);
    default:
      fail(Code::unexpected_item, span,
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
  if (additions_) return entry(tree, id, must_exist);
  if (const auto array = array_of(e)) {
    Peek peek(*this);
    Value* v = element(*array, read_subscripts(tree, id), e.span, false, must_exist);
    // Whoever only looks whether a number stands here works it out once more.
    if (must_exist || !v->is_num()) peek.keep();
    return v;
  }
  return nullptr;
}

// ---- expressions
// ----------------------------------------------------------------------------------

Num Interpreter::evaluate(const ast::Tree& tree, ast::ExprId id, int length) {
  Num n;
  n.length = work_out(tree, id, length, n.v.data());
  return n;
}

Num Interpreter::evaluate_full(const ast::Tree& tree, ast::ExprId id, int length) {
  Num n;
  n.length = work_out_full(tree, id, length, n.v.data());
  return n;
}

/// A whole expression: macro calls in it may have to be spelled out first.
int Interpreter::work_out(const ast::Tree& tree, ast::ExprId id, int want, double* v) {
  const ast::Expr& e = tree.exprs[id];
  if (const Operand* quickly = quick(tree, id, want); quickly != nullptr && !quickly->is_text()) {
    std::copy(quickly->v.begin(), quickly->v.end(), v);
    return quickly->length;
  }
  if (e.may_expand && needs_expansion(tree, id, true)) {
    Nested part(*this, tree, id);
    const Num n = read_full_in_place(want);
    part.finish("an operator or the end of this expression");
    std::copy(n.v.begin(), n.v.end(), v);
    return n.length;
  }
  return work_out_closed(tree, e, want, v);
}

/// Compiles the formula of an expression that has been met for the first time.
Formula& Interpreter::new_formula(const ast::Tree& tree, ast::ExprId id) {
  std::vector<Formula*>& formulas = formulas_of_[tree.file];
  if (formulas.empty()) formulas.resize(tree.exprs.size());
  const FormulaContext context{env_, static_cast<float>(options_.clock), !options_.on_trace};
  Formula code = compile_formula(context, tree, id);
  formulas[id] = code.ops.empty() ? &no_formula_ : &formulas_.emplace_back(std::move(code));
  return *formulas[id];
}

/// The formula of an expression, null if it has none.
Formula* Interpreter::formula_of(const ast::Tree& tree, ast::ExprId id) {
  const std::vector<Formula*>& formulas = formulas_of_[tree.file];
  Formula* const known = formulas.empty() ? nullptr : formulas[id];
  Formula& formula = known != nullptr ? *known : new_formula(tree, id);
  return formula.ops.empty() ? nullptr : &formula;
}

const Operand* Interpreter::quick(const ast::Tree& tree, ast::ExprId id, int want) {
  // What runs once is not worth compiling, and a single operand is as quick to look up.
  if (repeats_ == 0 || tree.exprs[id].height < 2 || !takes_shortcuts()) return nullptr;
  Formula* const formula = formula_of(tree, id);
  return formula == nullptr ? nullptr : run_formula(*formula, want);
}

/// A formula has given up: after a few times it is not tried any more.
const Operand* Interpreter::note_failure(Formula& formula) {
  constexpr std::uint8_t enough = 8;
  if (++formula.failures == enough) formula.ops.clear();
  return nullptr;
}

int Interpreter::work_out_full(const ast::Tree& tree, ast::ExprId id, int want, double* v) {
  const int n = work_out(tree, id, want, v);
  return n == 1 ? fill(v[0], want, v) : n;
}

double Interpreter::work_out_float(const ast::Tree& tree, ast::ExprId id, std::string_view what) {
  double v[5] = {};
  const int n = work_out(tree, id, 1, v);
  if (n != 1) {
    fail(Code::wrong_kind, tree.exprs[id].span,
         fmt::format("expected a float as {}, found a value of {} components", what, n),
         "pick a component, as in `V.x`");
  }
  return v[0];
}

/// No call at the operator level needs to be spelled out: see needs_expansion. A switch over the
/// alternatives: this is the interpreter's inner loop.
int Interpreter::work_out_closed(const ast::Tree& tree, const ast::Expr& e, int want, double* v) {
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
    open,
    element_
  };
  switch (e.node.index()) {
    case number: return fill(std::get_if<ast::Number>(&e.node)->value, want, v);
    case string: fail(Code::wrong_kind, e.span, "expected a number or vector, found a string");
    case name: return take_name(std::get_if<ast::Name>(&e.node)->name, e.span, want, v);
    case paren:
      return widen(v, work_out_full(tree, std::get_if<ast::Paren>(&e.node)->inner, 1, v), want);
    case vector: return work_out_vector(tree, *std::get_if<ast::Vector>(&e.node), e.span, v);
    case unary_: {
      const auto& u = *std::get_if<ast::Unary>(&e.node);
      const int n = work_out_closed(tree, tree.exprs[u.operand], want, v);
      apply_unary(u.op, v, n);
      return n;
    }
    case binary_: {
      const auto& b = *std::get_if<ast::Binary>(&e.node);
      if (b.op >= ast::Op::lt && b.op <= ast::Op::gt) return work_out_relation(tree, e, want, v);
      const int n = work_out_closed(tree, tree.exprs[b.left], want, v);
      double r[5];
      const int m = work_out_operand(tree, tree.exprs[b.right], n, r);
      return apply_binary(b.op, v, n, r, m, e.span);
    }
    case conditional: return work_out_conditional(tree, e, want, v);
    case call: return work_out_call(tree, e, *std::get_if<ast::Call>(&e.node), want, v);
    case index: {
      const auto& i = *std::get_if<ast::Index>(&e.node);
      if (additions_) {
        const auto id = static_cast<ast::ExprId>(&e - tree.exprs.data());
        return take_value(*entry(tree, id, true), e.span, want, v);
      }
      return take_value(*element(i.name, read_subscripts(tree, i.subscripts), e.span, false),
                        e.span, want, v);
    }
    case member_: {
      const auto& m = *std::get_if<ast::Member>(&e.node);
      if (additions_) {
        const auto id = static_cast<ast::ExprId>(&e - tree.exprs.data());
        if (const Value* value = entry(tree, id, true)) return take_value(*value, e.span, want, v);
      }
      const int n = work_out_closed(tree, tree.exprs[m.object], 1, v);
      return take_member(v, n, m.member, e.span, want);
    }
    case open: {
      const Num n = evaluate_open(tree, e, *std::get_if<ast::OpenGroup>(&e.node), want);
      std::copy(n.v.begin(), n.v.end(), v);
      return n.length;
    }
    case element_: {
      const auto id = static_cast<ast::ExprId>(&e - tree.exprs.data());
      return take_value(*entry(tree, id, true), e.span, want, v);
    }
    default: break;
  }
  fail(Code::syntax, e.span, "an expression that cannot be evaluated");
}

/// The right side of an operator: what lies beyond its length is of no interest.
int Interpreter::work_out_operand(const ast::Tree& tree, const ast::Expr& e, int want, double* v) {
  if (const auto* n = std::get_if<ast::Number>(&e.node)) return fill(n->value, want, v);
  v[1] = v[2] = v[3] = v[4] = 0;
  return work_out_closed(tree, e, want, v);
}

int Interpreter::work_out_relation(const ast::Tree& tree, const ast::Expr& e, int want, double* v) {
  const auto& b = *std::get_if<ast::Binary>(&e.node);
  if (is_text(tree, b.left)) {
    return fill(compare(b.op, evaluate_text(tree, b.left), evaluate_text(tree, b.right)), want, v);
  }
  int n = 0;
  if (tree.exprs[b.left].may_expand && is_macro_call(tree, b.left)) {
    // Only its value tells whether numbers or strings are compared.
    const Value value = evaluate_value(tree, b.left);
    if (const auto* text = value.get<Shared<Text>>()) {
      return fill(compare(b.op, **text, evaluate_text(tree, b.right)), want, v);
    }
    n = take_value(value, tree.exprs[b.left].span, want, v);
  } else {
    n = work_out_closed(tree, tree.exprs[b.left], want, v);
  }
  double r[5];
  const int m = work_out_operand(tree, tree.exprs[b.right], n, r);
  return apply_binary(b.op, v, n, r, m, e.span);
}

int Interpreter::work_out_conditional(const ast::Tree& tree, const ast::Expr& e, int want,
                                      double* v) {
  const auto& c = *std::get_if<ast::Conditional>(&e.node);
  // Both branches are always evaluated: random streams advance (language §2.2).
  double condition[5] = {};
  if (work_out_full(tree, c.condition, 1, condition) != 1)
    fail(Code::wrong_kind, e.span, "the condition of `?:` must be a float");
  const Num yes = evaluate_full(tree, c.yes, want);
  const Num no = evaluate_full(tree, c.no, want);
  const Num& chosen = std::abs(condition[0]) > epsilon ? yes : no;
  std::copy(chosen.v.begin(), chosen.v.end(), v);
  return chosen.length;
}

int Interpreter::work_out_vector(const ast::Tree& tree, const ast::Vector& list, Span span,
                                 double* v) {
  const std::uint32_t count = list.components.count;
  const ast::ExprId* ids = tree.expr_lists.data() + list.components.first;
  for (std::uint32_t i = 0; i < count; ++i) {
    const bool apart =
        version() < 150 || (tree.exprs[ids[i]].may_expand && needs_expansion(tree, ids[i], true));
    if (!apart) continue;
    const Num n = read_components(tree, list.components, span);
    std::copy(n.v.begin(), n.v.end(), v);
    return n.length;
  }
  if (count > 5 || count < 2) {
    fail(Code::evaluation, span, fmt::format("a vector has 2 to 5 components, here are {}", count));
  }
  double out[5];
  for (std::uint32_t i = 0; i < count; ++i) {
    double c[5] = {};
    const int n = work_out(tree, ids[i], 1, c);
    if (n != 1) {
      fail(Code::wrong_kind, tree.exprs[ids[i]].span,
           fmt::format("expected a float as component, found a value of {} components", n));
    }
    out[i] = c[0];
  }
  std::copy(out, out + count, v);
  return static_cast<int>(count);
}

/// Components of a vector some of which are macro calls, whose bodies may hold `1, 2`; and those of
/// the first versions, where `<1 -1 2>` has three.
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
    return call_value(callee(tree, g.callee), tree, e, length);
  }
  if (g.kind == Kind::index) {
    const ast::ExprId id = static_cast<ast::ExprId>(&e - tree.exprs.data());
    Num n;
    n.length = take_value(*lookup(tree, id, true), e.span, length, n.v.data());
    return n;
  }
  Nested part(*this, tree, g.items, e.span);
  if (g.kind == Kind::paren) {
    Num n = read_full(1);
    part.finish("`)`");
    n.length = widen(n.v.data(), n.length, length);
    return n;
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

int Interpreter::work_out_call(const ast::Tree& tree, const ast::Expr& e, const ast::Call& call,
                               int want, double* v) {
  const auto* name = std::get_if<ast::Name>(&tree.exprs[call.callee].node);
  if (name != nullptr && symbols_.reserved(name->name)) {
    const std::span args(tree.expr_lists.data() + call.args.first, call.args.count);
    const Num n = call_builtin(tree, e, name->name, args, nullptr, want);
    std::copy(n.v.begin(), n.v.end(), v);
    return n.length;
  }
  if (const MacroRef* macro = macro_of(tree, call.callee)) {
    const auto id = static_cast<ast::ExprId>(&e - tree.exprs.data());
    return macro_value(tree, id, *macro, [&](const ast::Tree& t, ast::ExprId value) {
      return work_out(t, value, want, v);
    });
  }
  const Num n = call_value(callee(tree, call.callee), tree, e, want);
  std::copy(n.v.begin(), n.v.end(), v);
  return n.length;
}

/// What is to be called: a variable, an element, an entry.
const Value& Interpreter::callee(const ast::Tree& tree, ast::ExprId id) {
  const Value* v = lookup(tree, id, true);
  if (v == nullptr) {
    fail(Code::wrong_kind, tree.exprs[id].span, "expected a macro or function to call");
  }
  return *v;
}

/// Calls a function or spline; macros have been expanded before.
Num Interpreter::call_value(const Value& v, const ast::Tree& tree, const ast::Expr& call,
                            int length) {
  if (const auto* f = v.get<Shared<UserFunction>>()) {
    return call_function(**f, tree, call, length);
  }
  if (const auto* s = v.get<Shared<functions::Spline>>()) {
    const Shared<functions::Spline> keep = *s;  // a directive in the argument might replace it
    return call_spline(*keep, tree, call);
  }
  if (const auto* u = v.get<Shared<Unsupported>>()) not_supported((*u)->feature, call.span);
  fail(Code::wrong_kind, call.span,
       fmt::format("expected a macro or function to call, found {}", kind_name(v)));
}

}  // namespace durer::interpreter
