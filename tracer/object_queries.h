// Answers to what the language asks about objects while a scene is read. Public.
#pragma once

#include <memory>

#include "scene/object_queries.h"

namespace durer::tracer {

/// Answers keep what they have learned about an object: its id must go on meaning the same object.
[[nodiscard]] std::unique_ptr<scene::ObjectQueries> make_object_queries();

}  // namespace durer::tracer
