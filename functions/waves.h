// Sines and cosines of a tape, taken together.
#pragma once

#include "functions/tape.h"

namespace durer::functions {

/// The same function, with all sines and cosines that do not wait for each other in one instruction,
/// `Op::waves`, which takes a fraction of the time. It differs from the C library's by an ulp or two,
/// and is the same on every processor. Tapes with branches or loops stay as they are.
[[nodiscard]] Function with_waves(const Function& f);

}  // namespace durer::functions
