#include "tracer/patterns/patterns.h"

namespace durer::tracer {

namespace patterns {
#define DURER_ENTRY(name) extern const PatternType name##_pattern;
#include "tracer/patterns/patterns.def"
#undef DURER_ENTRY
}  // namespace patterns

namespace {

constexpr std::array types{
#define DURER_ENTRY(name) &patterns::name##_pattern,
#include "tracer/patterns/patterns.def"
#undef DURER_ENTRY
};

constexpr std::array<const scene::PatternInfo*, types.size()> infos{
#define DURER_ENTRY(name) &patterns::name##_pattern,
#include "tracer/patterns/patterns.def"
#undef DURER_ENTRY
};

}  // namespace

std::span<const PatternType* const> pattern_types() { return types; }
std::span<const scene::PatternInfo* const> pattern_infos() { return infos; }

}  // namespace durer::tracer
