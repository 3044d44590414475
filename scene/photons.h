// Photons: light that lamps send through glass and off mirrors onto other surfaces
// (participating-and-global §3.1).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace durer::scene {

/// `photons { … }` of `global_settings`. Lengths in world units.
struct Photons {
  double spacing = 1;    // between photons where they meet their target; with `count` a factor
  int count = 0;         // how many there shall be, roughly; 0: as many as the spacing makes
  int gather_min = 20;   // photons that an estimate wants, and takes at most; most of 0: no photons
  int gather_max = 100;
  int media_steps = 0;     // places at most along a way through a medium; 0: none
  double media_factor = 1; // distance of these, relative to that of the photons
  double jitter = 0.4;     // 0: at the nodes of their grid; 1: anywhere around
  double autostop = 0.5;   // 0…1: share of the target's cone that is always asked
  double expand_increase = 0.2;  // a wider search counts if it finds less than so much more, per area …
  int expand_min = 35;           // … or fewer photons than this
  double surface_radius = 0;     // where to look for photons; 0: found out
  double surface_factor = 1;     // that, relative to what was found out or given
  double media_radius = 0;
  double media_factor_of_radius = 1;
  std::optional<int> max_trace_level;  // else that of the scene
  std::optional<double> adc_bailout;
  std::string save_file;  // where the photons shall be kept; empty: nowhere
  /// A file of photons that are used instead of shooting any: two lists, each a count in 32 bits and
  /// as many records of 20 bytes (§3.14). Lengths and counts agree.
  std::vector<std::uint8_t> loaded;

  friend bool operator==(const Photons&, const Photons&) = default;
};

/// `photons { … }` of an object. What is not said is inherited.
struct ObjectPhotons {
  double target = 0;  // photons are sent here, so many times as far apart; 0: it is no target
  std::optional<bool> refraction;
  std::optional<bool> reflection;
  bool pass_through = false;    // on their way to a target they are not stopped here
  std::optional<bool> collect;  // it shows photons

  friend bool operator==(const ObjectPhotons&, const ObjectPhotons&) = default;
};

/// `photons { … }` of a light source.
struct LightPhotons {
  std::optional<bool> refraction;
  std::optional<bool> reflection;
  bool area = false;  // its whole area sends them, not only its centre

  friend bool operator==(const LightPhotons&, const LightPhotons&) = default;
};

}  // namespace durer::scene
