// What compile() makes of a scene: everything a ray may ask for, in arrays, immutable.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tracer/compile.h"
#include "tracer/geometry.h"
#include "tracer/placements.h"
#include "tracer/lights/light.h"
#include "tracer/quality.h"
#include "tracer/shading/atmosphere.h"
#include "tracer/shading/interior.h"
#include "tracer/shading/sky.h"
#include "tracer/shading/texture.h"
#include "tracer/transport/emitters.h"
#include "tracer/transport/radiosity.h"
#include "tracer/transport/subsurface.h"

namespace durer::tracer {

/// What one surface of the geometry looks like.
struct SurfaceProgram {
  ProgramId outside = 0;
  ProgramId inside = 0;  // for hits from within
  bool double_illuminate = false;
  /// Where it is not in shared contents, its textures are what is seen, at the point itself.
  bool bare = false;
  std::uint32_t lamps = 0;  // index into Geometry::lamp_sets()
  bool uv_mapping = false;  // all textures are looked up at (u, v, 0)
  bool has_parts = false;   // single parts of the surface have textures of their own:
  std::uint32_t first_part = 0;  // index into CompiledScene::part_textures
  PhotonTraits photons;
  bool cutaway = false;          // it takes textures of other surfaces (objects §9.5)
};

/// Stands for what shared contents receive from outside: see Placement::surface.
inline constexpr ProgramId program_of_placement = scene::none - 1;

struct CompiledScene {
  CompiledScene(const scene::Scene& s, Geometry g, Quality q)
      : scene(&s), quality(q), geometry(std::move(g)), textures(s, q), sky(s), atmosphere(s), media(s.settings) {
    if (s.settings.radiosity && q.radiosity && !q.path) radiosity.emplace(s);
    if (s.settings.subsurface && q.subsurface) {
      subsurface.emplace(*s.settings.subsurface, s.settings.mm_per_unit);
    }
  }

  const scene::Scene* scene;
  Quality quality;
  Geometry geometry;
  TextureStore textures;
  Sky sky;
  Atmosphere atmosphere;
  std::optional<RadiosityProgram> radiosity;
  std::optional<SubsurfaceProgram> subsurface;
  std::vector<SurfaceProgram> surfaces;  // parallel to geometry.surfaces()
  std::vector<ProgramId> part_textures;
  std::vector<Interior> interiors;       // parallel to geometry.interiors()
  std::vector<Light> lights;
  std::vector<Reach> reaches;  // parallel to `lights`
  std::vector<Geometry> projectors;  // what lamps shine through, each alone
  MediaStore media;      // empty at qualities that leave media out
  MediaRange air_media;  // of `media`: those that are everywhere
  Emitters emitters;     // empty unless light is followed along random paths
  Containment around_camera;  // bodies that hold the camera's location
};

}  // namespace durer::tracer
