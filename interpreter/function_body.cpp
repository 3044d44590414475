// Bodies of functions: expressions with a grammar of their own (language §6.2), compiled to a tape.
//
// What the syntax tree holds as one closed expression is compiled from the tree. Where macros or
// directives may take part, the stream spells the expression out operand by operand, and the
// operators are bound here.
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/suggest.h"
#include "functions/builder.h"
#include "functions/names.h"
#include "interpreter/function_body.h"

namespace durer::interpreter {

namespace w = grammar::words;
using functions::Op;

namespace {

/// The operators by their marks, and how tightly they bind: `&` tighter than `|` here.
struct Operator {
  char mark;
  Op op;
  int level;
};
constexpr std::array operators{
    Operator{'|', Op::either, 1},   Operator{'&', Op::both, 2},
    Operator{'=', Op::equal, 3},    Operator{'n', Op::not_equal, 3},
    Operator{'<', Op::less, 3},     Operator{'l', Op::less_equal, 3},
    Operator{'>', Op::greater, 3},  Operator{'g', Op::greater_equal, 3},
    Operator{'+', Op::add, 4},      Operator{'-', Op::subtract, 4},
    Operator{'*', Op::multiply, 5}, Operator{'/', Op::divide, 5},
};
const Operator* operator_of(char mark) {
  const auto* found = std::ranges::find(operators, mark, &Operator::mark);
  return found == operators.end() ? nullptr : found;
}

Op op_of(ast::Op op) {
  switch (op) {
    case ast::Op::add: return Op::add;
    case ast::Op::sub: return Op::subtract;
    case ast::Op::mul: return Op::multiply;
    case ast::Op::div: return Op::divide;
    case ast::Op::lt: return Op::less;
    case ast::Op::le: return Op::less_equal;
    case ast::Op::eq: return Op::equal;
    case ast::Op::ne: return Op::not_equal;
    case ast::Op::ge: return Op::greater_equal;
    case ast::Op::gt: return Op::greater;
    case ast::Op::and_: return Op::both;
    case ast::Op::or_: return Op::either;
    case ast::Op::neg:
    case ast::Op::pos:
    case ast::Op::not_: break;
  }
  return Op::add;
}

bool is_compound(const ast::Expr& e) {
  return std::holds_alternative<ast::Binary>(e.node) ||
         std::holds_alternative<ast::Unary>(e.node) ||
         std::holds_alternative<ast::Conditional>(e.node);
}

/// True if the expression begins with a sign, which after an operand is an operator.
bool begins_with_sign(const ast::Tree& tree, ast::ExprId id) {
  while (const auto* b = std::get_if<ast::Binary>(&tree.exprs[id].node)) id = b->left;
  const auto* u = std::get_if<ast::Unary>(&tree.exprs[id].node);
  return u != nullptr && u->op != ast::Op::not_;
}

}  // namespace

Interpreter::FunctionReader::FunctionReader(Interpreter& in, std::span<const SymbolId> parameters)
    : in_(in), builder_(static_cast<int>(parameters.size())) {
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const SymbolId name = register_of(parameters[i]);
    // Of equal names the first counts, of equal registers the last.
    if (is_register(name) || find(name) == nullptr) {
      names_.push_back({name, builder_.parameter(static_cast<int>(i))});
    }
  }
}

functions::Function Interpreter::FunctionReader::read() {
  const Operand result = full();
  const Token end = in_.next();
  if (end.kind != Token::Kind::close) not_an_operator(end);
  return builder_.finish(number(result));
}

// ---- from the stream
// -----------------------------------------------------------------------------

/// Any expression, up to what does not continue it.
Interpreter::FunctionReader::Operand Interpreter::FunctionReader::full() {
  const Token t = in_.next();
  if (t.kind == Token::Kind::expr && ends_here()) {
    return {compile(*t.tree, t.expr), t.span};
  }
  in_.unread(t);
  return chain(1);
}

/// True if nothing can continue an expression here; found out without executing anything.
bool Interpreter::FunctionReader::ends_here() const {
  const Token t = in_.raw_next();
  const Frame& f = in_.frames_.back();
  if (t.kind == Token::Kind::end) return f.kind == Frame::Kind::barrier && f.pos >= f.end;
  return t.kind == Token::Kind::close || t.is_punct(',');
}

