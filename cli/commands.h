// What the program can be told to do. Each takes the words behind the program's (and the command's)
// name and returns the exit code.
#pragma once

#include <string>
#include <vector>

namespace durer::cli {

namespace exit_code {
inline constexpr int ok = 0;
inline constexpr int error = 1;
inline constexpr int interrupted = 2;
}  // namespace exit_code

[[nodiscard]] int render_command(const std::vector<std::string>& words);
/// `durer parse FILE…`: says nothing and returns 0 if all files follow the grammar.
[[nodiscard]] int parse_command(const std::vector<std::string>& words);
/// `durer check [options] FILE…`: reads scenes without rendering them; returns 0 if all are good.
[[nodiscard]] int check_command(const std::vector<std::string>& words);

/// `durer doc NAME…`: what names mean; returns 0 if all are known.
[[nodiscard]] int doc_command(const std::vector<std::string>& words);

}  // namespace durer::cli
