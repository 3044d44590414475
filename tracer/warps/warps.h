#pragma once

#include "tracer/warps/warp_type.h"

namespace durer::tracer {

/// All warps, in the order of warps.def.
[[nodiscard]] std::span<const WarpType* const> warp_types();
/// The same, as the language sees them.
[[nodiscard]] std::span<const scene::TypeInfo* const> warp_infos();

}  // namespace durer::tracer