/// Operands joined by operators that bind at least as tightly as `level`.
Interpreter::FunctionReader::Operand Interpreter::FunctionReader::chain(int level) {
  Operand left = signed_operand();
  for (;;) {
    const Operator* op = operator_of(mark_ahead());
    if (op == nullptr || op->level < level) return left;
    const Span at = in_.next().span;
    const functions::Value a = number(left);
    const functions::Value b = number(chain(op->level + 1));
    left = {{builder_.op(op->op, a, b)}, at};
    check(at);
  }
}

/// The mark that follows, or 0; a sign that begins an expression is a mark here.
char Interpreter::FunctionReader::mark_ahead() {
  Token t = in_.peek();
  if (t.kind == Token::Kind::expr && begins_with_sign(*t.tree, t.expr)) {
    in_.next();
    in_.expand(*t.tree, t.expr, true);
    t = in_.peek();
  }
  return t.kind == Token::Kind::punct ? t.punct : '\0';
}

Interpreter::FunctionReader::Operand Interpreter::FunctionReader::signed_operand() {
  spell_out();
  const Token t = in_.peek();
  if (t.is_punct('!')) no_such_operator(t.span, '!');
  if (!t.is_punct('-') && !t.is_punct('+')) return operand();
  in_.next();
  spell_out();
  if (const Token second = in_.peek(); second.is_punct('-') || second.is_punct('+')) {
    in_.fail(Code::syntax, second.span, "a function takes one sign at most here",
             "put the rest in parentheses");
  }
  const Operand inner = operand();
  if (t.is_punct('+')) return inner;
  const functions::Value v = builder_.op(Op::negate, number(inner));
  check(t.span);
  return {{v}, t.span};
}

/// Replaces an expression of several operands by its parts.
void Interpreter::FunctionReader::spell_out() {
  const Token t = in_.peek();
  if (t.kind != Token::Kind::expr || !is_compound(t.expression())) return;
  in_.next();
  in_.expand(*t.tree, t.expr, true);
}

Interpreter::FunctionReader::Operand Interpreter::FunctionReader::operand() {
  const Token t = in_.next();
  if (t.kind != Token::Kind::expr) not_an_operand(t);
  Operand result{compile(*t.tree, t.expr), t.span};
  if (mark_ahead() != '.') return result;
  in_.next();
  const Token name = in_.next();
  return {{member(result, name.kind == Token::Kind::word ? name.word : symbol_of(name), name.span)},
          name.span};
}

SymbolId Interpreter::FunctionReader::symbol_of(const Token& t) const {
  const auto* name = t.node<ast::Name>();
  return name == nullptr ? w::function : name->name;
}

// ---- from the tree
// -------------------------------------------------------------------------------

/// One value of the expression; macros in it are expanded.
functions::Value Interpreter::FunctionReader::compile_number(const ast::Tree& tree,
                                                             ast::ExprId id) {
  const ast::Expr& e = tree.exprs[id];
  if (!e.may_expand || !in_.needs_expansion(tree, id)) return number({compile(tree, id), e.span});
  Nested part(in_, tree, id);
  const functions::Value v = number(chain(1));
  part.finish("an operator or the end of this expression");
  return v;
}

/// The components of a closed expression.
std::vector<functions::Value> Interpreter::FunctionReader::compile(const ast::Tree& tree,
                                                                   ast::ExprId id) {
  const ast::Expr& e = tree.exprs[id];
  const auto inner = [&](ast::ExprId child) {
    return number({compile(tree, child), tree.exprs[child].span});
  };
  if (const auto* n = std::get_if<ast::Number>(&e.node)) return {builder_.constant(n->value)};
  if (const auto* n = std::get_if<ast::Name>(&e.node)) return {named(e, n->name)};
  if (const auto* p = std::get_if<ast::Paren>(&e.node)) {
    return {functions::FunctionBuilder::group(compile_number(tree, p->inner))};
  }
  if (const auto* b = std::get_if<ast::Binary>(&e.node)) {
    const functions::Value left = inner(b->left);
    const functions::Value right = inner(b->right);
    const functions::Value v = builder_.op(op_of(b->op), left, right);
    check(e.span);
    return {v};
  }
  if (const auto* u = std::get_if<ast::Unary>(&e.node)) {
    if (u->op == ast::Op::not_) no_such_operator(e.span, '!');
    if (std::holds_alternative<ast::Unary>(tree.exprs[u->operand].node)) {
      in_.fail(Code::syntax, e.span, "a function takes one sign at most here",
               "put the rest in parentheses");
    }
    const functions::Value v = inner(u->operand);
    return {u->op == ast::Op::neg ? builder_.op(Op::negate, v) : v};
  }
  if (std::holds_alternative<ast::Index>(e.node)) return {element(tree, id)};
  if (const auto* m = std::get_if<ast::Member>(&e.node)) {
    return {member({compile(tree, m->object), e.span}, m->member, e.span)};
  }
  if (std::holds_alternative<ast::Call>(e.node)) return call(tree, e);
  if (const auto* g = std::get_if<ast::OpenGroup>(&e.node)) return open_group(tree, id, *g);
  if (std::holds_alternative<ast::Conditional>(e.node)) no_such_operator(e.span, '?');
  in_.fail(Code::wrong_kind, e.span,
           fmt::format("functions compute with floats only, found a {}",
                       std::holds_alternative<ast::String>(e.node) ? "string" : "vector"));
}

