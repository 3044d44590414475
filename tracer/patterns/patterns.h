#pragma once

#include <span>

#include "tracer/patterns/pattern_type.h"

namespace durer::tracer {

/// All patterns, in the order of patterns.def.
[[nodiscard]] std::span<const PatternType* const> pattern_types();
/// The same, as the language sees them.
[[nodiscard]] std::span<const scene::PatternInfo* const> pattern_infos();

}  // namespace durer::tracer
