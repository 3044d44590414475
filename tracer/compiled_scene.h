// What compile() makes of a scene: everything a ray may ask for, in arrays, immutable.
#pragma once

#include <cstdint>
#include <vector>

#include "tracer/compile.h"
#include "tracer/geometry.h"
#include "tracer/lights/light.h"
#include "tracer/shading/interior.h"
#include "tracer/shading/sky.h"
#include "tracer/shading/texture.h"

namespace durer::tracer {

/// What one surface of the geometry looks like.
struct SurfaceProgram {
  ProgramId outside = 0;
  ProgramId inside = 0;  // for hits from within
  bool double_illuminate = false;
};

struct CompiledScene {
  CompiledScene(const scene::Scene& s, Geometry g)
      : scene(&s), geometry(std::move(g)), textures(s), sky(s) {}

  const scene::Scene* scene;
  Geometry geometry;
  TextureStore textures;
  Sky sky;
  std::vector<SurfaceProgram> surfaces;  // parallel to geometry.surfaces()
  std::vector<Interior> interiors;       // parallel to geometry.interiors()
  std::vector<Light> lights;
  Containment around_camera;  // bodies that hold the camera's location
};

}  // namespace durer::tracer
