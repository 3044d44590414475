// From the syntax tree of an expression to the code of the formula machine.
#include <algorithm>

#include "interpreter/float_functions.h"
#include "interpreter/formula.h"
#include "interpreter/value.h"

namespace durer::interpreter {
namespace {

namespace w = grammar::words;
using Kind = FormulaOp::Kind;

constexpr std::size_t most_ops = 400;
constexpr std::size_t deepest_call = 8;  // of macros in line

struct Arity {
  std::size_t least = 0;
  std::size_t most = 0;  // 0: the machine does not know the function
};

Arity arity_of_float_function(SymbolId function) {
  const FloatFunction* f = float_function(function);
  return f == nullptr ? Arity{} : Arity{f->least, f->most};
}

Arity arity_of_vector_function(SymbolId function) {
  switch (function) {
    case w::vlength: return {1, 1};
    case w::vcross:
    case w::vdot: return {2, 2};
    default: return {};
  }
}

Arity arity_of_string_function(SymbolId function) {
  switch (function) {
    case w::asc:
    case w::chr:
    case w::strlen:
    case w::strlwr:
    case w::strupr:
    case w::val: return {1, 1};
    case w::strcmp: return {2, 2};
    case w::str:
    case w::substr: return {3, 3};
    case w::vstr: return {5, 5};
    case w::concat: return {1, 20};
    default: return {};
  }
}

class Compiler {
 public:
  Compiler(const FormulaContext& context, const ast::Tree& tree)
      : context_(context), tree_(&tree) {}

  Formula run(ast::ExprId id) {
    formula_.shines_through = leads_with_component(id);
    if (!emit(id, FormulaOp::given, true)) formula_.ops.clear();
    formula_.ops.shrink_to_fit();
    return std::move(formula_);
  }

 private:
  /// What a name means inside a macro in line: a local of the machine, or (by reference) a variable
  /// of the language.
  struct Binding {
    SymbolId name = 0;
    bool is_parameter = false;
    bool is_local = false;
    std::uint8_t local = 0;
    SymbolId variable = 0;
  };

  [[nodiscard]] bool leads_with_component(ast::ExprId id) const {
    for (;;) {
      const auto& node = tree_->exprs[id].node;
      if (const auto* b = std::get_if<ast::Binary>(&node)) {
        id = b->left;
      } else if (const auto* u = std::get_if<ast::Unary>(&node)) {
        id = u->operand;
      } else if (const auto* p = std::get_if<ast::Paren>(&node)) {
        id = p->inner;
      } else {
        return std::holds_alternative<ast::Member>(node);
      }
    }
  }

  FormulaOp& add(Kind kind, std::uint8_t want, std::size_t count = 0, SymbolId name = 0) {
    FormulaOp& op = formula_.ops.emplace_back();
    op.kind = kind;
    op.count = static_cast<std::uint8_t>(count);
    op.want = want;
    op.name = name;
    return op;
  }
  /// The same of an op that leaves one operand more on the stack.
  bool push(Kind kind, std::uint8_t want, std::size_t count = 0, SymbolId name = 0) {
    add(kind, want, count, name);
    return ++depth_ <= formula_stack && formula_.ops.size() < most_ops;
  }
  /// The same of an op that takes `count` operands and leaves one.
  bool reduce(Kind kind, std::uint8_t want, std::size_t count, SymbolId name = 0) {
    depth_ -= count;
    return push(kind, want, count, name);
  }
  bool number(double x, std::uint8_t want) {
    if (!push(Kind::number, want)) return false;
    formula_.ops.back().value = x;
    return true;
  }

