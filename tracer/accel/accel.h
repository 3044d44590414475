// The hierarchy over everything in the scene, behind two questions. Two implementations: Embree,
// and a plain loop that the tests compare it with.
#pragma once

#include <memory>
#include <span>

#include "tracer/query.h"

namespace durer::tracer {

class Accel {
 public:
  virtual ~Accel() = default;

  /// Leaves the nearest hit in `query.found`, its depth in `query.t_to`.
  virtual void closest(RayQuery& query) const = 0;
  /// True as soon as any hit is found; which one is not defined.
  virtual bool any(RayQuery& query) const = 0;

  /// The only object that answers several rays together, if boxes are no quicker to rule it out:
  /// queries that put off (RayQuery::later) are not told of it, and whoever makes them asks it
  /// after everybody else. Null: there is none.
  struct Companion {
    const Targets* targets = nullptr;
    std::uint32_t index = 0;
  };
  [[nodiscard]] const Companion& companion() const { return companion_; }
  /// True if there is no other object.
  [[nodiscard]] bool companion_only() const { return companion_only_; }

 protected:
  Companion companion_;
  bool companion_only_ = false;
};

[[nodiscard]] std::unique_ptr<Accel> make_embree_accel(std::span<const Targets* const> all);
[[nodiscard]] std::unique_ptr<Accel> make_linear_accel(std::span<const Targets* const> all);

}  // namespace durer::tracer