std::vector<functions::Value> Interpreter::FunctionReader::open_group(const ast::Tree& tree,
                                                                      ast::ExprId id,
                                                                      const ast::OpenGroup& g) {
  const ast::Expr& e = tree.exprs[id];
  switch (g.kind) {
    case ast::OpenGroup::Kind::call: return call(tree, e);
    case ast::OpenGroup::Kind::index: return {element(tree, id)};
    case ast::OpenGroup::Kind::vector: break;
    case ast::OpenGroup::Kind::paren: {
      Nested part(in_, tree, g.items, e.span);
      const functions::Value v = number(full());
      part.finish("an operator or `)`");
      return {functions::FunctionBuilder::group(v)};
    }
  }
  in_.fail(Code::wrong_kind, e.span, "functions compute with floats only, found a vector");
}

// ---- names
// ---------------------------------------------------------------------------------------

const functions::Value* Interpreter::FunctionReader::find(SymbolId name) const {
  for (std::size_t i = names_.size(); i-- > 0;) {
    if (names_[i].name == name) return &names_[i].value;
  }
  return nullptr;
}

functions::Value Interpreter::FunctionReader::named(const ast::Expr& e, SymbolId name) {
  const SymbolId r = register_of(name);
  if (const functions::Value* v = find(r)) return *v;
  if (is_register(r)) return builder_.constant(0);  // a register that no argument fills
  if (name == w::pi) return builder_.constant(std::numbers::pi);
  if (name == w::clock) return builder_.constant(static_cast<float>(in_.options_.clock));
  if (in_.symbols_.reserved(name)) {
    in_.fail(Code::unexpected_item, e.span,
             fmt::format("`{}` has no meaning in a function", in_.name_of(name)),
             name == w::t ? "a function's own parameters are x y z, or what stands in `function "
                            "(…)`"
                          : "declare a float with its value, and use that");
  }
  Slot* slot = in_.env_.find(name);
  const Value* v = Environment::value_of(slot);
  if (v == nullptr || !v->defined()) unknown(e.span, name);
  in_.note_use(slot, e.span);
  return captured(*v, e.span, in_.name_of(name));
}

/// A float variable as a constant: functions keep the values of their birth.
functions::Value Interpreter::FunctionReader::captured(const Value& v, Span span,
                                                       std::string_view name) {
  if (const Num* n = v.get<Num>(); n != nullptr && n->length == 1) {
    return builder_.constant(n->v[0]);
  }
  if (const auto* u = v.get<Shared<Unsupported>>()) in_.not_supported((*u)->feature, span);
  std::string help;
  if (v.get<Num>() != nullptr) {
    help = fmt::format("declare a float before the function: `#declare X = {}.x;`", name);
  } else if (v.get<Shared<UserFunction>>() != nullptr) {
    help = fmt::format("to call it, write its arguments: `{}(x, y, z)`", name);
  }
  in_.fail(Code::wrong_kind, span,
           fmt::format("functions compute with floats only, `{}` is {}", name, kind_name(v)), help);
}

functions::Value Interpreter::FunctionReader::element(const ast::Tree& tree, ast::ExprId id) {
  const ast::Expr& e = tree.exprs[id];
  return captured(*in_.lookup(tree, id, true), e.span, in_.name_of(*array_of(e)));
}