  /// `want`: see FormulaOp. `alone`: no operator stands next to the expression.
  bool emit(ast::ExprId id, std::uint8_t want, bool alone) {
    const ast::Expr& e = tree_->exprs[id];
    if (const auto* n = std::get_if<ast::Number>(&e.node)) return number(n->value, want);
    if (const auto* n = std::get_if<ast::Name>(&e.node)) return name(n->name, want);
    if (const auto* p = std::get_if<ast::Paren>(&e.node)) return paren(*p, want);
    if (const auto* b = std::get_if<ast::Binary>(&e.node)) return binary(*b, want);
    if (const auto* u = std::get_if<ast::Unary>(&e.node)) return unary(*u, want);
    if (const auto* v = std::get_if<ast::Vector>(&e.node)) return vector(*v);
    if (const auto* i = std::get_if<ast::Index>(&e.node)) return index(*i, want);
    if (const auto* m = std::get_if<ast::Member>(&e.node)) return member(*m, want);
    if (const auto* c = std::get_if<ast::Conditional>(&e.node)) return conditional(*c, want);
    if (const auto* c = std::get_if<ast::Call>(&e.node)) return call(*c, want, alone);
    if (const auto* s = std::get_if<ast::String>(&e.node)) return string(*s);
    return false;
  }

  bool name(SymbolId symbol, std::uint8_t want) {
    if (symbol >= w::count_) {
      const Binding* b = binding(symbol);
      if (b == nullptr) return push(Kind::variable, want, 0, symbol);
      if (!b->is_local) return push(Kind::variable, want, 0, b->variable);
      return push(Kind::local, want, b->local);
    }
    switch (symbol) {
      case w::x: return push(Kind::axis, want, 3, 0);
      case w::y: return push(Kind::axis, want, 3, 1);
      case w::z: return push(Kind::axis, want, 3, 2);
      case w::u: return push(Kind::axis, want, 2, 0);
      case w::v: return push(Kind::axis, want, 2, 1);
      case w::t: return push(Kind::axis, want, 4, 3);
      case w::pi: return number(3.14159265358979323846, want);
      case w::true_:
      case w::yes:
      case w::on: return number(1, want);
      case w::false_:
      case w::no:
      case w::off: return number(0, want);
      case w::clock: return number(context_.clock, want);
      default: return false;
    }
  }

  bool string(const ast::String& s) {
    const std::string& bytes = tree_->strings[s.index];
    const auto plain = [](char c) { return c > 0 && c != '\\'; };
    if (!std::ranges::all_of(bytes, plain)) return false;  // escapes, or codes of a charset
    if (!push(Kind::text, 1)) return false;
    formula_.ops.back().text = &formula_.texts.emplace_back(bytes);
    return true;
  }

  bool paren(const ast::Paren& p, std::uint8_t want) {
    if (!emit(p.inner, 1, true)) return false;
    if (want != 1) add(Kind::widen, want);
    return true;
  }

  /// As many components as the operand has that was emitted last.
  [[nodiscard]] std::uint8_t as_last() const {
    return static_cast<std::uint8_t>(FormulaOp::as_slot + depth_ - 1);
  }

  bool binary(const ast::Binary& b, std::uint8_t want) {
    if (!emit(b.left, want, false) || !emit(b.right, as_last(), false)) return false;
    static_assert(static_cast<int>(Kind::or_) - static_cast<int>(Kind::add) ==
                  static_cast<int>(ast::Op::or_) - static_cast<int>(ast::Op::add));
    return reduce(static_cast<Kind>(static_cast<int>(Kind::add) + static_cast<int>(b.op)), want, 2);
  }

  bool unary(const ast::Unary& u, std::uint8_t want) {
    if (!emit(u.operand, want, false)) return false;
    if (u.op == ast::Op::neg) add(Kind::neg, want);
    if (u.op == ast::Op::not_) add(Kind::not_, want);
    return true;
  }

  bool conditional(const ast::Conditional& c, std::uint8_t want) {
    if (leads_with_component(c.yes) || leads_with_component(c.no)) return false;
    return emit(c.condition, 1, false) && emit(c.yes, want, false) && emit(c.no, want, false) &&
           reduce(Kind::choose, want, 3);
  }

  /// Arguments of functions that see the slots beyond the length (language §2.4).
  bool whole_list(ast::Range range, std::uint8_t want) {
    for (std::uint32_t i = 0; i < range.count; ++i) {
      if (leads_with_component(tree_->expr_lists[range.first + i])) return false;
    }
    return list(range, want);
  }

