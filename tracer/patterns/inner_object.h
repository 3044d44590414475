#pragma once

#include <memory>
#include <optional>

#include "tracer/geometry.h"

namespace durer::tracer {

/// An object that a pattern asks whether points are inside, in the space of the pattern.
class InnerObject {
 public:
  InnerObject(const scene::Scene& scene, scene::ObjectId object);

  /// Thread-safe.
  [[nodiscard]] bool contains(dvec3 p) const;

 private:
  std::optional<Geometry> geometry_;
  std::size_t serial_;  // among all that were ever made
};

}  // namespace durer::tracer
