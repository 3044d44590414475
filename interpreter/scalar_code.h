// Formulas on floats, compiled to code for a small stack machine.
//
// Loops work out the same formula again and again, and nearly always on floats. Such a formula is
// compiled when it is met in a loop or macro. Running the code has no effect but its result: where
// anything unusual turns up, such as a vector, an undeclared name, a division by zero, it gives up,
// and the caller walks the syntax tree instead, which knows every rule and every message.
#pragma once

#include <cstdint>
#include <vector>

#include "grammar/ast.h"
#include "interpreter/environment.h"

namespace durer::interpreter {

struct ScalarOp {
  enum class Kind : std::uint8_t {
    number,
    variable,   // name
    component,  // name, detail: slot
    element,    // name, detail: how many subscripts, on the stack
    add,
    sub,
    mul,
    div,
    lt,
    le,
    eq,
    ne,
    ge,
    gt,
    and_,
    or_,
    neg,
    not_,
    function,  // name: the word; detail: how many arguments
    rand,
  };
  Kind kind = Kind::number;
  std::uint8_t detail = 0;
  SymbolId name = 0;
  double value = 0;
};

struct ScalarCode {
  std::vector<ScalarOp> ops;
  /// The formula begins with a component: where several are wanted, the others shine through
  /// (language §2.4), which this machine does not know.
  bool leads_with_component = false;
  /// How often it had to give up; after a few times it is not tried any more.
  std::uint8_t failures = 0;
};

/// How deep the stack of the machine is, and how many draws of `rand` it can take back.
inline constexpr std::size_t scalar_stack = 32;
inline constexpr std::size_t max_draws = 8;

/// Code for an expression; empty ops if it holds anything but plain arithmetic. `clock` is the
/// value of the word.
[[nodiscard]] ScalarCode compile_scalar(const ast::Tree& tree, ast::ExprId id, double clock);

/// Runs the code; false, with no effect, if the tree must be walked. `streams` are those of `rand`.
[[nodiscard]] bool run_scalar(const ScalarCode& code, const Environment& env,
                              std::vector<std::uint32_t>& streams, double& result);

}  // namespace durer::interpreter
