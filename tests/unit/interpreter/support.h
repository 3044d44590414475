// Runs small scenes against a fake registry of three primitives and three patterns.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "interpreter/interpret.h"
#include "scene/scene.h"

namespace durer::interpreter::test {

struct Run {
  std::string debug;                  // what #debug printed
  std::optional<scene::Scene> scene;  // empty after an error
  std::vector<std::string> errors;    // "D0203 at 2:8: `A` is not declared"
  std::vector<std::string> warnings;
  std::vector<std::string> help;  // of all errors
  std::vector<std::string> labels;
};

/// Interprets `text` (after `#version 3.7; global_settings{assumed_gamma 1}` if `header`) as the
/// contents of the file `path`.
Run run(const std::string& text, bool header = true, Options options = {},
        const std::string& path = "test.pov");

/// Everything that can be seen of a run, as text: the scene with its places, what was printed, all
/// messages and how their places were reached.
std::string seen(const std::string& text, bool shortcuts);

/// What `#debug` prints for a string expression.
std::string text_of(const std::string& expression, const std::string& before = {});
/// What `str(expression, 0, decimals)` gives.
std::string value_of(const std::string& expression, const std::string& before = {},
                     int decimals = 6);
/// The same for `n` components of a vector, separated by blanks.
std::string vector_of(const std::string& expression, int n = 3, const std::string& before = {},
                      int decimals = 4);
/// The first error, or "no error".
std::string error_of(const std::string& text);

}  // namespace durer::interpreter::test
