// Which instructions of a tape depend on which parameter. Private to this folder.
#pragma once

#include "functions/tape.h"

namespace durer::functions {

/// The tape without the instructions whose results stay if only the parameters in `changed` change
/// (bit i: parameter i), and of waves only the pairs that do not. A tape with branches or loops is
/// kept as a whole.
[[nodiscard]] Function depending_on(const Function& f, unsigned changed);
/// Likewise, or the whole tape, with waves one by one: ranges of angles do not depend on partners.
[[nodiscard]] Function with_single_waves(const Function& f, unsigned changed);
[[nodiscard]] Function with_single_waves(const Function& f);

/// The same on registers further behind: what `part` computes, and the parameters in `changed`, move
/// by `distance`, at least the number of its registers; everything else is read where it was.
[[nodiscard]] Function moved(Function part, unsigned changed, Register distance);

}  // namespace durer::functions
