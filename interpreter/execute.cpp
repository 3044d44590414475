// What directives do: conditions, loops, switches, messages, versions. Names are in
// declare.cpp, macro calls in macros.cpp, files in include.cpp.
#include <cmath>

#include <fmt/format.h>

#include "base/suggest.h"
#include "interpreter/interpreter.h"

namespace durer::interpreter {

using Shape = ast::Body::Shape;

void Interpreter::execute(const ast::Tree& tree, const ast::Item& item) {
  const ast::Directive& d = tree.directives[item.ref];
  const bool outermost = reading_depth_ == no_reader;
  if (outermost) reading_depth_ = frames_.size();
  if (run_directive(tree, d) == Flow::broken) break_out(d.span);
  if (outermost) reading_depth_ = no_reader;  // after a Failure recover() needs it
}

Interpreter::Flow Interpreter::run_directive(const ast::Tree& tree, const ast::Directive& d) {
  if (const auto* declare = std::get_if<ast::Declare>(&d.node)) {  // by far the commonest
    run(tree, d, *declare);
    return Flow::normal;
  }
  return std::visit(
      [&](const auto& node) {
        using Node = std::decay_t<decltype(node)>;
        if constexpr (std::is_same_v<Node, ast::Break>) {
          return Flow::broken;
        } else if constexpr (std::is_void_v<decltype(run(tree, d, node))>) {
          run(tree, d, node);
          return Flow::normal;
        } else {
          return run(tree, d, node);
        }
      },
      d.node);
}

/// Only where `repeats_` > 0: what runs once is read from frames, so that an error in it costs no
/// more than the statement.
Interpreter::Flow Interpreter::run_statements(const ast::Tree& tree, ast::Range items) {
  for (std::uint32_t i = 0; i < items.count; ++i) {
    const std::uint32_t pos = items.first + i;
    if (takes_shortcuts()) {
      const Statement& s = statement_at(tree, pos);
      if (s.kind == Statement::Kind::assign && quick_assign(*s.declare, *s.formula)) continue;
    }
    const ast::Directive& d = tree.directives[tree.items[pos].ref];
    if (run_directive(tree, d) == Flow::broken) return Flow::broken;
  }
  return Flow::normal;
}

namespace {
Frame items_frame(Frame::Kind kind, const ast::Tree& tree, ast::Range items, bool flatten) {
  Frame f;
  f.kind = kind;
  f.flatten = flatten;
  f.tree = &tree;
  f.first = items.first;
  f.pos = items.first;
  f.end = items.first + items.count;
  return f;
}

std::uint32_t index_of(const ast::Tree& tree, const ast::Directive& d) {
  return static_cast<std::uint32_t>(&d - tree.directives.data());
}
}  // namespace

// ---- conditions -------------------------------------------------------------------------------

bool Interpreter::condition(const ast::Tree& tree, ast::ExprId id) {
  if (const Operand* quickly = quick(tree, id, 1); quickly != nullptr && quickly->is_float()) {
    return std::abs(quickly->v[0]) > epsilon;
  }
  if (is_text(tree, id)) {
    fail(Code::wrong_kind, tree.exprs[id].span, "expected a condition, found a string",
         "compare it, as in `(Name = \"x\")`");
  }
  const Num n = evaluate_full(tree, id, 1);
  if (n.length != 1) {
    fail(Code::wrong_kind, tree.exprs[id].span, "expected a float as condition, found a vector",
         "pick a component, as in `(V.x > 0)`");
  }
  return std::abs(n.v[0]) > epsilon;
}

bool Interpreter::is_defined(const ast::Tree& tree, ast::ExprId id) {
  const ast::Expr& e = tree.exprs[id];
  if (const auto* name = std::get_if<ast::Name>(&e.node)) {
    return !symbols_.reserved(name->name) && env_.find(name->name) != nullptr;
  }
  if (additions_) {
    const Value* v = place(tree, id, Access::probe).value;
    return v != nullptr && v->defined();
  }
  if (const auto array = array_of(e)) {
    return element(*array, read_subscripts(tree, id), e.span, false, false)->defined();
  }
  fail(Code::unexpected_item, e.span, "expected a name");
}

Interpreter::Flow Interpreter::run(const ast::Tree& tree, const ast::Directive& d,
                                   const ast::If& node) {
  (void)d;
  for (std::uint32_t i = 0; i < node.branches.count; ++i) {
    const ast::Branch& b = tree.branches[node.branches.first + i];
    bool taken = false;
    switch (b.kind) {
      case ast::Branch::Kind::if_: taken = condition(tree, b.condition); break;
      case ast::Branch::Kind::ifdef: taken = is_defined(tree, b.condition); break;
      case ast::Branch::Kind::ifndef: taken = !is_defined(tree, b.condition); break;
      case ast::Branch::Kind::else_: taken = true; break;
    }
    if (!taken) continue;
    if (repeats_ > 0 && b.items.shape == Shape::statements) return run_statements(tree, b.items);
    Frame f = items_frame(Frame::Kind::branch, tree, b.items, frames_.back().flatten);
    f.call = b.span;
    push(f);
    return Flow::normal;
  }
  return Flow::normal;
}

namespace {
bool all_statements(const ast::Tree& tree, const ast::Switch& node) {
  for (std::uint32_t i = 0; i < node.cases.count; ++i) {
    if (tree.cases[node.cases.first + i].items.shape != Shape::statements) return false;
  }
  return true;
}
}  // namespace

Interpreter::Flow Interpreter::run(const ast::Tree& tree, const ast::Directive& d,
                                   const ast::Switch& node) {
  const double value = evaluate_full(tree, node.value, 1).v[0];
  for (std::uint32_t i = 0; i < node.cases.count; ++i) {
    const ast::Case& c = tree.cases[node.cases.first + i];
    bool matches = c.kind == ast::Case::Kind::else_;
    if (c.kind == ast::Case::Kind::case_) {
      const double* known = literal(tree, c.low);
      const double wanted = known != nullptr ? *known : evaluate_full(tree, c.low, 1).v[0];
      matches = std::abs(value - wanted) < epsilon;
    } else if (c.kind == ast::Case::Kind::range) {
      const double low = evaluate(tree, c.low, 1).v[0];
      const double high = evaluate(tree, c.high, 1).v[0];
      matches = low <= value && value <= high;
    }
    if (!matches) continue;
    if (repeats_ > 0 && all_statements(tree, node)) {
      // Cases fall through, even into #else, until #break (language §4.4).
      for (std::uint32_t k = i; k < node.cases.count; ++k) {
        if (run_statements(tree, tree.cases[node.cases.first + k].items) == Flow::broken) break;
      }
      return Flow::normal;
    }
    Frame f = items_frame(Frame::Kind::switch_, tree, c.items, frames_.back().flatten);
    f.node = index_of(tree, d);
    f.next_case = i + 1;
    f.call = d.span;
    push(f);
    return Flow::normal;
  }
  return Flow::normal;
}

/// The same of a switch that was planned; false, with nothing done, if its value is unusual.
bool Interpreter::run_switch(const ast::Tree& tree, const SwitchPlan& plan) {
  const Operand* value = run_formula(*plan.value, 1);
  if (value == nullptr || value->is_text()) return false;
  const ast::Directive& d = tree.directives[plan.directive];
  const auto& node = std::get<ast::Switch>(d.node);
  ++frames_.back().pos;
  for (std::uint32_t i = 0; i < node.cases.count; ++i) {
    if (plan.cases[i] && !(std::abs(value->v[0] - *plan.cases[i]) < epsilon)) continue;
    const bool flatten = frames_.back().flatten;
    Frame& f = push(Frame::Kind::switch_, d.span);
    const ast::Range items = tree.cases[node.cases.first + i].items;
    f.flatten = flatten;
    f.tree = &tree;
    f.first = items.first;
    f.pos = items.first;
    f.end = items.first + items.count;
    f.node = plan.directive;
    f.next_case = i + 1;
    break;
  }
  return true;
}

// ---- loops ------------------------------------------------------------------------------------

Interpreter::Flow Interpreter::run(const ast::Tree& tree, const ast::Directive& d,
                                   const ast::While& node) {
  if (node.items.shape == Shape::statements) {
    const Repeating inside(*this);
    while (condition(tree, node.condition)) {
      tick(d.span);
      if (run_statements(tree, node.items) == Flow::broken) break;
    }
    return Flow::normal;
  }
  if (!condition(tree, node.condition)) return Flow::normal;
  Frame f = items_frame(Frame::Kind::while_, tree, node.items, frames_.back().flatten);
  f.node = index_of(tree, d);
  f.call = d.span;
  push(f);
  return Flow::normal;
}

Interpreter::Flow Interpreter::run(const ast::Tree& tree, const ast::Directive& d,
                                   const ast::For& node) {
  const double start = work_out_float(tree, node.start, "start");
  const double end = work_out_float(tree, node.end, "end");
  const double step = node.step == ast::none ? 1.0 : work_out_float(tree, node.step, "step");
  if (std::abs(step) < epsilon) {
    fail(Code::out_of_range, d.span, "the step of `#for` is zero", "give a step other than 0");
  }
  check_may_change(env_.find(node.name), d.span, true);
  Slot& slot = env_.for_local(node.name);
  Environment::value_of(&slot)->set(Num(start));
  if (!(step > 0 ? start < end + epsilon : start > end - epsilon)) return Flow::normal;
  if (node.items.shape == Shape::statements) {
    const Repeating inside(*this);
    do {
      if (run_statements(tree, node.items) == Flow::broken) break;
    } while (next_turn(d, node, end, step));
    return Flow::normal;
  }
  Frame f = items_frame(Frame::Kind::for_, tree, node.items, frames_.back().flatten);
  f.node = index_of(tree, d);
  f.limit = end;
  f.step = step;
  f.call = d.span;
  push(f);
  return Flow::normal;
}

/// Advances the loop variable; false if the loop has ended.
bool Interpreter::next_turn(const ast::Directive& d, const ast::For& node, double limit,
                            double step) {
  tick(d.span);
  Value* v = Environment::value_of(env_.find(node.name));
  Num* n = v == nullptr ? nullptr : v->get<Num>();
  if (n == nullptr || n->length != 1) {
    fail(Code::wrong_kind, d.span,
         fmt::format("the loop variable `{}` is no float any more", name_of(node.name)));
  }
  // The sum is accumulated, so steps of 0.1 drift exactly as they do in the oracle.
  n->v[0] += step;
  return step > 0 ? n->v[0] < limit + epsilon : n->v[0] > limit - epsilon;
}

/// At the end of a loop body: rewinds `frame` for another round, or returns false.
bool Interpreter::loop_again(Frame& frame) {
  const ast::Tree& tree = *frame.tree;
  const ast::Directive& d = tree.directives[frame.node];
  if (const auto* node = std::get_if<ast::While>(&d.node)) {
    const std::size_t depth = frames_.size();
    tick(d.span);
    if (!condition(tree, node->condition)) return false;
    frames_[depth - 1].pos = frames_[depth - 1].first;  // `frame` may have moved
    return true;
  }
  const bool again =
      next_turn(d, std::get<ast::For>(d.node), frame.limit, frame.step);
  if (again) frame.pos = frame.first;
  return again;
}

// ---- messages, versions, the rest --------------------------------------------------------------

void Interpreter::run(const ast::Tree& tree, const ast::Directive& d, const ast::Message& node) {
  std::string text =
      (node.value == ast::none ? read_text() : evaluate_text(tree, node.value)).bytes();
  using Kind = ast::Message::Kind;
  if (node.kind == Kind::error) fail(Code::user_error, d.span, text.empty() ? "#error" : text);
  if (node.kind == Kind::warning) {
    if (text.size() > 160) text = text.substr(0, 124) + "...";
    warn(Code::user_warning, d.span, text);
    return;
  }
  if (node.kind != Kind::debug) {
    warn(Code::deprecated, d.span,
         "this message stream no longer exists; the text is printed as by `#debug`");
  }
  if (text.size() > 200) text = text.substr(0, 156) + "...";
  if (options_.on_debug) options_.on_debug(text);
}

void Interpreter::run(const ast::Tree& tree, const ast::Directive& d, const ast::Version& node) {
  const Num v = node.value == ast::none ? read_num(1) : evaluate(tree, node.value, 1);
  set_version(v.v[0], d.span);
}

void Interpreter::set_version(double v, Span span) {
  const int hundredths = static_cast<int>(std::lround(v * 100));
  if (hundredths > 380) {
    fail(Code::version, span, fmt::format("language version {:g} is not supported yet", v),
         "this program speaks versions up to 3.8: write `#version 3.8;`");
  }
  if (hundredths < 0) {
    fail(Code::version, span, fmt::format("there is no language version {:g}", v));
  }
  if (hundredths >= 380) declare_additions();
  declared_version_ = hundredths;
  version_source_ = {};
  version_given_ = true;
}

void Interpreter::run(const ast::Tree& tree, const ast::Directive& d, const ast::Simple& node) {
  (void)tree;
  switch (node.kind) {
    case ast::Simple::Kind::default_: default_block(); return;
    case ast::Simple::Kind::fopen: open_file(d.span); return;
    case ast::Simple::Kind::fclose: close_file(); return;
    case ast::Simple::Kind::read: read_file(); return;
    case ast::Simple::Kind::write: write_file(); return;
  }
}

void Interpreter::run(const ast::Tree& tree, const ast::Directive& d, const ast::Unknown& node) {
  (void)tree;
  static constexpr std::string_view known[] = {
      "break",  "case",    "debug",  "declare", "default", "else",  "elseif",
      "end",    "error",   "fclose", "fopen",   "for",     "if",    "ifdef",
      "ifndef", "include", "local",  "macro",   "range",   "read",  "statistics",
      "render", "switch",  "undef",  "version", "warning", "while", "write"};
  const auto near = closest(name_of(node.word), known);
  fail(Code::syntax, d.span, fmt::format("unknown directive `#{}`", name_of(node.word)),
       near ? fmt::format("did you mean `#{}`?", *near) : std::string());
}

void Interpreter::default_block() {
  expect_open("#default");
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) return;
    if (t.is(grammar::words::texture)) {
      const scene::TextureId read = read_texture("texture");
      if (scene_.textures[read].patterned()) {
        fail(Code::unexpected_item, t.span, "a default texture cannot be chosen by a pattern");
      }
      if (scene_.textures[read].layers.size() > 1) {
        fail(Code::unexpected_item, t.span, "a default texture has one layer");
      }
      default_texture_ = read;
    } else if (t.is(grammar::words::pigment) || t.is(grammar::words::finish) ||
               t.is(grammar::words::normal)) {
      scene::TextureUse use{default_texture_, {}};
      reading_default_ = true;
      edit_texture(use, t);
      reading_default_ = false;
      default_texture_ = use.texture;
      own_texture_ = scene::none;
    } else if (t.is(grammar::words::camera)) {
      default_camera_ = read_camera(t.span);
    } else if (t.is(grammar::words::radiosity)) {
      default_importance_ = read_importance(t);
    } else {
      unexpected(t, "`texture`, `pigment`, `normal`, `finish` or `camera` in `#default`");
    }
  }
}

}  // namespace durer::interpreter
