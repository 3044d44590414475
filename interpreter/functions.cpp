// Functions of the user: their declaration and their calls in scene expressions (language §6).
#include <cmath>

#include <fmt/format.h>

#include "functions/builder.h"
#include "functions/internals.h"
#include "interpreter/interpreter.h"
#include "interpreter/user_function.h"

namespace durer::interpreter {

namespace w = grammar::words;

namespace {
Value value_of(functions::Function tape, bool is_vector, Span declared) {
  return {std::make_shared<const UserFunction>(UserFunction{
      std::make_shared<const functions::Function>(std::move(tape)), is_vector, declared})};
}

/// The feature that keeps a pigment from being evaluated, or null.
const std::string* unsupported_in(const scene::Pigment& pigment) {
  if (!pigment.unsupported.empty()) return &pigment.unsupported;
  for (const scene::Pigment& child : pigment.children) {
    if (const std::string* feature = unsupported_in(child)) return feature;
  }
  return nullptr;
}
}  // namespace

std::string argument_count(std::size_t n) {
  return fmt::format("{} argument{}", n, n == 1 ? "" : "s");
}

/// Functions, macros and open files must be undefined before their names get another meaning, even
/// in an inner scope (language §4.3). Only the `#local`s of our own library may hide them: its macros
/// cannot know what names a scene has given to functions.
void Interpreter::check_may_change(Slot* slot, Span span, bool local) {
  const Value* v = Environment::value_of(slot);
  if (v == nullptr || v->is_num()) return;
  if (local && slot->scope != env_.scope() && in_library(span)) return;
  if (v->get<Shared<UserFunction>>() != nullptr) function_stays(slot->name, span);
  if (v->get<MacroRef>() == nullptr && v->get<std::shared_ptr<DataFile>>() == nullptr) return;
  fail(Code::wrong_kind, span,
       fmt::format("`{}` is {} and cannot become a variable", name_of(slot->name), kind_name(*v)),
       fmt::format("`#undef {}` first, or choose another name", name_of(slot->name)));
}

bool Interpreter::in_library(Span span) const {
  if (options_.stdlib_path.empty() || span.begin == 0) return false;
  return sources_.path(sources_.file_of(span.begin)).starts_with(options_.stdlib_path);
}

void Interpreter::function_stays(SymbolId name, Span span) {
  fail(Code::wrong_kind, span,
       fmt::format("`{}` is a function and cannot be redeclared", name_of(name)),
       fmt::format("`#undef {}` first, or choose another name", name_of(name)));
}

/// After the word `function`: `(a, b) { … }` or `{ … }`.
Value Interpreter::read_function(Span span) {
  const bool has_parameters = peek().kind == Token::Kind::expr;
  const Span at = peek().span;
  std::vector<SymbolId> parameters{w::x, w::y, w::z};
  if (has_parameters) parameters = read_parameters();
  expect_open("function");
  const Token body = peek();
  if (body.kind == Token::Kind::word) {
    if (body.word == w::internal) return read_internal_function(span);
    const bool special = body.word == w::pattern || body.word == w::pigment ||
                         body.word == w::transform || body.word == w::spline;
    if (special && has_parameters) {
      fail(Code::unexpected_item, at,
           fmt::format("a function of a {} has no parameters to choose", name_of(body.word)),
           body.word == w::spline ? "its one parameter is the key"
                                  : "its parameters are x, y and z");
    }
    if (special) return read_special_function(span);
  }
  return value_of(compile_function(parameters), false, span);
}

/// A function that is part of the scene: `{ … }`.
functions::FunctionRef Interpreter::read_scene_function(std::span<const SymbolId> parameters) {
  expect_open("function");
  return std::make_shared<const functions::Function>(compile_function(parameters));
}

/// `(a, b)`: names, commas between them optional.
std::vector<SymbolId> Interpreter::read_parameters() {
  const Token list = next();
  std::vector<SymbolId> names;
  const auto add = [&](const Token& t) {
    const auto* name = t.node<ast::Name>();
    const bool is_register =
        name != nullptr && (name->name == w::x || name->name == w::y || name->name == w::z ||
                            name->name == w::u || name->name == w::v);
    if (name == nullptr || (symbols_.reserved(name->name) && !is_register)) {
      fail(Code::unexpected_item, t.span,
           fmt::format("expected the name of a parameter, found {}", describe(t)),
           "any name that is no word of the language will do, and x y z u v");
    }
    if (!is_register && env_.find(name->name) != nullptr) {
      warn(Code::deprecated, t.span,
           fmt::format("the parameter `{0}` hides the declared `{0}`; POV-Ray 3.7 takes that for "
                       "an error",
                       name_of(name->name)));
    }
    if (names.size() == UserFunction::max_parameters) {
      fail(Code::limit, t.span,
           fmt::format("a function has at most {} parameters", UserFunction::max_parameters));
    }
    names.push_back(name->name);
  };
  if (const auto* one = list.node<ast::Paren>()) {
    Token t = list;
    t.expr = one->inner;
    t.span = list.tree->exprs[one->inner].span;
    add(t);
    return names;
  }
  const auto* group = list.node<ast::OpenGroup>();
  if (group == nullptr || group->kind != ast::OpenGroup::Kind::paren) {
    unexpected(list, "`(` or `{` after `function`");
  }
  Nested part(*this, *list.tree, group->items);
  while (peek().kind != Token::Kind::end) {
    add(next());
    optional_comma();
  }
  if (names.empty()) {
    fail(Code::missing_argument, list.span, "a function needs at least one parameter",
         "without `( )` they are x, y and z");
  }
  return names;
}

/// `internal(N) }`: one of the built-in shapes and noises (builtin-functions §4).
Value Interpreter::read_internal_function(Span span) {
  next();
  const Token number = next();
  const auto* inner = number.node<ast::Paren>();
  if (inner == nullptr) {
    unexpected(number, "`(N)` and nothing else after `internal`");
  }
  const Span at = number.span;
  const double n = std::trunc(evaluate(*number.tree, inner->inner, 1).v[0]);
  constexpr auto count = functions::internal_functions.size();
  if (!(n >= 0 && n < static_cast<double>(count))) {
    fail(Code::out_of_range, at, fmt::format("there is no internal function {:g}", n),
         fmt::format("they have the numbers 0 to {}", count - 1));
  }
  expect_close("function", span);
  return value_of(functions::make_internal_function(static_cast<int>(n)), false, span);
}

/// `pattern {…} }`, `pigment {…} }`, `transform {…} }` and `spline {…} }`.
Value Interpreter::read_special_function(Span span) {
  const Token word = next();
  if (word.word == w::transform) {
    const Transform map = read_transform_block();
    expect_close("function", span);
    return value_of(functions::make_transform_function(map.forward), true, span);
  }
  if (word.word == w::spline) {
    auto spline = read_spline(word.span);
    expect_close("function", span);
    return value_of(functions::make_spline_function(std::move(spline)), true, span);
  }
  const bool is_pattern = word.word == w::pattern;
  const scene::Pigment pigment = is_pattern ? read_pattern(word) : read_pigment({});
  expect_close("function", span);
  if (const std::string* feature = unsupported_in(pigment)) {
    return {std::make_shared<const Unsupported>(Unsupported{*feature, word.span})};
  }
  if (options_.pigments == nullptr) not_supported("asking a pigment for its colour", word.span);
  return value_of(functions::make_external_function(
                      is_pattern ? options_.pigments->pattern_function(scene_, pigment)
                                 : options_.pigments->pigment_function(scene_, pigment)),
                  !is_pattern, span);
}

/// A pattern with its modifiers, but without colours: `{ … }`.
scene::Pigment Interpreter::read_pattern(const Token& word) {
  scene::Pigment p = read_pigment({});
  if (!p.pattern->exists() && p.unsupported.empty()) {
    fail(Code::missing_argument, word.span, "expected a pattern, such as `bozo` or `gradient x`");
  }
  return p;
}

// ---- calls in scene expressions
// ------------------------------------------------------------------

/// The noise of functions, as far as the scene has settled it (builtin-functions §3).
int Interpreter::noise_generator() const {
  if (scene_.settings.noise_generator != 0) return scene_.settings.noise_generator;
  return declared_version_ >= 350 ? 2 : 1;
}

Num Interpreter::call_function(const UserFunction& f, const ast::Tree& tree, const ast::Expr& e,
                               int length) {
  std::array<double, UserFunction::max_parameters + 1> arguments;  // NOLINT: filled as far as used
  const std::size_t given = read_arguments(tree, e, arguments);
  const functions::Function& tape = *f.tape;
  if (given != tape.parameters) {
    Diagnostic d;
    d.code = Code::missing_argument;
    d.span = e.span;
    d.message = fmt::format("this function takes {}, here {} {}", argument_count(tape.parameters),
                            given == 1 ? "is" : "are", given);
    d.labels.push_back({f.declared, "the function is declared here"});
    fail(std::move(d));
  }
  workspace_.context.noise_generator = noise_generator();
  functions::Evaluator<double> evaluator(tape, workspace_);
  const double value = evaluator({arguments.data(), given});
  if (workspace_.loop_budget == 0) {
    fail(Code::limit, e.span, "the sums and products of functions take too many turns");
  }
  if (!f.is_vector) return Num::filled(value, length);
  Num n;
  n.length = tape.components();
  for (int i = 0; i < n.length; ++i) n.v[static_cast<std::size_t>(i)] = evaluator.component(i);
  return n;
}

/// The floats that a call hands over; at most as many as `out` holds. Returns their number.
std::size_t Interpreter::read_arguments(const ast::Tree& tree, const ast::Expr& e,
                                        std::span<double> out) {
  std::size_t n = 0;
  const auto add = [&](double v) {
    if (n < out.size()) out[n++] = v;
  };
  const auto read_all = [&] {
    while (peek().kind != Token::Kind::end) {
      add(read_scalar("argument"));
      argument_comma();
    }
  };
  const auto* call = std::get_if<ast::Call>(&e.node);
  if (call == nullptr) {
    const Nested part(*this, tree, std::get<ast::OpenGroup>(e.node).items, e.span);
    read_all();
    return n;
  }
  for (std::uint32_t i = 0; i < call->args.count; ++i) {
    const ast::ExprId id = tree.expr_lists[call->args.first + i];
    if (tree.exprs[id].may_expand && needs_expansion(tree, id)) {
      const Nested part(*this, tree, id);  // a macro body may hold several
      read_all();
      continue;
    }
    const Num v = evaluate(tree, id, 1);
    if (v.length != 1) {
      fail(Code::wrong_kind, tree.exprs[id].span,
           fmt::format("expected a float as argument, found a value of {} components", v.length),
           "pick a component, as in `V.x`");
    }
    add(v.v[0]);
  }
  return n;
}

}  // namespace durer::interpreter
