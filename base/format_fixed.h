// Numbers with a fixed count of decimals, as C's printf writes them.
#pragma once

#include <string_view>

namespace durer {

/// Room that `format_fixed` may need.
inline constexpr int format_fixed_size = 640;

/// What printf makes of `%.*f`: the exact binary value, rounded half to even. `places` is 0 to 254,
/// `value` finite. Writes into `buffer`, without a terminating zero.
[[nodiscard]] std::string_view format_fixed(double value, int places,
                                            char (&buffer)[format_fixed_size]);

}  // namespace durer
