#include "functions/noise_tables.h"

#include <cmath>

namespace durer::functions {
namespace {

CornerRow random_unit_vector(Lcg& lcg) {
  for (;;) {
    double v[3];
    for (double& c : v) c = (static_cast<double>(lcg.next15() % 4096) - 2048) / 2048;
    const double d2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    if (d2 < 1e-5 || d2 > 1) continue;
    const double d = std::sqrt(d2);
    return {{0, v[0] / d, v[1] / d, v[2] / d}};
  }
}

GradientLattice make_gradient_lattice() {
  GradientLattice lattice{};
  Lcg lcg{1};
  for (CornerRow& g : lattice.gradients) g = random_unit_vector(lcg);

  // Only even places are shuffled, and the slot past the end takes one value away for a second 0:
  // not a permutation, but the one that pictures depend on.
  std::array<std::uint16_t, 2049> p{};
  for (unsigned i = 0; i < 2048; ++i) p[i] = static_cast<std::uint16_t>(i);
  for (unsigned i = 2048; i > 0; i -= 2) std::swap(p[i], p[lcg.next15() % 2048]);
  for (unsigned i = 0; i < 2048; ++i) lattice.p[i] = p[i];
  return lattice;
}

}  // namespace

const GradientLattice& gradient_lattice() {
  static const GradientLattice lattice = make_gradient_lattice();
  return lattice;
}

}  // namespace durer::functions
