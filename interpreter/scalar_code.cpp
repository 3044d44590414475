#include "interpreter/scalar_code.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "interpreter/arguments.h"
#include "interpreter/value.h"

namespace durer::interpreter {
namespace {

namespace w = grammar::words;
using Kind = ScalarOp::Kind;

/// Arguments that a float function takes here; 0: it is not for this machine.
std::size_t arity(SymbolId function) {
  switch (function) {
    case w::abs:
    case w::cos:
    case w::sin:
    case w::tan:
    case w::atan:
    case w::exp:
    case w::floor:
    case w::ceil:
    case w::int_:
    case w::sqrt:
    case w::degrees:
    case w::radians: return 1;
    case w::mod:
    case w::div:
    case w::max:
    case w::min:
    case w::pow:
    case w::atan2: return 2;
    case w::select: return 3;
    default: return 0;
  }
}

class Compiler {
 public:
  Compiler(const ast::Tree& tree, double clock) : tree_(tree), clock_(clock) {}

  ScalarCode run(ast::ExprId id) {
    if (!emit(id)) code_.ops.clear();
    code_.ops.shrink_to_fit();
    code_.leads_with_component = leads_with_component(id);
    return std::move(code_);
  }

 private:
  bool leads_with_component(ast::ExprId id) const {
    for (;;) {
      const auto& node = tree_.exprs[id].node;
      if (const auto* b = std::get_if<ast::Binary>(&node)) {
        id = b->left;
      } else if (const auto* u = std::get_if<ast::Unary>(&node)) {
        id = u->operand;
      } else {
        return std::holds_alternative<ast::Member>(node);
      }
    }
  }

  bool push(ScalarOp op) {
    code_.ops.push_back(op);
    return ++depth_ <= scalar_stack;
  }
  bool number(double x) { return push({Kind::number, 0, 0, x}); }

  bool emit(ast::ExprId id) {
    const ast::Expr& e = tree_.exprs[id];
    if (const auto* n = std::get_if<ast::Number>(&e.node)) return number(n->value);
    if (const auto* n = std::get_if<ast::Name>(&e.node)) return name(n->name);
    if (const auto* p = std::get_if<ast::Paren>(&e.node)) return emit(p->inner);
    if (const auto* b = std::get_if<ast::Binary>(&e.node)) return binary(*b);
    if (const auto* u = std::get_if<ast::Unary>(&e.node)) return unary(*u);
    if (const auto* i = std::get_if<ast::Index>(&e.node)) return index(*i);
    if (const auto* m = std::get_if<ast::Member>(&e.node)) return member(*m);
    if (const auto* c = std::get_if<ast::Call>(&e.node)) return call(*c);
    return false;
  }

  bool name(SymbolId symbol) {
    if (symbol >= w::count_) return push({Kind::variable, 0, symbol, 0});
    switch (symbol) {
      case w::pi: return number(3.14159265358979323846);
      case w::true_:
      case w::yes:
      case w::on: return number(1);
      case w::false_:
      case w::no:
      case w::off: return number(0);
      case w::clock: return number(clock_);
      default: return false;
    }
  }

  bool binary(const ast::Binary& b) {
    if (!emit(b.left) || !emit(b.right)) return false;
    --depth_;
    static_assert(static_cast<int>(Kind::or_) - static_cast<int>(Kind::add) ==
                  static_cast<int>(ast::Op::or_) - static_cast<int>(ast::Op::add));
    const int kind = static_cast<int>(Kind::add) + static_cast<int>(b.op);
    code_.ops.push_back({static_cast<Kind>(kind), 0, 0, 0});
    return true;
  }

  bool unary(const ast::Unary& u) {
    if (!emit(u.operand)) return false;
    if (u.op == ast::Op::neg) code_.ops.push_back({Kind::neg, 0, 0, 0});
    if (u.op == ast::Op::not_) code_.ops.push_back({Kind::not_, 0, 0, 0});
    return true;
  }

  bool list(ast::Range range) {
    for (std::uint32_t i = 0; i < range.count; ++i) {
      if (!emit(tree_.expr_lists[range.first + i])) return false;
    }
    return true;
  }

