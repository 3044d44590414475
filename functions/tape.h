// A compiled user function: plain data that four evaluators read (language §6).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "functions/number.h"

namespace durer::functions {

/// What an instruction does: an operation of ops.def, or one of those that follow it.
enum class Op : std::uint16_t {
#define DURER_OP(name, arity, expression, doc) name,
#include "functions/ops.def"
#undef DURER_OP
  internal,  // internal function `count`, arguments in the operand list
  call,      // another compiled function; results go to dst, dst + 1, …
  external,  // a function from outside: pattern, pigment, spline
  select,    // select() whose sides hold instructions
  loop,      // sum() or prod()
  waves,     // sines and cosines of several registers at once: see waves.h
};

/// Name, arity and meaning of the operations that are plain expressions.
struct OpInfo {
  const char* name;
  int arity;
  const char* doc;
};
inline constexpr OpInfo op_table[] = {
#define DURER_OP(name, arity, expression, doc) {#name, arity, doc},
#include "functions/ops.def"
#undef DURER_OP
};
inline constexpr std::size_t plain_op_count = std::size(op_table);

using Register = std::uint32_t;

/// One step. Registers are single-assignment; every instruction comes after those it reads.
struct Instruction {
  Op op = Op::add;
  /// Plain: 0; internal: its number; call, external, waves: number of results.
  std::uint16_t count = 0;
  Register dst = 0;
  /// Plain operations with one or two operands: registers. With more: `a` is the first of their
  /// places in `operands`. internal, call, external: likewise, and `b` is the index of the callee.
  /// select, loop: `b` is the index in `selects` or `loops`.
  /// waves: the sine and the cosine of half as many operands as there are results.
  std::uint32_t a = 0;
  std::uint32_t b = 0;
};

/// A stretch of instructions and the register that holds its result.
struct Branch {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  Register result = 0;
};
/// The sides of select() by the sign of the condition. They follow the instruction in order, and
/// with three arguments zero and positive are the same side.
struct Select {
  Register condition = 0;
  Branch negative, zero, positive;
  bool two_way = false;
};
/// sum() or prod(): the counter runs from, from + 1, … while ≤ to. The body follows the
/// instruction.
struct Loop {
  Register from = 0;
  Register to = 0;
  Register counter = 0;
  Branch body;
  bool product = false;
};

inline constexpr int max_components = 5;

/// A function that comes from outside this library. Arguments in order; `out` has `components`.
/// The functions must be pure and callable from several threads at once.
struct External {
  using Point = void (*)(const void* self, const Context&, const double* arguments, double* out);
  using Batch = void (*)(const void* self, const Context&, const Pack* arguments, Pack* out);
  using Box = void (*)(const void* self, const Context&, const Interval* arguments, Interval* out);
  using Gradient = void (*)(const void* self, const Context&, const Dual* arguments, Dual* out);

  std::string name;  // for messages and dumps
  int arity = 3;
  int components = 1;
  std::shared_ptr<const void> self;  // what the callbacks work on
  Point point = nullptr;             // required
  Batch batch = nullptr;             // else: point by point
  Box box = nullptr;                 // else: unbounded
  Gradient gradient = nullptr;       // else: differences of `point`
};

struct Function;
using FunctionRef = std::shared_ptr<const Function>;

/// Registers 0 … parameters-1 hold the arguments, then come the constants, then what is computed.
struct Function {
  std::uint32_t parameters = 3;
  std::vector<double> constants;
  std::vector<Instruction> code;
  std::vector<Register> operands;
  std::vector<Select> selects;
  std::vector<Loop> loops;
  std::vector<FunctionRef> callees;
  std::vector<External> externals;
  std::vector<Register> results;  // one per component
  std::uint32_t registers = 0;    // in all
  std::uint32_t depth = 1;        // of calls, itself included

  [[nodiscard]] int components() const { return static_cast<int>(results.size()); }
};

/// The tape as text, one instruction per line, for tests and for people who debug scenes.
[[nodiscard]] std::string dump(const Function& function);

}  // namespace durer::functions
