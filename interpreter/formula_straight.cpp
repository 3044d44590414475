#include "interpreter/formula_straight.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <glm/geometric.hpp>

#include "interpreter/arguments.h"
#include "interpreter/float_functions.h"
#include "interpreter/formula_operators.h"
#include "interpreter/user_function.h"

namespace durer::interpreter {
namespace {

using Kind = StraightOp::Kind;

/// The number that the name stands for, if it has `n` components.
inline const Num* number_of(const Environment& env, SymbolId name, int n) {
  const Value* v = value_of(env, name);
  const Num* number = v == nullptr ? nullptr : v->get<Num>();
  return number != nullptr && number->length == n ? number : nullptr;
}

/// Five components, whether they count or not: there is always room for them.
inline void copy_all(const double* from, double* to) { std::memcpy(to, from, 5 * sizeof(double)); }

inline dvec3 vector_at(const double* v, int n) { return {v[0], v[1], n > 2 ? v[2] : 0}; }

template <typename Apply>
bool each_lane(double* left, int n, int m, Apply apply) {
  const double* const right = left + n;
  if (m == 1) {
    const double b = *right;
    for (int i = 0; i < n; ++i) {
      if (!apply(left[i], b, left[i])) return false;
    }
  } else if (n == 1) {
    const double a = *left;
    for (int i = 0; i < m; ++i) {
      if (!apply(a, right[i], left[i])) return false;
    }
  } else {
    for (int i = 0; i < n; ++i) {
      if (!apply(left[i], right[i], left[i])) return false;
    }
  }
  return true;
}

/// An operator on numbers of n and m components, which lie behind each other; the result replaces
/// them. A float goes with every component of the other.
bool apply_lanes(FormulaOp::Kind with, double* left, int n, int m) {
  switch (with) {
    case FormulaOp::Kind::add:
      return each_lane(left, n, m, [](double a, double b, double& out) {
        out = a + b;
        return true;
      });
    case FormulaOp::Kind::sub:
      return each_lane(left, n, m, [](double a, double b, double& out) {
        out = a - b;
        return true;
      });
    case FormulaOp::Kind::mul:
      return each_lane(left, n, m, [](double a, double b, double& out) {
        out = a * b;
        return true;
      });
    default:
      return each_lane(left, n, m, [with](double a, double b, double& out) {
        return apply_floats(with, a, b, out);
      });
  }
}

}  // namespace

/// Most formulas are one variable: that needs no machine.
bool FormulaMachine::run_straight(const StraightCode& code) {
  const StraightOp& first = code.ops.front();
  const bool is_single = code.ops.size() == 1;
  if (!is_single || first.kind > Kind::load_many) return run_operations(code);
  Operand& result = stack_[0];
  result.length = code.length;
  if (first.kind == Kind::number) {
    result.v = {first.value};
    return true;
  }
  const Num* x = number_of(env_, first.name, first.n);
  if (x == nullptr) return false;
  if (first.kind == Kind::load) {
    result.v = {x->v[0]};  // there may be something behind it (language §2.4)
  } else {
    copy_all(x->v.data(), result.v.data());
  }
  return true;
}

bool FormulaMachine::run_operations(const StraightCode& code) {
  double* top = lanes_.data();  // behind the last component
  for (const StraightOp& op : code.ops) {
    switch (op.kind) {
      case Kind::number: *top++ = op.value; break;
      case Kind::load: {
        const Num* x = number_of(env_, op.name, 1);
        if (x == nullptr) return false;
        *top++ = x->v[0];
        break;
      }
      case Kind::load_many: {
        const Num* x = number_of(env_, op.name, op.n);
        if (x == nullptr) return false;
        copy_all(x->v.data(), top);
        top += op.n;
        break;
      }
      case Kind::component: {
        const Num* x = number_of(env_, op.name, op.n);
        if (x == nullptr) return false;
        *top++ = x->v[op.m];
        break;
      }
      case Kind::local:
        copy_all(local_lanes_[op.m].data(), top);
        top += op.n;
        break;
      case Kind::element:
        top -= op.m;
        if (!load_element(op, top)) return false;
        top += op.n;
        break;
      case Kind::repeat: {
        const double x = top[-1];
        for (int i = 1; i < op.n; ++i) *top++ = x;
        break;
      }
      case Kind::add:
        --top;
        top[-1] += *top;
        break;
      case Kind::sub:
        --top;
        top[-1] -= *top;
        break;
      case Kind::mul:
        --top;
        top[-1] *= *top;
        break;
      case Kind::add_number: top[-1] += op.value; break;
      case Kind::sub_number: top[-1] -= op.value; break;
      case Kind::mul_number: top[-1] *= op.value; break;
      case Kind::div_number: top[-1] /= op.value; break;
      case Kind::scalar:
        --top;
        if (!apply_floats(op.with, top[-1], top[0], top[-1])) return false;
        break;
      case Kind::scalar_number:
        if (!apply_floats(op.with, top[-1], op.value, top[-1])) return false;
        break;
      case Kind::lanes:
        top -= op.n + op.m;
        if (!apply_lanes(op.with, top, op.n, op.m)) return false;
        top += std::max(op.n, op.m);
        break;
      case Kind::neg:
        for (int i = 1; i <= op.n; ++i) top[-i] = -top[-i];
        break;
      case Kind::not_:
        for (int i = 1; i <= op.n; ++i) top[-i] = truth(!(std::abs(top[-i]) > epsilon));
        break;
      case Kind::member:
        top -= op.n - 1;
        top[-1] = top[op.m - 1];
        break;
      case Kind::choose: {
        const int n = op.n;
        top -= 2 * n + 1;
        const double* chosen = std::abs(*top) > epsilon ? top + 1 : top + 1 + n;
        for (int i = 0; i < n; ++i) *top++ = chosen[i];
        break;
      }
      case Kind::function: {
        top -= op.m;
        double x = 0;
        if (!op.function->apply(top, op.m, x)) return false;
        *top++ = x;
        break;
      }
      case Kind::vlength:
        top -= op.n;
        *top = glm::length(vector_at(top, op.n));
        ++top;
        break;
      case Kind::vdot:
        top -= op.n + op.m;
        *top = glm::dot(vector_at(top, op.n), vector_at(top + op.n, op.m));
        ++top;
        break;
      case Kind::vcross: {
        top -= op.n + op.m;
        const dvec3 p = glm::cross(vector_at(top, op.n), vector_at(top + op.n, op.m));
        *top++ = p.x;
        *top++ = p.y;
        *top++ = p.z;
        break;
      }
      case Kind::rand:
        if (!draw_number(top[-1])) return false;
        break;
      case Kind::user_function: {
        const Value* v = value_of(env_, op.name);
        const auto* f = v == nullptr ? nullptr : v->get<Shared<UserFunction>>();
        if (f == nullptr || (*f)->is_vector || (*f)->tape->parameters != op.m) return false;
        top -= op.m;
        functions::Evaluator<double> evaluator(*(*f)->tape, workspace_);
        *top = evaluator({top, op.m});
        if (workspace_.loop_budget == 0) return false;
        ++top;
        break;
      }
      case Kind::is_macro:
        if (!is_still_macro(env_, op.name, op.macro)) return false;
        break;
      case Kind::is_free:
        if (!may_be_hidden(env_, op.name)) return false;
        break;
      case Kind::exists:
        if (!has_value(env_, op.name)) return false;
        break;
      case Kind::set_local: {
        top -= op.n;
        copy_all(top, local_lanes_[op.m].data());
        for (int i = 0; i < 5 && op.n == 5; ++i) {  // colour variables are 32-bit (language §2)
          double& x = local_lanes_[op.m][static_cast<std::size_t>(i)];
          x = static_cast<float>(x);
        }
        break;
      }
    }
  }
  Operand& result = stack_[0];
  result.length = code.length;
  std::memset(top, 0, 5 * sizeof(double));  // nothing lies behind the result
  copy_all(lanes_.data(), result.v.data());
  return true;
}

/// Replaces the subscripts by the element that they lead to.
bool FormulaMachine::load_element(const StraightOp& op, double* first) const {
  const Value* v = value_of(env_, op.name);
  const auto* array = v == nullptr ? nullptr : v->get<std::shared_ptr<Array>>();
  if (array == nullptr || (*array)->sizes.size() != op.m) return false;
  std::size_t flat = 0;
  for (std::size_t i = 0; i < op.m; ++i) {
    const std::size_t size = (*array)->sizes[i];
    const double at = std::floor(first[i] + epsilon);
    if (!(at >= 0 && at < static_cast<double>(size))) return false;
    flat = flat * size + static_cast<std::size_t>(at);
  }
  const Num* n = (*array)->elements[flat].get<Num>();
  if (n == nullptr || n->length != op.n) return false;
  copy_all(n->v.data(), first);
  return true;
}

}  // namespace durer::interpreter
