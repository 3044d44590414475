// Reading a scene recurses: into blocks, parentheses, macro calls inside expressions. That happens
// on a stack of its own, so that what is legal never overflows it and what is too deep is an error.
#pragma once

#include <functional>

namespace durer::interpreter {

/// Runs `work` on a large stack, in this thread: a second thread would make every shared pointer of
/// the interpreter count atomically. Exceptions pass through.
void on_deep_stack(const std::function<void()>& work);

/// True when the stack of on_deep_stack is nearly used up.
[[nodiscard]] bool stack_is_low();

}  // namespace durer::interpreter
