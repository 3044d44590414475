// The field of a blob (objects §10.6): components, and what a line meets of each.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/bounds.h"
#include "base/ray.h"
#include "base/transform.h"

namespace durer::tracer {

/// Part of a line on which one component is felt: its field there is strength · u², and
/// u = top - bend · (t - middle)² falls to 0 at the ends that are its own.
struct BlobStretch {
  double begin;
  double end;
  double middle;
  double top;
  double bend;
  double strength;
  // Where this component alone reaches the threshold; nowhere if begin > end.
  double full_begin;
  double full_end;

  [[nodiscard]] double root_at(double t) const {
    return top - bend * ((t - middle) * (t - middle));
  }
  /// The blossom of the quadratic: the middle coefficient of its Bernstein form over [a, b].
  [[nodiscard]] double root_between(double a, double b) const {
    return top - bend * ((a - middle) * (b - middle));
  }
};

/// A ball, or a rod with round ends, in a space of its own: the ball around the origin, the rod
/// along z from 0 to `length`.
struct BlobComponent {
  Affine to_own;
  double radius2 = 1;
  double length = -1;   // negative: a ball
  double strength = 1;  // of the field's square root, over radius⁴
  double full = 0;      // the root of the field at which it reaches the threshold by itself
  std::uint32_t texture = 0;
  bool plain = false;  // a ball that is only moved
  Bounds3 reach;  // in the blob's space
  Bounds3 seen;   // the box that the oracle makes of it, if it adds to the field

  [[nodiscard]] double field(dvec3 p) const;
  /// How the field falls, in the blob's space.
  [[nodiscard]] dvec3 fall(dvec3 p) const;
  /// Appends the stretches within t_from…t_to.
  void append_stretches(const Ray& ray, double t_from, double t_to,
                        std::vector<BlobStretch>& out) const;

 private:
  [[nodiscard]] dvec3 from_axis(dvec3 own) const;
};

/// Components from the operands that the language leaves: `kind, centre…` as blob.cpp lays out.
[[nodiscard]] std::vector<BlobComponent> blob_components(std::span<const double> list,
                                                        double threshold);

/// How many numbers the component takes that begins `list`; 0 if it is not whole.
[[nodiscard]] std::size_t blob_component_size(std::span<const double> list);

}  // namespace durer::tracer
