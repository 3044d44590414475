// How the operand of `rgb` and its like is read (language §2.6).
#pragma once

#include "interpreter/environment.h"

namespace durer::interpreter {

struct ColourForm {
  int wanted = 0;  // components; 0: no such word
  bool moves_transmit = false;
  bool is_srgb = false;

  /// How many components the place of the operand has.
  [[nodiscard]] int components() const { return wanted > 0 ? wanted : 5; }
};

/// The form that the word announces; `wanted` is 0 for all other words.
[[nodiscard]] ColourForm colour_form(SymbolId word);

/// The colour that `n` means after a word of that form, as a number of five components.
[[nodiscard]] Num to_colour(const Num& n, const ColourForm& form);

}  // namespace durer::interpreter
