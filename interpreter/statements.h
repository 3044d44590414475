// Statements of loops and macros, prepared: what has been met once at the level of objects is met
// again with its formulas compiled and its names settled.
//
// A prepared statement runs on the frames of the stream, which stand where they would stand had the
// statement been pulled. So it may give up before it has had any effect, and the general way goes on
// at that very item: with the same result, the same messages, the same chain of calls.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/vec.h"
#include "grammar/ast.h"
#include "interpreter/colour_form.h"
#include "interpreter/formula.h"
#include "scene/type_info.h"

namespace durer::interpreter {

/// `Name(…)` where the name stands for a macro.
struct CallPlan {
  struct Argument {
    enum class Kind : std::uint8_t { general, reference, formula };
    Kind kind = Kind::general;
    SymbolId name = 0;           // reference: the variable that is handed over
    Formula* formula = nullptr;  // formula: of a number or vector
    ast::ExprId expr = ast::none;
  };
  ast::ExprId call = ast::none;
  SymbolId callee = 0;
  std::vector<Argument> arguments;
};

/// A primitive whose operands are formulas, with transformations, a colour and a constant finish.
struct ObjectPlan {
  struct Operand {
    Formula* formula = nullptr;
    std::uint16_t offset = 0;  // in the operands of the type
    bool scalar = false;       // else a vector
  };
  struct Step {
    SymbolId word = 0;           // translate rotate scale pigment finish
    Span span;                   // of the word; pigment: of the first one in it
    Formula* formula = nullptr;  // none: a finish alone
    bool strict = false;         // pigment: the formula must be a colour
    ColourForm form;             // pigment
    const ast::Item* keyword = nullptr;   // pigment: the word that has the form, for warnings
    const ast::Group* finish = nullptr;   // finish, or the one right behind a pigment
  };
  /// Limits of what is planned: formulas, numbers among the operands of the type.
  static constexpr std::size_t most_values = 12;
  static constexpr std::size_t most_operands = 16;

  std::uint32_t type = 0;
  const scene::TypeInfo* info = nullptr;
  const std::vector<double>* fallback = nullptr;  // operands before any is read
  std::vector<Operand> operands;
  std::vector<Step> steps;
};

/// A #switch over literal numbers.
struct SwitchPlan {
  std::uint32_t directive = 0;
  Formula* value = nullptr;
  std::vector<std::optional<double>> cases;  // none: #else
};

/// The number that the expression is, in parentheses or not; null if it has to be worked out.
[[nodiscard]] inline const double* literal(const ast::Tree& tree, ast::ExprId id) {
  while (const auto* p = std::get_if<ast::Paren>(&tree.exprs[id].node)) id = p->inner;
  const auto* n = std::get_if<ast::Number>(&tree.exprs[id].node);
  return n == nullptr ? nullptr : &n->value;
}

struct Statement {
  enum class Kind : std::uint8_t {
    unknown,    // not met yet
    general,    // to be pulled from the stream
    directive,  // executed as the stream does
    assign,     // #declare or #local of a variable
    choice,     // #switch
    leave,      // #break
    call,
    object,
  };
  Kind kind = Kind::unknown;
  /// How often it gave up; after many times it is not tried any more.
  std::uint8_t failures = 0;
  Formula* formula = nullptr;            // assign
  const ast::Declare* declare = nullptr;  // assign
  std::unique_ptr<SwitchPlan> choice;
  std::unique_ptr<CallPlan> call;
  std::unique_ptr<ObjectPlan> object;
};

}  // namespace durer::interpreter
