#pragma once

#include <span>

#include "scene/type_info.h"

namespace durer::tracer {

struct PrimitiveType;

/// All primitives in the order of primitives.def; scene::Object::type is an index into this.
[[nodiscard]] std::span<const PrimitiveType* const> primitive_types();
/// The same, as the language sees them.
[[nodiscard]] std::span<const scene::TypeInfo* const> primitive_infos();

}  // namespace durer::tracer
