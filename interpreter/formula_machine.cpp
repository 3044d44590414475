#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "interpreter/arguments.h"
#include "interpreter/float_functions.h"
#include "interpreter/formula.h"
#include "interpreter/formula_operators.h"
#include "interpreter/formula_straight.h"
#include "interpreter/user_function.h"
#include "interpreter/value.h"

namespace durer::interpreter {
namespace {

namespace w = grammar::words;
using Kind = FormulaOp::Kind;

inline void set_float(Operand& o, double x, int wanted) {
  o.v[0] = x;
  o.length = 1;
  if (wanted <= 1) return;
  for (int i = 1; i < wanted; ++i) o.v[static_cast<std::size_t>(i)] = x;
  o.length = wanted;
}

void set_vector(Operand& o, dvec3 p) {
  o.v[0] = p.x;
  o.v[1] = p.y;
  o.v[2] = p.z;
  o.length = 3;
}

inline void set_text(Operand& o, const Text* text) {
  o.length = 0;
  o.string = text;
}

inline bool set_value(Operand& o, const Value* v, int wanted) {
  if (v == nullptr) return false;
  if (const Num* n = v->get<Num>()) {
    if (n->length == 1) {
      set_float(o, n->v[0], wanted);
    } else {
      o.v = n->v;
      o.length = n->length;
    }
    return true;
  }
  const auto* text = v->get<Shared<Text>>();
  if (text != nullptr) set_text(o, text->get());
  return text != nullptr;
}

inline bool is_float(const Operand& o) { return o.length == 1; }

inline bool are_floats(const Operand* first, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_float(first[i])) return false;
  }
  return true;
}

void stretch(Operand& o, int to) {
  for (int i = o.length; i < to; ++i) {
    o.v[static_cast<std::size_t>(i)] = o.length == 1 ? o.v[0] : 0;
  }
  o.length = to;
}

/// Functions of vectors; the arguments have been read where three components were wanted.
bool apply_geometry(SymbolId function, Operand* a, int wanted) {
  const auto vec = [](const Operand& o) {
    return dvec3(o.v[0], o.v[1], o.length > 2 ? o.v[2] : 0);
  };
  switch (function) {
    case w::vlength: set_float(*a, glm::length(vec(a[0])), wanted); return true;
    case w::vdot: set_float(*a, glm::dot(vec(a[0]), vec(a[1])), wanted); return true;
    case w::vcross: set_vector(*a, glm::cross(vec(a[0]), vec(a[1]))); return true;
    default: return false;
  }
}

}  // namespace

/// The general way, and straight code if it is worth while to make some. `failed`: what there was
/// did not do.
const Operand* FormulaMachine::run_unsettled(Formula& formula, int wanted, bool failed) {
  if (failed) {
    take_draws_back();
    formula.straight = nullptr;  // something is of another kind now
  }
  if (formula.ops.empty()) return nullptr;  // it has given up too often
  if (formula.straight == nullptr && formula.straightened < straightened_enough) {
    formula.straight = straighten(formula, env_, wanted);
    formula.straight_wanted = wanted;
    formula.straightened = formula.straight == nullptr
                               ? straightened_enough
                               : static_cast<std::uint8_t>(formula.straightened + 1);
  }
  return run_general(formula, wanted);
}

const Operand* FormulaMachine::run_general(const Formula& formula, int wanted) {
  if (execute(formula, wanted)) {
    if (!formula.shines_through && !stack_[0].is_text()) clear_beyond_length();
    return stack_.data();
  }
  take_draws_back();
  return nullptr;
}

void FormulaMachine::take_draws_back() {
  for (; drawn_ > 0; --drawn_) streams_[draws_[drawn_ - 1].stream] = draws_[drawn_ - 1].before;
}

void FormulaMachine::take_text(Text& out) {
  if (stack_[0].string == buffers_.data()) {
    out.swap(buffers_[0]);
  } else {
    out.assign(*stack_[0].string);
  }
}

