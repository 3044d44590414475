// Contents that are kept once and placed many times.
#pragma once

#include <cstdint>
#include <vector>

#include "base/transform.h"
#include "tracer/accel/accel.h"

namespace durer::tracer {

/// One copy of shared contents. "Outer" is the space and the numbering of whatever holds it: the
/// world, or other shared contents.
struct Placement {
  Transform to_outer;
  std::uint32_t group = 0;    // index of the contents
  std::uint32_t surface = 0;  // textures that the contents receive from outside; they lie outside
  std::uint32_t interior = 0;        // the outer number of interior 0 of the contents …
  std::uint32_t first_interior = 0;  // … and, plus its own number, that of any other
  std::uint32_t gate = 0xFFFFFFFF;   // bounds of all of it, in the outer space

  /// The outer number of an interior of the contents.
  [[nodiscard]] std::uint32_t outer_interior(std::uint32_t inner) const {
    return inner == 0 ? interior : first_interior + inner;
  }
};

/// The placements in one space, as objects of its hierarchy.
class PlacementTargets final : public Targets {
 public:
  struct Contents {
    const Accel* accel = nullptr;
    Bounds3 surface;
    std::uint8_t mask = 0;
  };

  PlacementTargets(const std::vector<Placement>& all, const std::vector<Contents>& contents);

  /// Adds number `placement` of all. `gated`: a ray must pass its gate.
  void add(std::uint32_t placement, bool gated);
  /// Gathers the visibility of the contents into the tags.
  void update_masks();
  [[nodiscard]] Bounds3 surface_bounds(std::uint32_t index) const override;

 private:
  static void nearest_of(const Targets& targets, std::uint32_t index, RayQuery& query);

  const std::vector<Placement>* all_;
  const std::vector<Contents>* contents_;
  std::vector<std::uint32_t> ids_;
};

}  // namespace durer::tracer
