// What light below surfaces needs to know of the scene (participating-and-global §4).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/scene.h"
#include "tracer/shading/interior.h"
#include "tracer/shading/translucent.h"

namespace durer::tracer {

/// Subsurface light of a scene, compiled. Immutable.
struct SubsurfaceProgram {
  SubsurfaceProgram(const scene::Subsurface& s, double mm) : settings(s), mm_per_unit(mm) {}

  /// Once all interiors are known.
  void add_interiors(std::span<const Interior> interiors);
  [[nodiscard]] const AlbedoTable& albedo(std::uint32_t interior) const {
    return tables[table_of[interior]];
  }

  scene::Subsurface settings;
  double mm_per_unit;
  std::vector<dvec3> directions = sphere_directions(settings.samples);  // evenly all around
  std::vector<AlbedoTable> tables;
  std::vector<std::uint32_t> table_of;  // by interior

  [[nodiscard]] static std::vector<dvec3> sphere_directions(int count);
};

}  // namespace durer::tracer
