#pragma once

#include <cstdint>
#include <vector>

#include "base/source.h"

namespace durer::scene {

/// Where something in the scene was written, and how that place came to be read: the chain of
/// macro calls and includes. Index 0 of the table is "nowhere".
struct Origin {
  Span span;
  std::uint32_t parent = 0;
};
using OriginId = std::uint32_t;

}  // namespace durer::scene
