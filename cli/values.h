// Values as people write them on a command line or in an INI file.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/gamma.h"

namespace durer::cli {

/// Letters A–Z count as a–z; nothing else is changed.
[[nodiscard]] std::string lower(std::string_view text);
[[nodiscard]] bool same_word(std::string_view a, std::string_view b);
[[nodiscard]] std::string_view trim(std::string_view text);
/// Without the quotes around it, "…" or '…', if there are any.
[[nodiscard]] std::string_view unquote(std::string_view text);

/// on true yes y 1 / off false no n 0, in any case.
[[nodiscard]] std::optional<bool> parse_bool(std::string_view text);
/// A whole number, nothing after it.
[[nodiscard]] std::optional<int> parse_int(std::string_view text);
/// A finite number in the syntax of C (hexadecimal too), nothing after it.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

struct Size {
  int width = 0;
  int height = 0;
};
/// "800x600".
[[nodiscard]] std::optional<Size> parse_size(std::string_view text);
/// `sRGB` or an exponent greater than 0.
[[nodiscard]] std::optional<GammaCurve> parse_gamma(std::string_view text);

}  // namespace durer::cli
