// Answers what the language asks of an object while a scene is interpreted. Public.
#pragma once

#include <memory>
#include <unordered_map>

#include "scene/object_queries.h"
#include "tracer/geometry.h"

namespace durer::tracer {

/// Keeps the geometry of every object that was asked, so that a scene may probe one object a
/// million times. Objects are immutable, so an answer never goes stale.
class Inspector final : public scene::ObjectQueries {
 public:
  std::optional<Trace> trace(const scene::Scene& scene, scene::ObjectId id, dvec3 origin,
                             dvec3 direction) override;
  std::optional<bool> inside(const scene::Scene& scene, scene::ObjectId id, dvec3 point) override;
  Bounds3 extent(const scene::Scene& scene, scene::ObjectId id) override;
  std::optional<std::string> unsupported(const scene::Scene& scene, scene::ObjectId id) override;

 private:
  struct Probe {
    std::unique_ptr<Geometry> geometry;
    GeometryScratchPtr scratch;
    std::vector<std::uint32_t> bodies;
    bool patch = false;
  };
  Probe& probe(const scene::Scene& scene, scene::ObjectId id);

  std::unordered_map<scene::ObjectId, Probe> probes_;
};

}  // namespace durer::tracer
