#include "tracer/primitives/typed_store.h"

namespace durer::tracer {

Bounds3 through(const Bounds3& box, const Affine& map) {
  if (box.empty()) return box;
  Bounds3 out;
  for (int i = 0; i < 3; ++i) {
    double lo = map.t[i];
    double hi = map.t[i];
    bool open_below = false;
    bool open_above = false;
    for (int j = 0; j < 3; ++j) {
      const double m = (j == 0 ? map.x : j == 1 ? map.y : map.z)[i];
      if (m == 0) continue;
      const bool no_least = box.lo[j] <= -unbounded;
      const bool no_greatest = box.hi[j] >= unbounded;
      open_below = open_below || (m > 0 ? no_least : no_greatest);
      open_above = open_above || (m > 0 ? no_greatest : no_least);
      lo += m * (m > 0 ? box.lo : box.hi)[j];
      hi += m * (m > 0 ? box.hi : box.lo)[j];
    }
    out.lo[i] = open_below ? -unbounded : lo;
    out.hi[i] = open_above ? unbounded : hi;
  }
  return out;
}

}  // namespace durer::tracer
