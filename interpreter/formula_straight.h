// Straight code: a formula for operands of known kinds.
//
// How many components an operator works on depends on what the variables hold, and the machine of
// formula.h finds that out at every step. But variables seldom change their kind. So the lengths are
// settled once, for what the variables hold now, and the code only checks that they still do. What
// is left are plain operations on doubles, which lie on the stack without gaps: three floats are a
// vector. Where a check fails, the formula is run the general way.
#pragma once

#include "interpreter/formula.h"

namespace durer::interpreter {

struct StraightOp {
  enum class Kind : std::uint8_t {
    number,     // value
    load,       // name: a float
    load_many,  // name: a number of n components
    component,  // name: a number of n components, of which number m
    local,      // m: which, of n components
    element,    // name, m subscripts: a number of n components
    repeat,     // a float becomes n components
    add,        // of two floats
    sub,
    mul,
    add_number,  // of a float and the value
    sub_number,
    mul_number,
    div_number,  // not 0
    scalar,      // with: any operator of two floats
    scalar_number,
    lanes,      // with: of a number of n and one of m components; one of them is a float
    neg,
    not_,
    member,  // number m of n components
    choose,  // a condition and two numbers of n components
    function,  // of m floats
    vlength,   // of n components
    vdot,      // of n and m components
    vcross,
    rand,
    user_function,  // name, m arguments
    is_macro,       // guards, as in FormulaOp
    is_free,
    exists,
    set_local,  // m: which, of n components
  };
  Kind kind = Kind::number;
  std::uint8_t n = 1;
  std::uint8_t m = 1;
  FormulaOp::Kind with = FormulaOp::Kind::add;
  SymbolId name = 0;
  union {
    double value = 0;
    const ast::Macro* macro;
    const FloatFunction* function;
  };
};

struct StraightCode {
  std::vector<StraightOp> ops;
  int length = 1;  // of the result
};

/// Code for what the variables hold now; null if the formula handles strings, or anything else that
/// lengths do not settle.
[[nodiscard]] std::shared_ptr<const StraightCode> straighten(const Formula& formula,
                                                             const Environment& env, int wanted);

}  // namespace durer::interpreter
