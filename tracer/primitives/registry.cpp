#include "tracer/primitives/registry.h"

#include "tracer/primitives/describe.h"

namespace durer::tracer {

#define DURER_ENTRY(x) extern const PrimitiveType x##_primitive;
#include "tracer/primitives/primitives.def"
#undef DURER_ENTRY

std::span<const PrimitiveType* const> primitive_types() {
  static constexpr const PrimitiveType* table[] = {
#define DURER_ENTRY(x) &x##_primitive,
#include "tracer/primitives/primitives.def"
#undef DURER_ENTRY
  };
  return table;
}

std::span<const scene::TypeInfo* const> primitive_infos() {
  static constexpr const scene::TypeInfo* table[] = {
#define DURER_ENTRY(x) &x##_primitive,
#include "tracer/primitives/primitives.def"
#undef DURER_ENTRY
  };
  return table;
}

}  // namespace durer::tracer
