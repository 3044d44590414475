// Which parts of the forest are worth keeping once and placing many times.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "scene/scene.h"

namespace durer::tracer {

/// When contents are shared. Asking a hierarchy within a hierarchy costs a ray more than asking one
/// that holds everything, so little or rare contents are copied instead. The picture is the same.
struct SharingLimits {
  double leaves = 16;     // least number of primitives in the contents …
  double saved = 200'000;  // … and of primitives that need not be copied, some 100 MB of them
};

/// Contents are lists of children; objects that are copies of one another have the same list.
class Sharing {
 public:
  Sharing(const scene::Scene& scene, const SharingLimits& limits);

  /// True if the contents of this object are to be shared, when placed like this.
  [[nodiscard]] bool shares(const scene::Object& object, const Transform& to_outer) const;

 private:
  struct Contents {
    double leaves = 0;  // all that a ray could meet below, every copy counted
    double placed = 0;  // in what is kept once
    scene::ObjectId first_owner = scene::none;
    bool movable = true;   // all of it looks the same wherever it is placed …
    bool mirrors = true;   // … and also mirrored
    bool shared = false;
  };
  struct Weight {
    double leaves = 0;
    bool movable = true;
    bool mirrors = true;
  };

  [[nodiscard]] Weight weigh(const scene::Scene& scene, const scene::Object& object);
  [[nodiscard]] bool keeps_bumps(const scene::Scene& scene, scene::TextureId id) const;
  void collect(const scene::Scene& scene);
  void choose(const scene::Scene& scene, const SharingLimits& limits);
  [[nodiscard]] const Contents* contents_of(const scene::Object& object) const;

  std::unordered_map<const void*, Contents> contents_;  // by the identity of the list
};

}  // namespace durer::tracer
