// SIGINT and SIGTERM, and other reasons to stop.
#pragma once

#include <atomic>
#include <string>

namespace durer::cli {

/// From here on the signals end the program at once, with the exit code of an interruption, after
/// running `command` in the shell (empty: none). This is for phases that write no picture.
void interrupts_end_program(const std::string& command = {});

/// From here on they only set the flag returned; the second one kills. A render watches the flag,
/// and others may set it too.
[[nodiscard]] std::atomic<bool>& interrupts_set_flag();

}  // namespace durer::cli
