// A line as the z axis of a space of its own, in which a triangle is met if the origin lies in its
// shadow [Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", 2013]. A corner comes out the
// same in all triangles that share it, and the sign of a difference of two products is never wrong
// (it may only be 0), so lines can slip neither between two triangles nor through a corner.
#pragma once

#include <cmath>

#include "base/ray.h"

namespace durer::tracer {

struct ShearedRay {
  int x, y, z;    // axes of the world: z is the one along which the ray goes farthest
  double sx, sy;  // by how much x and y fall behind for each unit of z
  dvec3 o;        // the ray's origin, in the order x, y, z

  explicit ShearedRay(const Ray& ray) {
    const double dx = std::abs(ray.d.x);
    const double dy = std::abs(ray.d.y);
    const double dz = std::abs(ray.d.z);
    z = dx > dy && dx > dz ? 0 : dy > dz ? 1 : 2;
    x = (z + 1) % 3;
    y = (z + 2) % 3;
    sx = ray.d[x] / ray.d[z];
    sy = ray.d[y] / ray.d[z];
    o = {ray.o[x], ray.o[y], ray.o[z]};
  }
};

}  // namespace durer::tracer
