// Affine maps in the language's convention: row vectors, p' = [p 1]·M, left to right.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "base/shared_count.h"
#include "base/vec.h"

namespace durer {

/// One affine map. Rows x, y, z are the images of the axes, row t the image of the origin.
struct Affine {
  dvec3 x{1, 0, 0};
  dvec3 y{0, 1, 0};
  dvec3 z{0, 0, 1};
  dvec3 t{0, 0, 0};

  [[nodiscard]] dvec3 point(dvec3 p) const { return p.x * x + p.y * y + p.z * z + t; }
  [[nodiscard]] dvec3 vector(dvec3 v) const { return v.x * x + v.y * y + v.z * z; }
  /// n·M with M transposed: maps normals when called on the inverse map. Not renormalised.
  [[nodiscard]] dvec3 covector(dvec3 n) const {
    return {n.x * x.x + n.y * x.y + n.z * x.z, n.x * y.x + n.y * y.y + n.z * y.z,
            n.x * z.x + n.y * z.y + n.z * z.z};
  }
  /// `*this` first, then `next`.
  [[nodiscard]] Affine then(const Affine& next) const {
    return {next.vector(x), next.vector(y), next.vector(z), next.point(t)};
  }
  /// Inverse map; none if the determinant is zero or not finite.
  [[nodiscard]] std::optional<Affine> inverse() const;

  friend bool operator==(const Affine&, const Affine&) = default;
};

/// A map and its inverse, kept together so that neither is ever recomputed.
struct Transform {
  Affine forward;
  Affine backward;

  [[nodiscard]] static Transform translate(dvec3 by);
  /// Degrees; about x, then y, then z, in the left-handed sense of the language (objects §6.2).
  [[nodiscard]] static Transform rotate_deg(dvec3 degrees);
  /// No component may be zero (the interpreter replaces zeros by 1 with a warning).
  [[nodiscard]] static Transform scale(dvec3 by);
  /// Twelve numbers in the order of `matrix <…>`: rows x, y, z, t. None if singular.
  [[nodiscard]] static std::optional<Transform> matrix(const std::array<double, 12>& m);

  [[nodiscard]] Transform then(const Transform& next) const {
    return {forward.then(next.forward), next.backward.then(backward)};
  }
  [[nodiscard]] Transform inverse() const { return {backward, forward}; }
  [[nodiscard]] bool is_identity() const { return forward == Affine{}; }

  [[nodiscard]] dvec3 point(dvec3 p) const { return forward.point(p); }
  [[nodiscard]] dvec3 vector(dvec3 v) const { return forward.vector(v); }
  /// Normals go by the inverse transpose; the result is not renormalised.
  [[nodiscard]] dvec3 normal(dvec3 n) const { return backward.covector(n); }

  friend bool operator==(const Transform&, const Transform&) = default;
};

/// A transform as scene data keeps it: the identity, by far the commonest, takes 16 bytes, and
/// copies share.
class SharedTransform {
 public:
  SharedTransform() = default;
  SharedTransform(const Transform& t)  // NOLINT: meant to convert
      : transform_(t.is_identity() ? Counted<Transform>() : Counted<Transform>::make(t)) {}

  [[nodiscard]] bool is_identity() const { return !transform_; }
  [[nodiscard]] const Transform& get() const {
    static const Transform identity;
    return transform_ ? *transform_ : identity;
  }
  operator const Transform&() const { return get(); }  // NOLINT: meant to convert
  const Transform* operator->() const { return &get(); }
  [[nodiscard]] SharedTransform then(const SharedTransform& next) const {
    if (is_identity()) return next;
    if (next.is_identity()) return *this;
    return get().then(next.get());
  }

  friend bool operator==(const SharedTransform& a, const SharedTransform& b) {
    return a.transform_ == b.transform_ || a.get() == b.get();
  }

 private:
  Counted<Transform> transform_;
};

}  // namespace durer