  bool index(const ast::Index& i) {
    if (i.subscripts.count == 0 || i.subscripts.count > 5 || !list(i.subscripts)) return false;
    depth_ -= i.subscripts.count;
    return push({Kind::element, static_cast<std::uint8_t>(i.subscripts.count), i.name, 0});
  }

  bool member(const ast::Member& m) {
    const auto* object = std::get_if<ast::Name>(&tree_.exprs[m.object].node);
    const int slot = component_slot(m.member);
    if (object == nullptr || object->name < w::count_ || slot < 0) return false;
    return push({Kind::component, static_cast<std::uint8_t>(slot), object->name, 0});
  }

  bool call(const ast::Call& c) {
    const auto* callee = std::get_if<ast::Name>(&tree_.exprs[c.callee].node);
    if (callee == nullptr || callee->name >= w::count_) return false;
    if (callee->name == w::rand) {
      if (c.args.count != 1 || ++draws_ > max_draws || !list(c.args)) return false;
      code_.ops.push_back({Kind::rand, 0, 0, 0});
      return true;
    }
    const std::size_t wanted = arity(callee->name);
    const bool fits = c.args.count == wanted || (callee->name == w::select && c.args.count == 4);
    if (wanted == 0 || !fits || !list(c.args)) return false;
    depth_ -= c.args.count;
    return push({Kind::function, static_cast<std::uint8_t>(c.args.count), callee->name, 0});
  }

