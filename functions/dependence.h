// Which instructions of a tape depend on which parameter. Private to this folder.
#pragma once

#include "functions/tape.h"

namespace durer::functions {

/// The tape without the instructions whose results stay if only the parameters in `changed` change
/// (bit i: parameter i), and of waves only pairs that do not. A tape with branches or loops is kept
/// as a whole.
[[nodiscard]] Function depending_on(const Function& f, unsigned changed);
/// The whole tape with waves that do not depend on their neighbours. Not for one with branches that
/// hold waves; none does.
[[nodiscard]] Function with_single_waves(const Function& f);

/// The same on registers further behind: what `part` computes, and the parameters in `changed`, move
/// by `distance`, at least the number of its registers; everything else is read where it was.
[[nodiscard]] Function moved(Function part, unsigned changed, Register distance);

}  // namespace durer::functions
