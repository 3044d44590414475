// From the code of a formula to straight code: the same steps, with the lengths worked out.
#include <algorithm>

#include "interpreter/formula_operators.h"
#include "interpreter/formula_straight.h"
#include "interpreter/user_function.h"

namespace durer::interpreter {
namespace {

namespace w = grammar::words;
using In = FormulaOp::Kind;
using Out = StraightOp::Kind;

class Straightener {
 public:
  Straightener(const Environment& env, int wanted) : env_(env), given_(wanted) {}

  std::shared_ptr<const StraightCode> run(const Formula& formula) {
    if (formula.shines_through) return nullptr;  // slots beyond a length would have to be kept
    for (const FormulaOp& op : formula.ops) {
      if (!step(op)) return nullptr;
    }
    code_.length = lengths_.front();
    code_.ops.shrink_to_fit();
    return std::make_shared<const StraightCode>(std::move(code_));
  }

 private:
  [[nodiscard]] int wanted(const FormulaOp& op) const {
    if (op.want < FormulaOp::given) return op.want;
    return op.want == FormulaOp::given
               ? given_
               : lengths_[static_cast<std::size_t>(op.want - FormulaOp::as_slot)];
  }

  StraightOp& add(Out kind, int n = 1, int m = 1, SymbolId name = 0) {
    StraightOp& op = code_.ops.emplace_back();
    op.kind = kind;
    op.n = static_cast<std::uint8_t>(n);
    op.m = static_cast<std::uint8_t>(m);
    op.name = name;
    return op;
  }

  void drop(std::size_t operands) { lengths_.resize(lengths_.size() - operands); }
  bool push(int length) {
    lengths_.push_back(length);
    return true;
  }
  /// A float fills the place that it is for.
  bool push_float(int want) {
    if (want > 1) add(Out::repeat, want);
    return push(std::max(want, 1));
  }
  bool push_number(int length, int want) { return length == 1 ? push_float(want) : push(length); }

  [[nodiscard]] bool are_floats(std::size_t operands) const {
    return std::all_of(lengths_.end() - static_cast<std::ptrdiff_t>(operands), lengths_.end(),
                       [](int n) { return n == 1; });
  }

  bool step(const FormulaOp& op) {
    switch (op.kind) {
      case In::number: add(Out::number).value = op.value; return push_float(wanted(op));
      case In::axis:
        for (std::uint8_t i = 0; i < op.count; ++i) add(Out::number).value = i == op.name ? 1 : 0;
        return push(op.count);
      case In::variable: return variable(op);
      case In::component: return component(op);
      case In::local: {
        const int n = locals_[op.count];
        add(Out::local, n, op.count);
        return push_number(n, wanted(op));
      }
      case In::element: return element(op);
      case In::member: return member(op);
      case In::vector:
        if (!are_floats(op.count)) return false;
        drop(op.count);
        return push(op.count);  // they lie as they should
      case In::add:
      case In::sub:
      case In::mul:
      case In::div:
      case In::lt:
      case In::le:
      case In::eq:
      case In::ne:
      case In::ge:
      case In::gt:
      case In::and_:
      case In::or_: return binary(op);
      case In::neg: add(Out::neg, lengths_.back()); return true;
      case In::not_: add(Out::not_, lengths_.back()); return true;
      case In::widen: return widen(wanted(op));
      case In::choose: return choose(wanted(op));
      case In::function: {
        const int want = wanted(op);
        if (!are_floats(op.count)) return false;
        add(Out::function, 1, op.count).function = op.function;
        drop(op.count);
        return push_float(want);
      }
      case In::geometry: return geometry(op);
      case In::rand: {
        const int want = wanted(op);
        if (!are_floats(1)) return false;
        add(Out::rand);
        drop(1);
        return push_float(want);
      }
      case In::user_function: return user_function(op);
      case In::is_macro: add(Out::is_macro, 1, 1, op.name).macro = op.macro; return true;
      case In::is_free: add(Out::is_free, 1, 1, op.name); return true;
      case In::exists: add(Out::exists, 1, 1, op.name); return true;
      case In::set_local:
        locals_[op.count] = lengths_.back();
        add(Out::set_local, lengths_.back(), op.count);
        drop(1);
        return true;
      case In::text:
      case In::string: return false;
    }
    return false;
  }

  /// How many components the variable has now; 0 if it holds no number.
  [[nodiscard]] int length_of(SymbolId name) const {
    const Value* v = value_of(env_, name);
    const Num* n = v == nullptr ? nullptr : v->get<Num>();
    return n == nullptr ? 0 : n->length;
  }

