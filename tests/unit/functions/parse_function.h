// A reader of function bodies for tests and benches, so that they can be written as in a scene.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "functions/builder.h"

namespace durer::functions {

/// Functions and numbers that a body may name.
struct TestScope {
  std::map<std::string, FunctionRef> functions;
  std::map<std::string, double> numbers;
};

/// Compiles `body` (language §6.2) with the parameters named. Throws std::runtime_error on a
/// mistake. Names of internal functions, such as f_torus, are known.
[[nodiscard]] Function parse_function(const std::string& body,
                                      const std::vector<std::string>& parameters = {"x", "y", "z"},
                                      const TestScope& scope = {});
[[nodiscard]] FunctionRef parse_function_ref(const std::string& body,
                                             const std::vector<std::string>& parameters = {"x", "y",
                                                                                           "z"},
                                             const TestScope& scope = {});

}  // namespace durer::functions
