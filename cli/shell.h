// Shell commands around a render, and what their exit codes mean (language §9.2).
#pragma once

#include <string>

#include "cli/settings.h"

namespace durer::cli {

/// What the letters behind `%` stand for.
struct ShellNames {
  std::string output;  // %o, with the frame's number
  std::string scene;   // %s, without folder and extension
  int frame = 0;       // %n
  double clock = 0;    // %k
  int width = 0;       // %w
  int height = 0;      // %h
};

/// The command with %o %s %n %k %w %h and %% replaced; other letters stay as they are.
[[nodiscard]] std::string substitute(std::string_view command, const ShellNames& names);

/// What to do after a command of this hook ended with `code`.
[[nodiscard]] Action action_after(const ShellHook& hook, int code);

/// Runs a command in the shell; returns its exit code, 127 if there is none.
[[nodiscard]] int run_shell(const std::string& command);

}  // namespace durer::cli