bool FormulaMachine::execute(const Formula& formula, int given) {
  Operand* const stack = stack_.data();
  Operand* top = stack - 1;  // the last operand
  const auto wanted = [&](const FormulaOp& op) -> int {
    if (op.want < FormulaOp::given) return op.want;
    return op.want == FormulaOp::given ? given : stack[op.want - FormulaOp::as_slot].length;
  };
  for (const FormulaOp& op : formula.ops) {
    switch (op.kind) {
      case Kind::number: set_float(*++top, op.value, wanted(op)); break;
      case Kind::axis:
        ++top;
        top->v = {};
        top->v[op.name] = 1;
        top->length = op.count;
        break;
      case Kind::text: set_text(*++top, op.text); break;
      case Kind::variable: {
        const int n = wanted(op);
        if (!set_value(*++top, value_of(env_, op.name), n)) return false;
        break;
      }
      case Kind::component: {
        const Value* v = value_of(env_, op.name);
        const Num* n = v == nullptr ? nullptr : v->get<Num>();
        if (n == nullptr || op.count >= n->length) return false;
        const int length = wanted(op);
        if (n->length == 1) {
          set_float(*++top, n->v[0], length);
          break;
        }
        ++top;
        top->v = n->v;
        for (auto i = static_cast<std::size_t>(n->length); i < 5; ++i) top->v[i] = 0;
        top->v[0] = n->v[op.count];
        top->length = 1;  // the others stay behind it (language §2.4)
        break;
      }
      case Kind::member: {
        if (op.count >= top->length) return false;
        if (top->length == 1) {
          set_float(*top, top->v[0], wanted(op));
          break;
        }
        for (auto i = static_cast<std::size_t>(top->length); i < 5; ++i) top->v[i] = 0;
        top->v[0] = top->v[op.count];
        top->length = 1;
        break;
      }
      case Kind::local: {
        const Operand& local = locals_[op.count];
        const int n = wanted(op);
        ++top;
        if (is_float(local)) {
          set_float(*top, local.v[0], n);
        } else {
          *top = local;
        }
        break;
      }
      case Kind::element: {
        const int n = wanted(op);
        top -= op.count - 1;
        if (!element(op, top, n)) return false;
        break;
      }
      case Kind::vector:
        top -= op.count - 1;
        if (!are_floats(top, op.count)) return false;
        for (std::size_t i = 1; i < op.count; ++i) top->v[i] = top[i].v[0];
        top->length = op.count;
        break;
      case Kind::add:
        --top;
        if (is_float(top[0]) && is_float(top[1])) {
          top[0].v[0] += top[1].v[0];
        } else if (!apply(op.kind, top[0], top[1], wanted(op))) {
          return false;
        }
        break;
      case Kind::mul:
        --top;
        if (is_float(top[0]) && is_float(top[1])) {
          top[0].v[0] *= top[1].v[0];
        } else if (!apply(op.kind, top[0], top[1], wanted(op))) {
          return false;
        }
        break;
      case Kind::sub:
      case Kind::div:
      case Kind::lt:
      case Kind::le:
      case Kind::eq:
      case Kind::ne:
      case Kind::ge:
      case Kind::gt:
      case Kind::and_:
      case Kind::or_:
        --top;
        if (is_float(top[0]) && is_float(top[1])) {
          if (!apply_floats(op.kind, top[0].v[0], top[1].v[0], top[0].v[0])) return false;
        } else if (!apply(op.kind, top[0], top[1], wanted(op))) {
          return false;
        }
        break;
      case Kind::neg:
        if (top->is_text()) return false;
        for (int i = 0; i < top->length; ++i) {
          top->v[static_cast<std::size_t>(i)] = -top->v[static_cast<std::size_t>(i)];
        }
        break;
      case Kind::not_:
        if (top->is_text()) return false;
        for (int i = 0; i < top->length; ++i) {
          double& x = top->v[static_cast<std::size_t>(i)];
          x = truth(!(std::abs(x) > epsilon));
        }
        break;
      case Kind::widen:
        if (!top->is_text() && top->length < wanted(op)) stretch(*top, wanted(op));
        break;
      case Kind::choose: {
        const int n = wanted(op);
        top -= 2;
        if (!is_float(top[0]) || top[1].is_text() || top[2].is_text()) return false;
        Operand& chosen = top[std::abs(top[0].v[0]) > epsilon ? 1 : 2];
        if (chosen.length == 1) stretch(chosen, n);
        *top = chosen;
        break;
      }
      case Kind::function: {
        const int n = wanted(op);
        top -= op.count - 1;
        if (!are_floats(top, op.count)) return false;
        std::array<double, formula_stack> arguments;  // NOLINT: filled as far as used
        for (std::size_t i = 0; i < op.count; ++i) arguments[i] = top[i].v[0];
        double x = 0;
        if (!op.function->apply(arguments.data(), op.count, x)) return false;
        set_float(*top, x, n);
        break;
      }
      case Kind::geometry: {
        const int n = wanted(op);
        top -= op.count - 1;
        for (std::size_t i = 0; i < op.count; ++i) {
          if (top[i].is_text() || top[i].length > 3) return false;
        }
        if (!apply_geometry(op.name, top, n)) return false;
        break;
      }
      case Kind::string: {
        const int n = wanted(op);
        top -= op.count - 1;
        if (!call_string(op, top, n)) return false;
        break;
      }
      case Kind::rand:
        if (!is_float(*top) || !draw_number(top->v[0])) return false;
        set_float(*top, top->v[0], wanted(op));
        break;
      case Kind::user_function: {
        // Without arguments the result is a new operand.
        const int n = wanted(op);
        top -= static_cast<int>(op.count) - 1;
        if (!are_floats(top, op.count) || !call_user(op, top, n)) return false;
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
        Operand& local = locals_[op.count];
        if (top->is_text()) {
          Text& text = local_texts_[op.count];
          if (top->string == &buffer(top)) {
            text.swap(buffer(top));
          } else if (top->string != &text) {
            text.assign(*top->string);
          }
          set_text(local, &text);
        } else {
          local = *top;
          for (int i = 0; i < 5 && local.length == 5; ++i) {  // colour variables are 32-bit (§2)
            double& x = local.v[static_cast<std::size_t>(i)];
            x = static_cast<float>(x);
          }
        }
        --top;
        break;
      }
    }
  }
  return true;
}

