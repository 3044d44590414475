#include "tracer/patterns/function_pattern.h"

namespace durer::tracer::patterns {

extern constinit const PatternType function_pattern =
    describe_pattern<FunctionPattern>("function", "The value of a function of x, y and z.",
                                      {.default_map = black_to_white, .takes_function = true});

}  // namespace durer::tracer::patterns