  const ast::Tree& tree_;
  double clock_;
  ScalarCode code_;
  std::size_t depth_ = 0;
  std::size_t draws_ = 0;
};

// ---- running
// --------------------------------------------------------------------------------------

/// The number that a name stands for; null if it is no number, or its use must be told.
inline const Num* number_of(const Environment& env, SymbolId name) {
  Slot* slot = env.find(name);
  if (slot == nullptr || slot->deprecated) return nullptr;
  const Value* v = Environment::value_of(slot);
  return v == nullptr ? nullptr : v->get<Num>();
}

/// The float at the subscripts; false if there is none.
bool element_of(const Environment& env, SymbolId name, const double* subscripts, std::size_t count,
                double& out) {
  const Value* v = Environment::value_of(env.find(name));
  const auto* array = v == nullptr ? nullptr : v->get<std::shared_ptr<Array>>();
  if (array == nullptr || (*array)->sizes.size() != count) return false;
  std::size_t flat = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t size = (*array)->sizes[i];
    const double at = std::floor(subscripts[i] + epsilon);
    if (!(at >= 0 && at < static_cast<double>(size))) return false;
    flat = flat * size + static_cast<std::size_t>(at);
  }
  const Num* n = (*array)->elements[flat].get<Num>();
  if (n == nullptr || n->length != 1) return false;
  out = n->v[0];
  return true;
}

/// a[0]… are the arguments; false if the function has no value there, or something to tell.
bool apply_function(SymbolId function, const double* a, std::size_t count, double& out) {
  switch (function) {
    case w::abs: out = std::abs(a[0]); return true;
    case w::cos: out = std::cos(a[0]); return true;
    case w::sin: out = std::sin(a[0]); return true;
    case w::tan: out = std::tan(a[0]); return true;
    case w::atan: out = std::atan(a[0]); return true;
    case w::exp: out = std::exp(a[0]); return true;
    case w::floor: out = std::floor(a[0]); return true;
    case w::ceil: out = std::ceil(a[0]); return true;
    case w::int_: out = to_int(a[0]); return true;
    case w::degrees: out = a[0] / radians_per_degree; return true;
    case w::radians: out = a[0] * radians_per_degree; return true;
    case w::sqrt: out = std::sqrt(a[0]); return !(a[0] < 0);
    case w::mod: out = std::fmod(a[0], a[1]); return true;
    case w::div: out = to_int(a[0] / a[1]); return true;
    case w::max: out = std::max(a[0], a[1]); return true;
    case w::min: out = std::min(a[0], a[1]); return true;
    case w::pow: out = std::pow(a[0], a[1]); return a[0] != 0 || a[1] != 0;
    case w::atan2:
      out = std::atan2(a[0], a[1]);
      return std::abs(a[0]) > epsilon || std::abs(a[1]) > epsilon;
    case w::select: out = a[0] < 0 ? a[1] : a[0] == 0 || count == 3 ? a[2] : a[3]; return true;
    default: return false;
  }
}

double truth(bool b) { return b ? 1.0 : 0.0; }

struct Draw {
  std::size_t stream;
  std::uint32_t before;
};

/// Leaves the draws made so far in `draws`, for the caller to take back.
bool execute(const ScalarCode& code, const Environment& env, std::vector<std::uint32_t>& streams,
             std::array<Draw, max_draws>& draws, std::size_t& drawn, double& result) {
  double stack[scalar_stack];
  double* top = stack - 1;  // points at the last operand
  for (const ScalarOp& op : code.ops) {
    switch (op.kind) {
      case Kind::number: *++top = op.value; break;
      case Kind::variable: {
        const Num* n = number_of(env, op.name);
        if (n == nullptr || n->length != 1) return false;
        *++top = n->v[0];
        break;
      }
      case Kind::component: {
        const Num* n = number_of(env, op.name);
        if (n == nullptr || op.detail >= n->length) return false;
        *++top = n->v[op.detail];
        break;
      }
      case Kind::element:
        top -= op.detail - 1;
        if (!element_of(env, op.name, top, op.detail, *top)) return false;
        break;
      case Kind::add: --top; *top += top[1]; break;
      case Kind::sub: --top; *top -= top[1]; break;
      case Kind::mul: --top; *top *= top[1]; break;
      case Kind::div:
        --top;
        if (top[1] == 0) return false;
        *top /= top[1];
        break;
      case Kind::lt: --top; *top = truth(*top < top[1]); break;
      case Kind::gt: --top; *top = truth(*top > top[1]); break;
      case Kind::le: --top; *top = truth(*top < top[1] || nearly_equal(*top, top[1])); break;
      case Kind::ge: --top; *top = truth(*top > top[1] || nearly_equal(*top, top[1])); break;
      case Kind::eq: --top; *top = truth(nearly_equal(*top, top[1])); break;
      case Kind::ne: --top; *top = truth(!nearly_equal(*top, top[1])); break;
      case Kind::and_:
        --top;
        *top = truth(std::abs(*top) > epsilon && std::abs(top[1]) > epsilon);
        break;
      case Kind::or_:
        --top;
        *top = truth(std::abs(*top) > epsilon || std::abs(top[1]) > epsilon);
        break;
      case Kind::neg: *top = -*top; break;
      case Kind::not_: *top = truth(!(std::abs(*top) > epsilon)); break;
      case Kind::function: {
        top -= op.detail - 1;
        double value = 0;
        if (!apply_function(op.name, top, op.detail, value)) return false;
        *top = value;
        break;
      }
      case Kind::rand: {
        const std::int32_t i = to_int(*top);
        if (i < 0 || static_cast<std::size_t>(i) >= streams.size()) return false;
        std::uint32_t& state = streams[static_cast<std::size_t>(i)];
        draws[drawn++] = {static_cast<std::size_t>(i), state};
        *top = draw(state);
        break;
      }
    }
  }
  result = *top;
  return true;
}

}  // namespace

ScalarCode compile_scalar(const ast::Tree& tree, ast::ExprId id, double clock) {
  return Compiler(tree, clock).run(id);
}

bool run_scalar(const ScalarCode& code, const Environment& env, std::vector<std::uint32_t>& streams,
                double& result) {
  std::array<Draw, max_draws> draws;  // NOLINT: filled up to `drawn`
  std::size_t drawn = 0;
  if (execute(code, env, streams, draws, drawn, result)) return true;
  while (drawn > 0) {
    --drawn;
    streams[draws[drawn].stream] = draws[drawn].before;
  }
  return false;
}

}  // namespace durer::interpreter