void Interpreter::FunctionReader::unknown(Span span, SymbolId name) {
  std::vector<std::string_view> names;
  for (const auto& known : names_) names.push_back(in_.name_of(known.name));
  for (const SymbolId id : in_.env_.visible_names()) names.push_back(in_.name_of(id));
  for (const functions::BuiltIn& f : functions::built_ins()) names.push_back(f.name);
  const auto near = closest(in_.name_of(name), names);
  in_.fail(Code::unknown_name, span, fmt::format("`{}` is not declared", in_.name_of(name)),
           near ? fmt::format("did you mean `{}`?", *near)
                : "a function sees its parameters, and floats and functions declared before it");
}

// ---- members and messages
// ------------------------------------------------------------------------

functions::Value Interpreter::FunctionReader::number(const Operand& o) {
  if (o.components.size() == 1) return o.components[0];
  in_.fail(
      Code::missing_argument, o.span,
      fmt::format("this call has {} components; a function needs one of them", o.components.size()),
      "write one behind it: .x .y .z, .red .green .blue .filter .transmit, .gray or .hf");
}

functions::Value Interpreter::FunctionReader::member(const Operand& o, SymbolId name, Span span) {
  if (o.components.size() == 1) {
    in_.fail(Code::wrong_kind, span, "there are no components here: this is a float");
  }
  const auto m = functions::member_named(in_.name_of(name));
  if (!m) {
    in_.fail(Code::unknown_name, span, fmt::format("`{}` is no component", in_.name_of(name)),
             "components are x y z t, u v, red green blue filter transmit, gray and hf");
  }
  const functions::Value v = builder_.member(o.components, *m);
  check(span);
  return v;
}

void Interpreter::FunctionReader::check(Span span) {
  using functions::BuildProblem;
  const auto problem = builder_.take_problem();
  if (!problem) return;
  switch (*problem) {
    case BuildProblem::division_by_zero:
      in_.fail(Code::evaluation, span, "this divides by the constant 0",
               "where infinity is meant, put the 0 in parentheses");
    case BuildProblem::constant_zeroth_power:
      in_.warn(Code::evaluation, span, "the power 0 of anything is 1");
      return;
    case BuildProblem::too_deep:
      in_.fail(Code::limit, span, "functions call each other too deeply here");
    case BuildProblem::too_large: in_.fail(Code::limit, span, "this function is too large");
    case BuildProblem::wrong_argument_count:
    case BuildProblem::no_such_internal: break;
  }
  in_.fail(Code::missing_argument, span, "this call does not fit its function");
}

void Interpreter::FunctionReader::no_such_operator(Span span, char mark) {
  in_.fail(Code::unexpected_item, span,
           fmt::format("functions have no `{}`", mark == '?' ? "?:" : "!"),
           mark == '?' ? "write `select(C, if_negative, if_zero, if_positive)`"
                       : "compare with zero: `(A = 0)`");
}

void Interpreter::FunctionReader::not_an_operator(const Token& t) {
  if (t.is_punct('?')) no_such_operator(t.span, '?');
  if (t.is_punct('.')) {
    in_.fail(Code::wrong_kind, t.span, "only calls of vector-valued functions have components");
  }
  if (t.is_punct(';')) {
    in_.fail(Code::unexpected_item, t.span, "the body of a function is one expression, without `;`",
             "remove the `;`");
  }
  in_.unexpected(t, "an operator or `}` in this function");
}

void Interpreter::FunctionReader::not_an_operand(const Token& t) {
  if (t.is_punct('?')) no_such_operator(t.span, '?');
  if (t.is_punct('<')) {
    in_.fail(Code::wrong_kind, t.span, "functions compute with floats only, here begins a vector");
  }
  if (t.is(w::internal)) {
    in_.fail(Code::unexpected_item, t.span, "`internal` must be the whole body of a function",
             "declare a function for it, and call that");
  }
  if (t.kind == Token::Kind::word) {
    in_.fail(Code::unexpected_item, t.span,
             fmt::format("`{}` has no meaning in a function", in_.name_of(t.word)));
  }
  in_.unexpected(t, "a number, parameter or call in this function");
}

functions::Function Interpreter::compile_function(std::span<const SymbolId> parameters) {
  return FunctionReader(*this, parameters).read();
}

}  // namespace durer::interpreter
