// argv → settings.
#pragma once

#include <string>
#include <vector>

#include "cli/reader.h"

namespace durer::cli {

/// What the command line asks for instead of a render.
enum class Request : std::uint8_t { render, help, help_markdown, version, stdlib_path };

/// Where the first bare word stands, which names a command if there is one of that name; the number
/// of words if all are options.
[[nodiscard]] std::size_t first_bare_word(const std::vector<std::string>& words);

/// Applies the words of the command line (without the program's name) in their order: switches,
/// `Keyword=value`, bare words and GNU options. What is wrong is reported.
[[nodiscard]] Request read_command_line(const std::vector<std::string>& words, Reader& reader);

}  // namespace durer::cli
