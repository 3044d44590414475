// An isosurface as a shape (objects §10.13). Objects that show the same one share what is known
// about its function.
#pragma once

#include <memory>

#include "functions/differences.h"
#include "scene/function_surface.h"
#include "tracer/primitives/function_field.h"
#include "tracer/primitives/packet.h"
#include "tracer/primitives/typed_store.h"

namespace durer::tracer {

struct IsosurfaceData {
  IsosurfaceData(std::shared_ptr<const scene::Isosurface> s, functions::NoiseGenerator generator);
  /// Of a function without bounds: keeps the steepest slope that was met.
  void note_slope(double slope) const;

  std::shared_ptr<const scene::Isosurface> surface;
  FunctionField field;
  functions::Differences differences;
  mutable std::atomic<double> steepest{0};
};
/// Made once, however often it is asked for, as long as anybody holds it.
[[nodiscard]] std::shared_ptr<const IsosurfaceData> shared_isosurface_data(
    const std::shared_ptr<const scene::Isosurface>& surface, functions::NoiseGenerator generator);

/// Part 0 is the surface, others are faces of the container (container.h). All crossings are given,
/// whatever `max_trace` says; the container is seen from both sides.
class IsosurfaceShape {
 public:
  explicit IsosurfaceShape(std::shared_ptr<const IsosurfaceData> data) : data_(std::move(data)) {}

  [[nodiscard]] Bounds3 bounds() const { return data_->field.box(); }
  [[nodiscard]] bool contains(dvec3 p) const;
  [[nodiscard]] dvec3 normal(dvec3 p, std::uint32_t part) const;
  void crossings(const Ray& ray, Crossings& out) const;
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const;
  void nearest(const PacketRays& rays, bool any, PacketHits& hits) const;
  void normals(const PacketPoints& points, PacketVectors& out) const;
  [[nodiscard]] std::pair<std::string, std::string> doubt() const;

 private:
  /// How short parts of the surface along a line may be, in units of the shape's space.
  [[nodiscard]] double least() const;
  template <typename Take>
  void each_crossing(const Ray& ray, double t_from, double t_to, Take take) const;

  std::shared_ptr<const IsosurfaceData> data_;
};

}  // namespace durer::tracer