  bool list(ast::Range range, std::uint8_t want = 1) {
    for (std::uint32_t i = 0; i < range.count; ++i) {
      if (!emit(tree_->expr_lists[range.first + i], want, true)) return false;
    }
    return true;
  }

  bool vector(const ast::Vector& v) {
    if (v.components.count < 2 || v.components.count > 5) return false;
    return list(v.components) && reduce(Kind::vector, 1, v.components.count);
  }

  bool index(const ast::Index& i, std::uint8_t want) {
    if (i.subscripts.count == 0 || i.subscripts.count > 5 || !list(i.subscripts)) return false;
    const Binding* b = binding(i.name);
    if (b != nullptr && b->is_local) return false;
    return reduce(Kind::element, want, i.subscripts.count, b != nullptr ? b->variable : i.name);
  }

  bool member(const ast::Member& m, std::uint8_t want) {
    const int slot = component_slot(m.member);
    if (slot < 0) return false;
    const auto* object = std::get_if<ast::Name>(&tree_->exprs[m.object].node);
    if (object != nullptr && object->name >= w::count_) {
      const Binding* b = binding(object->name);
      if (b == nullptr || !b->is_local) {
        return push(Kind::component, want, static_cast<std::size_t>(slot),
                    b != nullptr ? b->variable : object->name);
      }
    }
    if (!emit(m.object, 1, false)) return false;
    add(Kind::member, want, static_cast<std::size_t>(slot));
    return true;
  }

  bool call(const ast::Call& c, std::uint8_t want, bool alone) {
    const auto* callee = std::get_if<ast::Name>(&tree_->exprs[c.callee].node);
    if (callee == nullptr) return false;
    if (callee->name >= w::count_) return call_declared(c, callee->name, want, alone);
    const auto fits = [&](Arity arity) {
      return c.args.count >= arity.least && c.args.count <= arity.most && arity.most > 0;
    };
    const SymbolId function = callee->name;
    if (function == w::rand) {
      if (c.args.count != 1 || ++draws_ > formula_draws || !list(c.args)) return false;
      add(Kind::rand, want);
      return true;
    }
    // `select` hands its own length on to what it chooses from.
    if (function == w::select && want != 1) return false;
    if (fits(arity_of_float_function(function))) {
      if (!list(c.args) || !reduce(Kind::function, want, c.args.count, function)) return false;
      formula_.ops.back().function = float_function(function);
      return true;
    }
    if (fits(arity_of_vector_function(function))) {
      return whole_list(c.args, 3) && reduce(Kind::geometry, want, c.args.count, function);
    }
    if (fits(arity_of_string_function(function))) {
      return whole_list(c.args, 1) && reduce(Kind::string, want, c.args.count, function);
    }
    return false;
  }

  bool call_declared(const ast::Call& c, SymbolId callee, std::uint8_t want, bool alone) {
    if (binding(callee) != nullptr) return false;
    const Value* v = Environment::value_of(context_.env.find(callee));
    if (v == nullptr) return false;
    if (v->get<Shared<UserFunction>>() != nullptr) {
      formula_.calls_functions = true;
      return list(c.args) && reduce(Kind::user_function, want, c.args.count, callee);
    }
    const MacroRef* ref = v->get<MacroRef>();
    if (ref == nullptr || !context_.macros) return false;
    if (ref->macro->items.shape != ast::Body::Shape::value) return false;
    if (!alone && !ref->macro->atomic) return false;
    return macro(c, callee, *ref, want);
  }

  // ---- macros in line

  [[nodiscard]] const Binding* binding(SymbolId name) const {
    for (std::size_t i = bindings_.size(); i-- > 0;) {
      if (bindings_[i].name == name) return &bindings_[i];
    }
    return nullptr;
  }

