// Runs the program itself.
#pragma once

#include <sys/wait.h>

#include <cstdlib>

#include "cli/scene_file.h"
#include "tests/unit/cli/read.h"

namespace durer::cli::test {

inline constexpr const char* scene =
    "#version 3.7; global_settings { assumed_gamma 1 }\n"
    "camera { location -3*z look_at 0 } light_source { <5, 8, -6> 1 }\n"
    "sphere { 0, 1 pigment { rgb 1 } }\n"
    "#debug \"hello\\n\"\n";

struct Run {
  int code = -1;
  std::string out, err;
};

inline Run run(const std::string& arguments) {
  const std::string command = std::string(DURER_PROGRAM) + " " + arguments + " >out 2>err";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file("out").value_or(""),
          read_file("err").value_or("")};
}

inline bool has(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

}  // namespace durer::cli::test
