// What a render leaves out to be sooner done.
#pragma once

namespace durer::tracer {

/// The levels of `Quality` (shading §3.6), as the answers that the tracer wants.
struct Quality {
  explicit constexpr Quality(int level)
      : lights(level >= 2),
        shadows(level >= 4),
        area_lights(level >= 5),
        quick_colours(level <= 5),
        transparency(level >= 6),
        reflection(level >= 8),
        normals(level >= 8),
        atmosphere(level >= 9),
        radiosity(level >= 9),
        photons(level >= 9),
        subsurface(level >= 9) {}

  bool lights;         // without them a surface shows its innermost visible pigment
  bool shadows;
  bool area_lights;    // else they are points
  bool quick_colours;  // instead of pigments that have one
  bool transparency;   // else what is behind a surface is black
  bool reflection;
  bool normals;
  bool atmosphere;  // fog, rainbows, media
  bool radiosity;
  bool photons;
  bool subsurface;
  bool path = false;  // light is followed along random paths: see Integrator
};

}  // namespace durer::tracer
