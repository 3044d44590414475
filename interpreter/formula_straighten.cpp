// From the code of a formula to straight code: the same steps, with the lengths worked out.
//
// A float where more components are wanted stays one float as long as it only meets operators, which
// do the same to all components; constants are worked out now or become part of an operator.
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
    fill_out(0);
    code_.length = parts_.front().length;
    code_.ops.shrink_to_fit();
    return std::make_shared<const StraightCode>(std::move(code_));
  }

 private:
  /// An operand on the stack.
  struct Part {
    int length = 1;
    bool repeated = false;   // its code makes one float, which stands for all components
    std::size_t begin = 0;   // of its code, which ends where that of the next one begins
    [[nodiscard]] int made() const { return repeated ? 1 : length; }
  };

  [[nodiscard]] int wanted(const FormulaOp& op) const {
    if (op.want < FormulaOp::given) return op.want;
    return op.want == FormulaOp::given
               ? given_
               : parts_[static_cast<std::size_t>(op.want - FormulaOp::as_slot)].length;
  }

  [[nodiscard]] std::size_t end_of(std::size_t part) const {
    return part + 1 < parts_.size() ? parts_[part + 1].begin : code_.ops.size();
  }

  /// Makes all components of a part that is one float.
  void fill_out(std::size_t part) {
    if (!parts_[part].repeated) return;
    StraightOp op;
    op.kind = Out::repeat;
    op.n = static_cast<std::uint8_t>(parts_[part].length);
    code_.ops.insert(code_.ops.begin() + static_cast<std::ptrdiff_t>(end_of(part)), op);
    for (std::size_t i = part + 1; i < parts_.size(); ++i) ++parts_[i].begin;
    parts_[part].repeated = false;
  }

  /// The number that the part is, if it is a literal.
  [[nodiscard]] const double* constant(std::size_t part) const {
    const std::size_t begin = parts_[part].begin;
    const bool single = end_of(part) == begin + 1 && parts_[part].made() == 1;
    return single && code_.ops[begin].kind == Out::number ? &code_.ops[begin].value : nullptr;
  }

  StraightOp& add(Out kind, int n = 1, int m = 1, SymbolId name = 0) {
    StraightOp& op = code_.ops.emplace_back();
    op.kind = kind;
    op.n = static_cast<std::uint8_t>(n);
    op.m = static_cast<std::uint8_t>(m);
    op.name = name;
    return op;
  }

  /// The operands become one; its code begins where that of the first did, or ends the code if it
  /// has none.
  void drop(std::size_t operands) {
    const std::size_t left = parts_.size() - operands;
    next_begin_ = operands == 0 ? code_.ops.size() : parts_[left].begin;
    parts_.resize(left);
  }
  bool push(int length, bool repeated = false) {
    parts_.push_back({length, repeated, next_begin_});
    return true;
  }
  /// A float fills the place that it is for.
  bool push_float(int want) { return push(std::max(want, 1), want > 1); }
  bool push_number(int length, int want) { return length == 1 ? push_float(want) : push(length); }

  [[nodiscard]] Part& last() { return parts_.back(); }

  [[nodiscard]] bool are_floats(std::size_t operands) const {
    return std::all_of(parts_.end() - static_cast<std::ptrdiff_t>(operands), parts_.end(),
                       [](const Part& p) { return p.length == 1; });
  }

  bool step(const FormulaOp& op) {
    switch (op.kind) {
      case In::number:
        drop(0);
        add(Out::number).value = op.value;
        return push_float(wanted(op));
      case In::axis:
        drop(0);
        for (std::uint8_t i = 0; i < op.count; ++i) add(Out::number).value = i == op.name ? 1 : 0;
        return push(op.count);
      case In::variable: return variable(op);
      case In::component: return component(op);
      case In::local: {
        const int n = locals_[op.count];
        drop(0);
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
      case In::neg:
        if (constant(parts_.size() - 1) != nullptr) {
          code_.ops.back().value = -code_.ops.back().value;
        } else {
          add(Out::neg, last().made());
        }
        return true;
      case In::not_: add(Out::not_, last().made()); return true;
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
        fill_out(parts_.size() - 1);
        locals_[op.count] = last().length;
        add(Out::set_local, last().length, op.count);
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
    drop(0);
    add(n == 1 ? Out::load : Out::load_many, n, 1, op.name);
    return push_number(n, wanted(op));
  }

  bool component(const FormulaOp& op) {
    const int n = length_of(op.name);
    if (op.count >= n) return false;
    drop(0);
    add(Out::component, n, op.count, op.name);
    return n == 1 ? push_float(wanted(op)) : push(1);
  }

  bool member(const FormulaOp& op) {
    const Part part = last();
    if (op.count >= part.length) return false;
    const int want = wanted(op);
    drop(1);
    if (part.length == 1) return push_float(want);
    if (!part.repeated) add(Out::member, part.length, op.count);
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
    const Part right = last();
    const Part left = parts_[parts_.size() - 2];
    const int length = std::max(left.length, right.length);
    if (left.length != right.length && left.length != 1 && right.length != 1) return false;
    const bool floats = left.made() == 1 && right.made() == 1;
    if (floats) {
      scalar(op.kind);
    } else {
      add(Out::lanes, left.made(), right.made()).with = op.kind;
    }
    drop(2);
    return push(length, floats && length > 1);
  }

  /// An operator of two floats. A constant becomes part of it.
  void scalar(In with) {
    const std::size_t right = parts_.size() - 1;
    const double* const a = constant(right - 1);
    const double* const b = constant(right);
    if (double result = 0; a != nullptr && b != nullptr && apply_floats(with, *a, *b, result)) {
      code_.ops.pop_back();
      code_.ops.back().value = result;
      return;
    }
    if (a != nullptr && b == nullptr && (with == In::add || with == In::mul)) {
      // The order of the operands does not matter.
      const auto first = code_.ops.begin() + static_cast<std::ptrdiff_t>(parts_[right - 1].begin);
      std::rotate(first, first + 1, code_.ops.end());
    } else if (b == nullptr) {
      add(with == In::add   ? Out::add
          : with == In::sub ? Out::sub
          : with == In::mul ? Out::mul
                            : Out::scalar)
          .with = with;
      return;
    }
    StraightOp& number = code_.ops.back();
    number.kind = with == In::add                          ? Out::add_number
                  : with == In::sub                        ? Out::sub_number
                  : with == In::mul                        ? Out::mul_number
                  : with == In::div && number.value != 0.0 ? Out::div_number
                                                           : Out::scalar_number;
    number.with = with;
  }

  bool widen(int want) {
    const int n = last().length;
    if (n >= want) return true;
    if (n > 1) {
      fill_out(parts_.size() - 1);
      for (int i = n; i < want; ++i) add(Out::number).value = 0;
    }
    drop(1);
    return n == 1 ? push_float(want) : push(want);
  }

  bool choose(int want) {
    const std::size_t top = parts_.size() - 1;
    const int yes = parts_[top - 1].length;
    if (yes != parts_[top].length || parts_[top - 2].length != 1) return false;
    fill_out(top - 1);
    fill_out(top);
    add(Out::choose, yes);
    drop(3);
    return push_number(yes, want);
  }

  bool geometry(const FormulaOp& op) {
    const int want = wanted(op);
    const std::size_t first = parts_.size() - op.count;
    const int n = parts_[first].length;
    const int m = last().length;
    const bool fits = n >= 2 && n <= 3 && m >= 2 && m <= 3;
    if (!fits) return false;
    for (std::size_t i = first; i < parts_.size(); ++i) fill_out(i);
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
    drop(op.count);
    add(Out::user_function, 1, op.count, op.name);
    return push_float(want);
  }

  const Environment& env_;
  int given_;
  StraightCode code_;
  std::vector<Part> parts_;  // the operands on the stack
  std::size_t next_begin_ = 0;
  std::array<int, formula_locals> locals_{};
};

}  // namespace

std::shared_ptr<const StraightCode> straighten(const Formula& formula, const Environment& env,
                                               int wanted) {
  return Straightener(env, wanted).run(formula);
}

}  // namespace durer::interpreter
