#include "tracer/patterns/inner_object.h"

#include <atomic>
#include <vector>

namespace durer::tracer {
namespace {

std::size_t next_serial() {
  static std::atomic<std::size_t> count{0};
  return count++;
}

/// What a thread needs to ask an object.
struct Asking {
  GeometryScratchPtr scratch;
  std::vector<std::uint32_t> interiors;
};

}  // namespace

// Objects that cannot be asked were reported when the pattern was read.
InnerObject::InnerObject(const scene::Scene& scene, scene::ObjectId object)
    : serial_(next_serial()) {
  const SourceMap nowhere;
  Diagnostics ignored(nowhere);
  geometry_ = Geometry::build_object(scene, object, ignored);
}

bool InnerObject::contains(dvec3 p) const {
  if (!geometry_) return false;
  // Patterns are looked at from all threads, and have no room of their own.
  thread_local std::vector<Asking> threads_own;
  if (threads_own.size() <= serial_) threads_own.resize(serial_ + 1);
  Asking& asking = threads_own[serial_];
  if (!asking.scratch) asking.scratch = geometry_->make_scratch();
  asking.interiors.clear();
  geometry_->containing(p, asking.interiors, *asking.scratch);
  return !asking.interiors.empty();
}

}  // namespace durer::tracer
