#include "functions/number.h"

namespace durer::functions {

Pack noise(const Pack& x, const Pack& y, const Pack& z, NoiseGenerator g) {
  std::array<dvec3, Pack::lanes> p;
  for (int i = 0; i < Pack::lanes; ++i) p[i] = {x.v[i], y.v[i], z.v[i]};
  Pack r;
  noise(p, g, r.v);
  return r;
}

}  // namespace durer::functions
