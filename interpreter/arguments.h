// The arguments of a call of a built-in function, read one by one in textual order, because `rand`
// and macro calls have effects.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

#include "interpreter/interpreter.h"

namespace durer::interpreter {

/// C's conversion of an out-of-range double, as the oracle's machine does it.
inline std::int32_t to_int(double v) {
  if (!(v > -2147483649.0 && v < 2147483648.0)) return INT32_MIN;
  return static_cast<std::int32_t>(v);
}

/// fmod; at once for the whole numbers that programs count with.
inline double modulo(double a, double b) {
  if (a >= 1 && a < 2147483648.0 && b >= 1 && b < 2147483648.0) {
    const auto dividend = static_cast<std::uint32_t>(a);
    const auto divisor = static_cast<std::uint32_t>(b);
    if (dividend == a && divisor == b) return dividend % divisor;
  }
  return std::fmod(a, b);
}

inline constexpr double radians_per_degree = 0.0174532925199432957692;

/// The next number of a random stream, 0…1 (language §3.4).
inline double draw(std::uint32_t& state) {
  state = state * 1812433253U + 12345U;
  return state / 4294967295.0;
}

/// The arguments of one call, whether they are plain expressions or have to be read item by item.
class Interpreter::Args {
 public:
  Args(Interpreter& in, const ast::Tree& tree, const ast::Expr& call, SymbolId function,
       std::span<const ast::ExprId> list, const ast::OpenGroup* open)
      : in_(in), tree_(tree), call_(call), function_(function), list_(list) {
    if (open != nullptr) part_.emplace(in, tree, open->items, call.span);
  }

  [[nodiscard]] bool more() {
    return part_ ? in_.peek().kind != Token::Kind::end : used_ < list_.size();
  }
  Num num(int length) {
    require("a number or vector");
    if (part_) {
      in_.last_span_ = in_.peek().span;
      const Num n = in_.read_num(length);
      in_.argument_comma();
      return in_.fit(n, length);
    }
    in_.last_span_ = tree_.exprs[list_[used_]].span;
    return in_.fit(in_.evaluate(tree_, list_[used_++], length), length);
  }
  /// Any length: a float stays a float.
  Num any() {
    require("a number or vector");
    if (part_) {
      const Num n = in_.read_num(1);
      in_.argument_comma();
      return n;
    }
    return in_.evaluate(tree_, list_[used_++], 1);
  }
  /// Full level: `sin(a < b)` is legal.
  double full() {
    require("a number");
    if (part_) {
      in_.last_span_ = in_.peek().span;
      const Num n = in_.fit(in_.read_full(1), 1);
      in_.argument_comma();
      return n.v[0];
    }
    return in_.work_out_float(tree_, list_[used_++], "argument");
  }
  double number() {
    if (part_) return num(1).v[0];
    require("a number");
    return in_.work_out_float(tree_, list_[used_++], "argument");
  }
  dvec3 vector() { return num(3).vec(); }
  std::int32_t integer() { return to_int(number()); }
  Text text() {
    Text t;
    text(t);
    return t;
  }
  /// Appends the next argument to `out`.
  void text(Text& out) {
    require("a string");
    if (part_) {
      out.append(in_.read_text());
      in_.argument_comma();
      return;
    }
    in_.append_text(tree_, list_[used_++], out);
  }
  /// The expression itself, for arguments that are names.
  ast::ExprId expression() {
    require("a name");
    if (part_) {
      const Token t = in_.next();
      if (t.kind != Token::Kind::expr) in_.unexpected(t, "a name");
      in_.argument_comma();
      return t.expr;
    }
    return list_[used_++];
  }
  /// Takes a reserved word if one stands here.
  bool skip_word() {
    if (!part_ || in_.peek().kind != Token::Kind::word) return false;
    in_.next();
    return true;
  }
  void done() {
    if (!more()) return;
    in_.fail(Code::unexpected_item, call_.span,
             fmt::format("`{}` has too many arguments here", in_.name_of(function_)));
  }
  [[nodiscard]] Span span() const { return call_.span; }

 private:
  void require(std::string_view what) {
    if (more()) return;
    in_.fail(Code::missing_argument, call_.span,
             fmt::format("`{}` needs {} more here", in_.name_of(function_), what));
  }
  Interpreter& in_;
  const ast::Tree& tree_;
  const ast::Expr& call_;
  SymbolId function_;
  std::span<const ast::ExprId> list_;
  std::size_t used_ = 0;
  std::optional<Nested> part_;
};

}  // namespace durer::interpreter