  bool macro(const ast::Call& c, SymbolId callee, const MacroRef& ref, std::uint8_t want) {
    const ast::Macro& macro = *ref.macro;
    if (c.args.count != macro.params.count || calls_ >= deepest_call) return false;
    ++formula_.calls;
    add(Kind::is_macro, 1, 0, callee).macro = &macro;
    const std::size_t outer_bindings = bindings_.size();
    const std::size_t outer_locals = locals_;
    std::vector<Binding> parameters;
    for (std::uint32_t i = 0; i < c.args.count; ++i) {
      const ast::Param& parameter = ref.tree->params[macro.params.first + i];
      if (parameter.optional) return false;
      if (!argument(tree_->expr_lists[c.args.first + i], parameter.name, parameters)) return false;
    }
    // Names are looked up dynamically: those of the callers stay in sight (language §4.2).
    bindings_.insert(bindings_.end(), parameters.begin(), parameters.end());
    const ast::Tree* const caller = tree_;
    tree_ = ref.tree;
    ++calls_;
    const bool done = body(macro, outer_bindings, want);
    --calls_;
    tree_ = caller;
    bindings_.resize(outer_bindings);
    locals_ = outer_locals;
    return done;
  }

  /// A bare name goes by reference; everything else is worked out before.
  bool argument(ast::ExprId id, SymbolId parameter, std::vector<Binding>& out) {
    const auto* bare = std::get_if<ast::Name>(&tree_->exprs[id].node);
    if (bare != nullptr && bare->name >= w::count_) {
      Binding b;
      if (const Binding* known = binding(bare->name)) {
        b = *known;
      } else {
        b.variable = bare->name;
      }
      b.name = parameter;
      b.is_parameter = true;
      if (!b.is_local) add(Kind::exists, 1, 0, b.variable);
      out.push_back(b);
      return true;
    }
    Binding b;
    b.name = parameter;
    b.is_parameter = true;
    b.is_local = true;
    if (!emit(id, 1, true) || !set_local(b)) return false;
    out.push_back(b);
    return true;
  }

  /// Takes the operand on top of the stack into a new local.
  bool set_local(Binding& b) {
    if (locals_ >= formula_locals) return false;
    b.local = static_cast<std::uint8_t>(locals_++);
    add(Kind::set_local, 1, b.local);
    --depth_;
    return true;
  }

  /// `#local`s of numbers and strings, then the value.
  bool body(const ast::Macro& macro, std::size_t scope, std::uint8_t want) {
    for (std::uint32_t i = 0; i + 1 < macro.items.count; ++i) {
      const ast::Item& item = tree_->items[macro.items.first + i];
      const auto* local = std::get_if<ast::Declare>(&tree_->directives[item.ref].node);
      if (local == nullptr || !assignment(*local, scope)) return false;
    }
    const ast::ExprId value = tree_->items[macro.items.first + macro.items.count - 1].ref;
    return !leads_with_component(value) && emit(value, want, true);
  }

  bool assignment(const ast::Declare& d, std::size_t scope) {
    if (!d.local || d.deprecated || d.value == ast::none || d.place != ast::none) return false;
    if (d.subscripts.count > 0 || !d.semicolon || d.name < w::count_) return false;
    // A name or element alone may stand for anything.
    const auto& node = tree_->exprs[d.value].node;
    if (std::holds_alternative<ast::Name>(node) || std::holds_alternative<ast::Index>(node)) {
      return false;
    }
    add(Kind::is_free, 1, 0, d.name);
    if (!emit(d.value, 1, true)) return false;
    for (std::size_t i = bindings_.size(); i-- > scope;) {
      if (bindings_[i].name != d.name) continue;
      // A parameter is written through to what was handed over.
      if (bindings_[i].is_parameter) return false;
      add(Kind::set_local, 1, bindings_[i].local);
      --depth_;
      return true;
    }
    Binding b;
    b.name = d.name;
    b.is_local = true;
    if (!set_local(b)) return false;
    bindings_.push_back(b);
    return true;
  }

  const FormulaContext& context_;
  const ast::Tree* tree_;
  Formula formula_;
  std::size_t depth_ = 0;
  std::size_t draws_ = 0;
  std::size_t calls_ = 0;
  std::size_t locals_ = 0;
  std::vector<Binding> bindings_;
};

}  // namespace

Formula compile_formula(const FormulaContext& context, const ast::Tree& tree, ast::ExprId id) {
  return Compiler(context, tree).run(id);
}

}  // namespace durer::interpreter
