#include "base/transform.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace durer {

std::optional<Affine> Affine::inverse() const {
  const dvec3 yz = glm::cross(y, z);
  const double det = glm::dot(x, yz);
  if (det == 0 || !std::isfinite(1 / det)) return std::nullopt;
  const dvec3 zx = glm::cross(z, x);
  const dvec3 xy = glm::cross(x, y);
  // Columns of the inverse are the scaled cross products; written as rows here.
  Affine r;
  r.x = dvec3(yz.x, zx.x, xy.x) / det;
  r.y = dvec3(yz.y, zx.y, xy.y) / det;
  r.z = dvec3(yz.z, zx.z, xy.z) / det;
  r.t = -r.vector(t);
  return r;
}

Transform Transform::translate(dvec3 by) {
  Transform r;
  r.forward.t = by;
  r.backward.t = -by;
  return r;
}

Transform Transform::scale(dvec3 by) {
  Transform r;
  r.forward.x.x = by.x;
  r.forward.y.y = by.y;
  r.forward.z.z = by.z;
  r.backward.x.x = 1 / by.x;
  r.backward.y.y = 1 / by.y;
  r.backward.z.z = 1 / by.z;
  return r;
}

Transform Transform::rotate_deg(dvec3 degrees) {
  constexpr double radians_per_degree = 0.0174532925199432957692;
  const dvec3 a = degrees * radians_per_degree;
  Affine rx;
  rx.y = {0, std::cos(a.x), std::sin(a.x)};
  rx.z = {0, -std::sin(a.x), std::cos(a.x)};
  Affine ry;
  ry.x = {std::cos(a.y), 0, -std::sin(a.y)};
  ry.z = {std::sin(a.y), 0, std::cos(a.y)};
  Affine rz;
  rz.x = {std::cos(a.z), std::sin(a.z), 0};
  rz.y = {-std::sin(a.z), std::cos(a.z), 0};
  Transform r;
  r.forward = rx.then(ry).then(rz);
  // A rotation's inverse is its transpose: exact, unlike a computed inverse.
  const Affine& f = r.forward;
  r.backward.x = {f.x.x, f.y.x, f.z.x};
  r.backward.y = {f.x.y, f.y.y, f.z.y};
  r.backward.z = {f.x.z, f.y.z, f.z.z};
  return r;
}

std::optional<Transform> Transform::matrix(const std::array<double, 12>& m) {
  Transform r;
  r.forward = {{m[0], m[1], m[2]}, {m[3], m[4], m[5]}, {m[6], m[7], m[8]}, {m[9], m[10], m[11]}};
  const auto inverse = r.forward.inverse();
  if (!inverse) return std::nullopt;
  r.backward = *inverse;
  return r;
}

}  // namespace durer
