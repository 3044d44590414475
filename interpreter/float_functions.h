// The functions of the language that take floats and give one, in one table: compiled formulas call
// them, and what the tree is walked for is told from them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "grammar/vocabulary.h"

namespace durer::interpreter {

struct FloatFunction {
  /// Works the function out for `count` arguments; false if it has no value there.
  using Apply = bool (*)(const double* a, std::size_t count, double& out);

  grammar::SymbolId word = 0;
  std::uint8_t least = 0;  // arguments
  std::uint8_t most = 0;
  Apply apply = nullptr;
};

/// The function of that word; null if there is none.
[[nodiscard]] const FloatFunction* float_function(grammar::SymbolId word);

}  // namespace durer::interpreter
