#include "tracer/warps/warps.h"

namespace durer::tracer {

namespace warps {
#define DURER_ENTRY(name) extern const WarpType name##_warp;
#include "tracer/warps/warps.def"
#undef DURER_ENTRY
}  // namespace warps

namespace {

constexpr std::array types{
#define DURER_ENTRY(name) &warps::name##_warp,
#include "tracer/warps/warps.def"
#undef DURER_ENTRY
};

constexpr std::array<const scene::TypeInfo*, types.size()> infos{
#define DURER_ENTRY(name) &warps::name##_warp,
#include "tracer/warps/warps.def"
#undef DURER_ENTRY
};

}  // namespace

std::span<const WarpType* const> warp_types() { return types; }
std::span<const scene::TypeInfo* const> warp_infos() { return infos; }

}  // namespace durer::tracer