/// An operator on vectors, or a comparison of strings.
bool FormulaMachine::apply(Kind kind, Operand& left, Operand& right, int wanted) {
  if (left.is_text() || right.is_text()) {
    const bool compares = kind >= Kind::lt && kind <= Kind::gt;
    if (!compares || !left.is_text() || !right.is_text()) return false;
    const auto order = *left.string <=> *right.string;
    double x = 0;
    if (!apply_floats(kind, order < 0 ? -1 : order > 0 ? 1 : 0, 0, x)) return false;
    set_float(left, x, wanted);
    return true;
  }
  if (left.length < right.length) stretch(left, right.length);
  if (right.length < left.length) stretch(right, left.length);
  for (std::size_t i = 0; i < static_cast<std::size_t>(left.length); ++i) {
    if (!apply_floats(kind, left.v[i], right.v[i], left.v[i])) return false;
  }
  return true;
}

/// The number or string at the subscripts.
bool FormulaMachine::element(const FormulaOp& op, Operand* first, int wanted) const {
  const Value* v = value_of(env_, op.name);
  const auto* array = v == nullptr ? nullptr : v->get<std::shared_ptr<Array>>();
  if (array == nullptr || (*array)->sizes.size() != op.count) return false;
  if (!are_floats(first, op.count)) return false;
  std::size_t flat = 0;
  for (std::size_t i = 0; i < op.count; ++i) {
    const std::size_t size = (*array)->sizes[i];
    const double at = std::floor(first[i].v[0] + epsilon);
    if (!(at >= 0 && at < static_cast<double>(size))) return false;
    flat = flat * size + static_cast<std::size_t>(at);
  }
  return set_value(*first, &(*array)->elements[flat], wanted);
}

/// The next number of the stream takes its place.
bool FormulaMachine::draw_number(double& stream) {
  const std::int32_t i = to_int(stream);
  if (i < 0 || static_cast<std::size_t>(i) >= streams_.size()) return false;
  std::uint32_t& state = streams_[static_cast<std::size_t>(i)];
  draws_[drawn_++] = {static_cast<std::size_t>(i), state};
  stream = draw(state);
  return true;
}

