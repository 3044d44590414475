#pragma once

#include "tracer/csg/parts.h"

namespace durer::tracer {

/// The solids that stand in the scene, as objects of the hierarchy: target i is the solid
/// `solids[i]` of the parts that a query brings along.
class SolidTargets final : public Targets {
 public:
  explicit SolidTargets(const Parts& parts);

  void add(std::uint32_t solid);
  /// Gathers the visibility of the leaves into the tags of the solids.
  void update_masks();
  [[nodiscard]] Bounds3 surface_bounds(std::uint32_t index) const override;

 private:
  static void nearest_of(const Targets& targets, std::uint32_t index, RayQuery& query);

  const Parts* parts_;
  std::vector<std::uint32_t> solids_;
};

}  // namespace durer::tracer
