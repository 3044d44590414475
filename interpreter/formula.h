// Formulas, compiled to code for a small stack machine.
//
// Loops and macros work out the same formula again and again. Such a formula is compiled when it is
// met there: arithmetic on numbers and vectors, built-in functions, strings, user functions, and
// calls of macros that only compute a value, which are compiled in line. Running the code has no
// effect but its result: where anything unusual turns up, such as an undeclared name or a division
// by zero, the machine gives up, and the caller walks the syntax tree instead, which knows every
// rule and every message.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "functions/evaluate.h"
#include "grammar/ast.h"
#include "interpreter/environment.h"

namespace durer::interpreter {

struct FloatFunction;
struct StraightCode;
struct StraightOp;

/// How deep the stack of the machine is, how many names macros in line may have, and how many draws
/// of `rand` can be taken back.
inline constexpr std::size_t formula_stack = 32;
inline constexpr std::size_t formula_locals = 24;
inline constexpr std::size_t formula_draws = 16;

struct FormulaOp {
  enum class Kind : std::uint8_t {
    number,     // value
    axis,       // a unit vector of `count` components: slot `name` is 1
    text,       // text
    variable,   // name
    component,  // name, count: slot
    local,      // count: which
    element,    // name, count: how many subscripts, on the stack
    member,     // count: slot
    vector,     // count: how many components, on the stack
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
    widen,     // the end of parentheses
    choose,    // condition, yes, no
    function,  // name: the word; count: how many arguments
    geometry,  // the same of functions of vectors
    string,    // the same of functions that take or make strings
    rand,
    user_function,  // name, count
    // Macros in line.
    is_macro,   // name still stands for `macro`
    is_free,    // name stands for nothing that a #local could not hide
    exists,     // name has a value
    set_local,  // count: which
  };
  /// How many components the place wants (language §2.4): 1…5, `given` by whom the formula is for,
  /// or `as_slot` + n: as many as the operand n of the stack has, the left side of an operator.
  enum : std::uint8_t { given = 8, as_slot = 16 };

  Kind kind = Kind::number;
  std::uint8_t count = 0;
  std::uint8_t want = 1;
  SymbolId name = 0;
  union {
    double value = 0;
    const Text* text;
    const ast::Macro* macro;
    const FloatFunction* function;
  };
};

struct Formula {
  std::vector<FormulaOp> ops;  // empty: there is no code for it
  std::deque<Text> texts;      // literals
  std::uint32_t calls = 0;     // of macros in line, for the limits
  bool calls_functions = false;
  /// It begins with a component, `V.x`: the slots behind a result of one component hold what they
  /// held in the vector, and a place that wants more sees them (language §2.4).
  bool shines_through = false;
  /// How often the machine had to give up; after a few times it is not tried any more.
  std::uint8_t failures = 0;
  /// The same for the kinds of operands that it meets; made anew a few times if they change.
  std::shared_ptr<const StraightCode> straight;
  std::uint8_t straightened = 0;  // how often it was made
  int straight_wanted = 0;        // for a place that wants so many components
};

/// What is known when a formula is compiled.
struct FormulaContext {
  const Environment& env;
  double clock = 0;
  bool macros = true;  // compile them in line
};

/// Code for an expression; empty ops if it holds anything that the machine does not know.
[[nodiscard]] Formula compile_formula(const FormulaContext& context, const ast::Tree& tree,
                                      ast::ExprId id);

/// A number of `length` components, or a string. Slots beyond the length hold nothing, unless the
/// formula shines through.
struct Operand {
  std::array<double, 5> v;  // NOLINT: set with length
  int length;               // 0: a string
  const Text* string;

  [[nodiscard]] bool is_float() const { return length == 1; }
  [[nodiscard]] bool is_text() const { return length == 0; }
  [[nodiscard]] Num number() const {
    Num n;
    n.v = v;
    n.length = length;
    return n;
  }
};

/// One number drawn from a random stream: how the stream was before.
struct Draw {
  std::size_t stream;
  std::uint32_t before;
};

class FormulaMachine {
 public:
  FormulaMachine(const Environment& env, std::vector<std::uint32_t>& streams,
                 functions::Workspace& workspace)
      : env_(env), streams_(streams), workspace_(workspace) {}

  /// The result, valid until the next run, with nothing behind its length unless it shines through;
  /// null, with no effect, if the tree must be walked.
  /// `wanted`: how many components the place wants; 1 also means "any".
  [[nodiscard]] const Operand* run(Formula& formula, int wanted) {
    drawn_ = 0;
    const bool straight = formula.straight != nullptr && formula.straight_wanted == wanted;
    if (straight && run_straight(*formula.straight)) return stack_.data();
    if (formula.straight == nullptr && formula.straightened == straightened_enough &&
        !formula.ops.empty()) {
      return run_general(formula, wanted);
    }
    return run_unsettled(formula, wanted, straight);
  }
  /// Takes the text of the last result, if it was a string.
  void take_text(Text& out);
  /// What the last run drew, in order.
  void tell_draws(std::vector<Draw>& out) const {
    if (drawn_ == 0) return;
    out.insert(out.end(), draws_.begin(), draws_.begin() + static_cast<std::ptrdiff_t>(drawn_));
  }

 private:
  /// After so many times no straight code is made any more.
  static constexpr std::uint8_t straightened_enough = 4;

  const Operand* run_general(const Formula& formula, int wanted);
  const Operand* run_unsettled(Formula& formula, int wanted, bool failed);
  bool run_straight(const StraightCode& code);
  bool run_operations(const StraightCode& code);
  bool load_element(const StraightOp& op, double* first) const;
  bool draw_number(double& stream);
  void take_draws_back();
  bool execute(const Formula& formula, int wanted);
  void clear_beyond_length() {
    Operand& result = stack_[0];
    for (auto i = static_cast<std::size_t>(result.length); i < 5; ++i) result.v[i] = 0;
  }
  bool apply(FormulaOp::Kind kind, Operand& left, Operand& right, int wanted);
  bool element(const FormulaOp& op, Operand* first, int wanted) const;
  bool call_string(const FormulaOp& op, Operand* first, int wanted);
  bool call_user(const FormulaOp& op, Operand* first, int wanted);
  [[nodiscard]] Text& buffer(const Operand* operand) {
    return buffers_[static_cast<std::size_t>(operand - stack_.data())];
  }
  Text& own_text(Operand& operand);

  const Environment& env_;
  std::vector<std::uint32_t>& streams_;
  functions::Workspace& workspace_;
  std::array<Operand, formula_stack> stack_{};
  std::array<Operand, formula_locals> locals_{};
  std::array<Text, formula_stack> buffers_;  // of results that are strings, by place on the stack
  std::array<Text, formula_locals> local_texts_;
  // Straight code: the components of all operands, one after the other.
  std::array<double, formula_stack * 5> lanes_{};
  std::array<std::array<double, 5>, formula_locals> local_lanes_{};
  std::array<Draw, formula_draws> draws_{};
  std::size_t drawn_ = 0;
};

}  // namespace durer::interpreter