bool FormulaMachine::call_user(const FormulaOp& op, Operand* first, int wanted) {
  const Value* v = value_of(env_, op.name);
  const auto* f = v == nullptr ? nullptr : v->get<Shared<UserFunction>>();
  if (f == nullptr || (*f)->tape->parameters != op.count) return false;
  std::array<double, formula_stack> arguments;  // NOLINT: filled as far as used
  for (std::size_t i = 0; i < op.count; ++i) arguments[i] = first[i].v[0];
  functions::Evaluator<double> evaluator(*(*f)->tape, workspace_);
  const double value = evaluator({arguments.data(), op.count});
  if (workspace_.loop_budget == 0) return false;
  if (!(*f)->is_vector) {
    set_float(*first, value, wanted);
    return true;
  }
  first->length = (*f)->tape->components();
  for (int i = 0; i < first->length; ++i) {
    first->v[static_cast<std::size_t>(i)] = evaluator.component(i);
  }
  return true;
}

// ---- strings

/// The text of an operand, to be changed in place.
Text& FormulaMachine::own_text(Operand& operand) {
  Text& own = buffer(&operand);
  if (operand.string != &own) {
    own.assign(*operand.string);
    operand.string = &own;
  }
  return own;
}

bool FormulaMachine::call_string(const FormulaOp& op, Operand* first, int wanted) {
  const auto is_text = [](const Operand& o) { return o.is_text(); };
  const auto integer = [&](std::size_t i) { return to_int(first[i].v[0]); };
  const auto empty_text = [&]() -> Text& {
    Text& out = buffer(first);
    out.clear();
    set_text(*first, &out);
    return out;
  };
  switch (op.name) {
    case w::strlen:
    case w::asc:
    case w::val: {
      if (!is_text(*first)) return false;
      const Text& t = *first->string;
      set_float(*first,
                op.name == w::strlen ? static_cast<double>(t.size())
                : op.name == w::val  ? t.leading_number()
                : t.empty()          ? 0
                                     : t[0],
                wanted);
      return true;
    }
    case w::strcmp:
      if (!is_text(first[0]) || !is_text(first[1])) return false;
      set_float(*first, first[0].string->difference(*first[1].string), wanted);
      return true;
    case w::chr: {
      if (!is_float(*first)) return false;
      const std::int32_t code = integer(0);
      if (code < 0 || code > 65535) return false;
      empty_text().append(static_cast<char16_t>(code));
      return true;
    }
    case w::concat: {
      if (!std::all_of(first, first + op.count, is_text)) return false;
      Text& out = own_text(*first);
      for (std::size_t i = 1; i < op.count; ++i) out.append(*first[i].string);
      return true;
    }
    case w::strlwr:
      if (!is_text(*first)) return false;
      own_text(*first).to_lower(0);
      return true;
    case w::strupr:
      if (!is_text(*first)) return false;
      own_text(*first).to_upper(0);
      return true;
    case w::str: {
      if (!are_floats(first, 3)) return false;
      const double x = first->v[0];
      append_number(x, integer(1), integer(2), empty_text());
      return true;
    }
    case w::substr: {
      if (!is_text(*first) || !are_floats(first + 1, 2)) return false;
      const std::int64_t size = static_cast<std::int64_t>(first->string->size());
      const std::int64_t position = integer(1);
      const std::int64_t length = integer(2);
      if (position < 0 || length < 0 || position + length - 1 > size) return false;
      const std::int64_t begin = std::min(std::max(position, std::int64_t{1}) - 1, size);
      const std::int64_t count = std::min(length, size - begin);
      Text& own = buffer(first);
      if (first->string == &own) {
        own.keep(static_cast<std::size_t>(begin), static_cast<std::size_t>(count));
        return true;
      }
      const Text& whole = *first->string;
      empty_text().append(whole, static_cast<std::size_t>(begin), static_cast<std::size_t>(count));
      return true;
    }
    case w::vstr: {
      if (!is_float(first[0]) || is_text(first[1]) || !is_text(first[2])) return false;
      if (!are_floats(first + 3, 2)) return false;
      const int n = std::clamp(integer(0), 2, 5);
      Text& out = empty_text();
      for (int i = 0; i < n; ++i) {
        if (i > 0) out.append(*first[2].string);
        const double x = i < first[1].length ? first[1].v[static_cast<std::size_t>(i)] : 0;
        append_number(x, integer(3), integer(4), out, longest_component);
      }
      return true;
    }
    default: return false;
  }
}

}  // namespace durer::interpreter
