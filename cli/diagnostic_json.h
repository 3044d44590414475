// Messages for programs: one JSON object a line.
#pragma once

#include <string>
#include <string_view>

#include "base/diagnostic.h"

namespace durer::cli {

/// {"kind": "diagnostic", "severity", "code", "message", "file", "line", "column", "end", "at",
/// "labels", "help", "trace"} and a line break. Lines and columns count from 1, columns in bytes;
/// "end" is the place behind the last byte; what is empty or has no place is left out.
[[nodiscard]] std::string diagnostic_json(const Diagnostic& d, const SourceMap& sources);

/// {"kind": "message", "stream": "debug", "text": …} and a line break.
[[nodiscard]] std::string message_json(std::string_view stream, std::string_view text);

}  // namespace durer::cli
