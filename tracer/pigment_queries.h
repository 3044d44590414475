// Patterns and pigments as functions of the language. Public.
#pragma once

#include <memory>

#include "scene/pigment_queries.h"

namespace durer::tracer {

[[nodiscard]] std::unique_ptr<scene::PigmentQueries> make_pigment_queries();

}  // namespace durer::tracer
