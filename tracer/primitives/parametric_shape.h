// A parametric surface as a shape (objects §11.8): a tree over the ranges of u and v, made where
// rays come by, whose cells bound the surface and its slopes.
#pragma once

#include <array>
#include <atomic>
#include <memory>

#include "functions/evaluate.h"
#include "scene/function_surface.h"
#include "tracer/primitives/typed_store.h"

namespace durer::tracer {

/// What is known about the surface over a rectangle of u and v.
struct PatchCell {
  Bounds3 box;    // of the points
  dvec3 p{0.0};   // the point of the rectangle's centre
  /// Slopes of the three coordinates by u and v: slope ± spread.
  std::array<dvec3, 2> slope{};
  std::array<dvec3, 2> spread{};
  mutable std::atomic<const PatchCell*> children{nullptr};  // four
};

class ParametricData {
 public:
  ParametricData(std::shared_ptr<const scene::Parametric> surface,
                 functions::NoiseGenerator generator);
  ~ParametricData();
  ParametricData(const ParametricData&) = delete;
  ParametricData& operator=(const ParametricData&) = delete;

  [[nodiscard]] const scene::Parametric& surface() const { return *surface_; }
  [[nodiscard]] functions::NoiseGenerator generator() const { return generator_; }
  [[nodiscard]] const PatchCell& root() const { return root_; }
  /// Bit 0 of the index is set where u is higher, bit 1 where v is.
  [[nodiscard]] const PatchCell* children(const PatchCell& cell, dvec2 centre, dvec2 half) const;

  struct Place {
    dvec3 p;
    dvec3 du, dv;  // its derivatives
  };
  [[nodiscard]] Place at(dvec2 uv) const;
  [[nodiscard]] dvec3 point(dvec2 uv) const;

 private:
  void examine(PatchCell& cell, dvec2 centre, dvec2 half) const;

  std::shared_ptr<const scene::Parametric> surface_;
  functions::NoiseGenerator generator_;
  std::array<bool, 3> has_bounds_{};
  PatchCell root_;
};
[[nodiscard]] std::shared_ptr<const ParametricData> shared_parametric_data(
    const std::shared_ptr<const scene::Parametric>& surface, functions::NoiseGenerator generator);

/// It has no inside. Parts are places on the surface, u and v with 16 bits each.
/// Accuracy: where the surface is smooth, that of Newton's method; at kinks and poles, and where it
/// is seen edge-on, `accuracy`. The oracle's surface lies up to two accuracies in front of this one.
class ParametricShape {
 public:
  explicit ParametricShape(std::shared_ptr<const ParametricData> data) : data_(std::move(data)) {}

  [[nodiscard]] Bounds3 bounds() const;
  [[nodiscard]] bool contains(dvec3) const { return false; }
  [[nodiscard]] dvec3 normal(dvec3 p, std::uint32_t part) const;
  [[nodiscard]] dvec2 uv(dvec3 p, std::uint32_t part) const;
  void crossings(const Ray& ray, Crossings& out) const;
  [[nodiscard]] std::optional<Nearest> nearest(const Ray& ray, double t_from, double t_to) const;

 private:
  std::shared_ptr<const ParametricData> data_;
};

}  // namespace durer::tracer
