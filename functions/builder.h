// Builds compiled functions, with the rewriting that decides their last bits (language §6.3).
#pragma once

#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "base/transform.h"
#include "functions/spline.h"
#include "functions/tape.h"

namespace durer::functions {

/// Why a function cannot be built. The builder goes on with a harmless value.
enum class BuildProblem {
  division_by_zero,       // of a variable by a constant written without parentheses
  constant_zeroth_power,  // pow(x, 0): a warning; the value is 1
  too_deep,               // calls or nested select, sum, prod
  too_large,              // instructions
  wrong_argument_count,
  no_such_internal,
};

/// A member of a vector-valued call (language §6.2).
enum class Member { x, y, z, t, u, v, red, green, blue, filter, transmit, gray, hf };

/// A value inside a function under construction.
struct Value {
  Register index = 0;
  /// How it was written, which some rewriting depends on: a single number, numbers with operators
  /// (which hold a sum in calls only), or a sum that ends in either. Parentheses take that away: see
  /// FunctionBuilder::group.
  enum class Form : std::uint8_t { other, literal, product, open_sum };
  Form form = Form::other;

  [[nodiscard]] bool is_plain_constant() const {
    return form == Form::literal || form == Form::product;
  }
};

/// Usage: make values from parameters and constants with op() and its kin, then finish() with the
/// result. Equal subexpressions become one value; what the result does not need is dropped.
class FunctionBuilder {
 public:
  explicit FunctionBuilder(int parameters);

  [[nodiscard]] Value parameter(int index) const;
  /// A number, `pi`, `clock` or a captured variable.
  [[nodiscard]] Value constant(double value);
  /// The value as the content of parentheses.
  [[nodiscard]] static Value group(Value v) { return {v.index, Value::Form::other}; }

  /// A plain operation, folded and rewritten as the language does it. `operands` match its arity.
  [[nodiscard]] Value op(Op op, std::span<const Value> operands);
  [[nodiscard]] Value op(Op op, Value a);
  [[nodiscard]] Value op(Op op, Value a, Value b);
  /// degrees() and radians(): one multiplication.
  [[nodiscard]] Value degrees(Value a);
  [[nodiscard]] Value radians(Value a);

  /// Between these two calls operands belong to the second or a later argument of some call, where
  /// less is rewritten. Sides of select() and bodies of loops are known to be such.
  void enter_later_argument() { ++later_arguments_; }
  void leave_later_argument() { --later_arguments_; }

  /// Calls; the number of arguments must match. Results are the components.
  [[nodiscard]] std::vector<Value> call(const FunctionRef& f, std::span<const Value> arguments);
  [[nodiscard]] std::vector<Value> external(const External& e, std::span<const Value> arguments);
  [[nodiscard]] Value internal(int number, std::span<const Value> arguments);
  /// A member of a vector-valued call. Slots beyond the components are 0.
  [[nodiscard]] Value member(std::span<const Value> components, Member m);

  /// select(condition, negative, zero_or_more) or select(condition, negative, zero, positive):
  /// select_begin, then the values of two or three sides, each closed by select_next, and
  /// select_end.
  void select_begin(Value condition);
  void select_next(Value side);
  [[nodiscard]] Value select_end();

  /// sum(i, from, to, body) and prod(...): the result of loop_begin is the counter.
  [[nodiscard]] Value loop_begin(bool product, Value from, Value to);
  [[nodiscard]] Value loop_end(Value body);

  /// The first problem since the last call of this, if any.
  [[nodiscard]] std::optional<BuildProblem> take_problem() { return std::exchange(problem_, {}); }

  /// The function, with dead code removed and registers numbered densely.
  [[nodiscard]] Function finish(std::span<const Value> results);
  [[nodiscard]] Function finish(Value result) { return finish({&result, 1}); }

 private:
  /// What makes two computations the same.
  struct Key {
    Op op;
    std::uint32_t callee;  // internal: its number; call, external: its index
    std::vector<Register> operands;
    auto operator<=>(const Key&) const = default;
  };
  /// A sum or difference of a value and a constant.
  struct OpenSum {
    Register base;
    double constant;
    bool subtracted;
  };
  /// A select() or loop under construction.
  struct OpenBlock {
    std::uint32_t instruction;
    std::vector<Branch> sides;
    std::uint32_t side_begin;
    std::size_t known;  // length of the trail when the side began
  };

  // rewrite.cpp
  [[nodiscard]] std::optional<double> constant_of(Value v) const;
  [[nodiscard]] std::optional<Value> folded(Op op, std::span<const Value> operands);
  [[nodiscard]] std::optional<Value> rewritten(Op op, Value a, Value b);
  [[nodiscard]] Value sum_with_constant(Value a, Value c_value, double c, bool minus);
  [[nodiscard]] Value quotient_by_constant(Value a, Value divisor, double c);
  [[nodiscard]] std::optional<Value> constant_power(Value base, double exponent);
  [[nodiscard]] bool in_later_argument() const { return later_arguments_ > 0 || !blocks_.empty(); }

  // builder.cpp
  [[nodiscard]] Value emit(Op op, std::span<const Value> operands);
  [[nodiscard]] Register emit_instruction(Key key, std::uint16_t count, std::uint32_t results);
  [[nodiscard]] std::vector<Value> emit_call(Op op, std::uint32_t callee, int components,
                                             std::span<const Value> arguments);
  [[nodiscard]] std::vector<Value> inlined(const Function& f, std::span<const Value> arguments);
  [[nodiscard]] std::uint32_t add_callee(const FunctionRef& f);
  [[nodiscard]] std::uint32_t add_external(const External& e);
  [[nodiscard]] Value open_block(Op op, std::uint32_t index);
  void close_side(Value result);
  void report(BuildProblem p);

  Function f_;
  Register next_ = 0;                            // first unused register
  std::map<std::uint64_t, Register> constants_;  // by bits
  std::map<Register, double> constant_values_;   // the reverse
  std::map<Register, OpenSum> open_sums_;        // sums that may still grow
  std::map<Key, Register> known_;                // equal subexpressions
  std::vector<Key> trail_;  // `known_` in order, to forget what a finished side computed
  std::vector<OpenBlock> blocks_;
  int later_arguments_ = 0;
  std::optional<BuildProblem> problem_;
};

/// A whole function that is one internal function, taking 3 + extra parameters.
[[nodiscard]] Function make_internal_function(int number);
/// A whole function from outside, e.g. a pattern or pigment.
[[nodiscard]] Function make_external_function(const External& external);
/// The image of a point under an affine map: three components.
[[nodiscard]] Function make_transform_function(const Affine& map);
/// A spline of one parameter; `dimension` components.
[[nodiscard]] Function make_spline_function(std::shared_ptr<const Spline> spline);

}  // namespace durer::functions
