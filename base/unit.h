// Many vectors to unit length.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <span>

#include "base/vec.h"

namespace durer {

/// glm::normalize of each, to the last bit; roots and divisions do not wait for each other.
inline void normalize_all(std::span<dvec3> vectors) {
  constexpr std::size_t most = 16;
  while (!vectors.empty()) {
    const auto some = vectors.first(vectors.size() < most ? vectors.size() : most);
    std::array<double, most> scale;
    for (std::size_t i = 0; i < some.size(); ++i) scale[i] = glm::dot(some[i], some[i]);
    for (std::size_t i = 0; i < some.size(); ++i) scale[i] = 1 / std::sqrt(scale[i]);
    for (std::size_t i = 0; i < some.size(); ++i) some[i] *= scale[i];
    vectors = vectors.subspan(some.size());
  }
}

}  // namespace durer
