// What `function { … }` declares.
#pragma once

#include "base/source.h"
#include "functions/tape.h"

namespace durer::interpreter {

/// Immutable; copies of a function share it.
struct UserFunction {
  functions::FunctionRef tape;
  /// Its value has components: other functions must pick one, scene expressions get them all.
  bool is_vector = false;
  Span declared;  // the word `function`

  /// More than any function has use for; arguments of calls wait on the machine stack.
  static constexpr std::size_t max_parameters = 64;
};

}  // namespace durer::interpreter
