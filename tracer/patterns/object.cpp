#include "tracer/patterns/function_pattern.h"

namespace durer::tracer::patterns {
namespace {

// 1 inside of an object, 0 outside (textures §8.3): the interpreter makes a function of it.
constexpr std::array default_list{entry(0, 0, 0, 1), entry(1, 0, 1, 0)};

}  // namespace

extern constinit const PatternType object_pattern = describe_pattern<FunctionPattern>(
    "object", "Outside and inside of an object.",
    {.list_size = 2, .default_map = default_list, .takes_object = true});

}  // namespace durer::tracer::patterns
