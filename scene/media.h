// Participating media as plain data: matter that fills a body or the whole scene
// (participating-and-global §1).
#pragma once

#include <cstdint>
#include <vector>

#include "scene/texture.h"

namespace durer::scene {

/// How scattered light depends on its direction (participating-and-global §1.11).
enum class Phase : std::uint8_t { isotropic, mie_hazy, mie_murky, rayleigh, henyey_greenstein };

/// One medium. Coefficients are per unit of length of the world, wherever densities are moved to.
struct Media {
  vec3 absorption{0.0F};
  vec3 emission{0.0F};
  vec3 scattering{0.0F};
  Phase phase = Phase::isotropic;
  double eccentricity = 0;  // of Henyey and Greenstein's; positive: forward
  double extinction = 1;    // share of scattering that dims the light behind
  bool collect = true;      // takes part in photon mapping
  std::vector<Pigment> densities;  // they multiply; none: 1 everywhere

  // How it is sampled.
  int method = 3;     // 1 random, 2 stratified, 3 adaptive
  int intervals = 1;  // at least 1
  int min_samples = 10;
  int max_samples = 10;  // per interval, for methods 1 and 2
  double confidence = 0.9;
  double variance = 1.0 / 128;
  double ratio = 0.9;  // share of the intervals for where light falls
  double jitter = 0;
  double aa_threshold = 0.1;  // method 3 divides where samples differ by more
  int aa_level = 3;           // and at most so many times
  OriginId origin = 0;
};

}  // namespace durer::scene
