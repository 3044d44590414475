// What may cast a shadow into a shaft.
#pragma once

#include <span>
#include <vector>

#include "tracer/accel/box_tree.h"
#include "tracer/accel/shaft.h"
#include "tracer/accel/sheet.h"
#include "tracer/primitives/store.h"

namespace durer::tracer {

/// One object of the hierarchy.
struct Caster {
  const Targets* targets = nullptr;
  std::uint32_t index = 0;
  const Store* lone = nullptr;  // `targets`, if it is a primitive on its own
  Bounds3 box;  // of its surface
};

/// All objects that cast shadows, by their boxes.
class CasterIndex {
 public:
  CasterIndex() = default;
  explicit CasterIndex(std::span<const Targets* const> all);

  /// Those whose boxes meet `shaft`; false if they are more than `most`.
  [[nodiscard]] bool gather(const Shaft& shaft, std::size_t most, std::vector<Caster>& out) const {
    return gather_from(shaft, most, out);
  }
  /// Likewise; without those that hold all of the sheet, away from their surface.
  [[nodiscard]] bool gather(const Sheet& sheet, std::size_t most, std::vector<Caster>& out) const;

 private:
  template <typename Region>
  [[nodiscard]] bool gather_from(const Region& region, std::size_t most,
                                 std::vector<Caster>& out) const {
    out.clear();
    for (const Caster& c : endless_) {
      if (region.meets(c.box)) out.push_back(c);
    }
    boxes_.meeting([&](const Bounds3& b) { return out.size() <= most && region.meets(b); },
                   [&](std::uint32_t box) { out.push_back(of_box_[box]); });
    return out.size() <= most;
  }

  BoxTree boxes_;
  std::vector<Caster> of_box_;
  std::vector<Caster> endless_;
};

}  // namespace durer::tracer
