// The 79 functions behind `internal(N)`, which functions.inc gives its names (builtin-functions
// §4).
#pragma once

#include <array>
#include <string_view>

#include "functions/number.h"

namespace durer::functions {

/// One internal function. It takes x, y, z and then `extra` parameters.
struct InternalInfo {
  std::string_view name;
  int extra;
  std::string_view parameters;  // names of the extra ones, for help
};

inline constexpr std::array internal_functions{
#define DURER_INTERNAL(name, extra, parameters) InternalInfo{#name, extra, parameters},
#include "functions/internals.def"
#undef DURER_INTERNAL
};
inline constexpr int max_internal_arguments = 13;

/// Value of function `number` (0..78) with its 3 + extra arguments, for each kind of number.
[[nodiscard]] double internal_value(int number, const double* arguments, const Context& context);
[[nodiscard]] Pack internal_value(int number, const Pack* arguments, const Context& context);
[[nodiscard]] Interval internal_value(int number, const Interval* arguments,
                                      const Context& context);
[[nodiscard]] Dual internal_value(int number, const Dual* arguments, const Context& context);
[[nodiscard]] Trend internal_value(int number, const Trend* arguments, const Context& context);

}  // namespace durer::functions