  bool variable(const FormulaOp& op) {
    const int n = length_of(op.name);
    if (n == 0) return false;
    add(n == 1 ? Out::load : Out::load_many, n, 1, op.name);
    return push_number(n, wanted(op));
  }

  bool component(const FormulaOp& op) {
    const int n = length_of(op.name);
    if (op.count >= n) return false;
    add(Out::component, n, op.count, op.name);
    return n == 1 ? push_float(wanted(op)) : push(1);
  }

  bool member(const FormulaOp& op) {
    const int n = lengths_.back();
    if (op.count >= n) return false;
    const int want = wanted(op);
    drop(1);
    if (n == 1) return push_float(want);
    add(Out::member, n, op.count);
    return push(1);
  }

  bool element(const FormulaOp& op) {
    const int want = wanted(op);
    const Value* v = value_of(env_, op.name);
    const auto* array = v == nullptr ? nullptr : v->get<std::shared_ptr<Array>>();
    if (array == nullptr || (*array)->sizes.size() != op.count || !are_floats(op.count)) {
      return false;
    }
    const auto& all = (*array)->elements;
    const auto first = std::ranges::find_if(all, [](const Value& e) { return e.defined(); });
    const Num* n = first == all.end() ? nullptr : first->get<Num>();
    if (n == nullptr) return false;
    add(Out::element, n->length, op.count, op.name);
    drop(op.count);
    return push_number(n->length, want);
  }

  bool binary(const FormulaOp& op) {
    const int right = lengths_.back();
    const int left = lengths_[lengths_.size() - 2];
    if (left == 1 && right == 1) {
      scalar(op.kind);
    } else {
      if (left != right && left != 1 && right != 1) return false;
      add(Out::lanes, left, right).with = op.kind;
    }
    drop(2);
    return push(std::max(left, right));
  }

  /// An operator of two floats. A number on its right side becomes part of it.
  void scalar(In with) {
    StraightOp& last = code_.ops.back();
    const bool number = last.kind == Out::number;
    const auto choose = [&](Out of_two, Out of_number) { return number ? of_number : of_two; };
    const Out kind = with == In::add   ? choose(Out::add, Out::add_number)
                     : with == In::sub ? choose(Out::sub, Out::sub_number)
                     : with == In::mul ? choose(Out::mul, Out::mul_number)
                                       : choose(Out::scalar, Out::scalar_number);
    StraightOp& op = number ? last : add(kind);
    op.kind = kind;
    op.with = with;
  }

  bool widen(int want) {
    const int n = lengths_.back();
    if (n >= want) return true;
    drop(1);
    if (n == 1) return push_float(want);
    for (int i = n; i < want; ++i) add(Out::number).value = 0;
    return push(want);
  }

  bool choose(int want) {
    const int no = lengths_.back();
    const int yes = lengths_[lengths_.size() - 2];
    if (yes != no || lengths_[lengths_.size() - 3] != 1) return false;
    add(Out::choose, yes);
    drop(3);
    return push_number(yes, want);
  }

  bool geometry(const FormulaOp& op) {
    const int want = wanted(op);
    const int n = lengths_[lengths_.size() - op.count];
    const int m = lengths_.back();
    const bool fits = n >= 2 && n <= 3 && m >= 2 && m <= 3;
    if (!fits) return false;
    const bool is_vector = op.name == w::vcross;
    add(is_vector ? Out::vcross : op.name == w::vdot ? Out::vdot : Out::vlength, n, m);
    drop(op.count);
    return is_vector ? push(3) : push_float(want);
  }

  bool user_function(const FormulaOp& op) {
    const int want = wanted(op);
    const Value* v = value_of(env_, op.name);
    const auto* f = v == nullptr ? nullptr : v->get<Shared<UserFunction>>();
    if (f == nullptr || (*f)->is_vector || !are_floats(op.count)) return false;
    add(Out::user_function, 1, op.count, op.name);
    drop(op.count);
    return push_float(want);
  }

  const Environment& env_;
  int given_;
  StraightCode code_;
  std::vector<int> lengths_;  // of the operands on the stack
  std::array<int, formula_locals> locals_{};
};

}  // namespace

std::shared_ptr<const StraightCode> straighten(const Formula& formula, const Environment& env,
                                               int wanted) {
  return Straightener(env, wanted).run(formula);
}

}  // namespace durer::interpreter
