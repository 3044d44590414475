// SIGINT and SIGTERM.
#pragma once

#include <atomic>

namespace durer::cli {

/// Until rendering begins the signals end the program at once, with the exit code of an
/// interruption: nothing has been written yet.
void handle_interrupts();

/// From here on they only set the flag returned; the second one kills.
[[nodiscard]] const std::atomic<bool>& interrupts_set_flag();

}  // namespace durer::cli
