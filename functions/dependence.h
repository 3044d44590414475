// Which instructions of a tape depend on which parameter. Private to this folder.
#pragma once

#include "functions/tape.h"

namespace durer::functions {

/// The tape without the instructions whose results stay if only the parameters in `changed` change
/// (bit i: parameter i), and of waves only those that do not. A tape with branches or loops is kept
/// as a whole.
[[nodiscard]] Function depending_on(const Function& f, unsigned changed);
/// The whole tape with its waves one by one, as they are in parts of it.
[[nodiscard]] Function with_single_waves(const Function& f);

}  // namespace durer::functions
