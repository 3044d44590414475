// The scene: everything the interpreter knows, nothing the tracer computes. Plain data, printable,
// comparable; ids are indices into the vectors here.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/chunked.h"
#include "base/colour.h"
#include "base/gamma.h"
#include "scene/atmosphere.h"
#include "scene/camera.h"
#include "scene/light.h"
#include "scene/media.h"
#include "scene/object.h"
#include "scene/origin.h"
#include "scene/photons.h"
#include "scene/radiosity.h"
#include "scene/texture.h"

namespace durer::scene {

/// Pigments on the inside of an infinite sphere: the colour of rays that hit nothing (shading
/// §7.2).
struct SkySphere {
  std::vector<Pigment> pigments;  // in written order; later ones lie on top
  vec3 emission{1.0F};
  SharedTransform transform;  // pigment space → world; applied to the unit direction as to a point
  OriginId origin = 0;
};

/// `subsurface { … }` of `global_settings`: light that goes on below surfaces
/// (participating-and-global §4).
struct Subsurface {
  int samples = 50;         // where diffused light may have entered
  int single_samples = 50;  // of light that was scattered once, for each component of colour
  bool radiosity = false;   // indirect light enters, too

  friend bool operator==(const Subsurface&, const Subsurface&) = default;
};

/// How scene numbers relate to light (shading §1.2).
enum class GammaMode : std::uint8_t { off, legacy, explicit_, implied };

struct Settings {
  float adc_bailout = 1.0F / 255;
  int max_trace_level = 5;
  vec3 ambient_light{1.0F};
  vec3 irid_wavelength{0.70F, 0.52F, 0.48F};
  int noise_generator = 0;   // 1, 2 or 3; the interpreter resolves the default
  int number_of_waves = 10;  // sources of the `waves` and `ripples` patterns
  double mm_per_unit = 10;   // scale of subsurface light transport
  std::optional<Radiosity> radiosity;
  std::optional<Photons> photons;
  std::optional<Subsurface> subsurface;
  GammaMode gamma_mode = GammaMode::off;
  GammaCurve assumed_gamma;  // meaning of scene numbers; identity curve in mode `off`
  /// Hundredths; decides opacity, sky and gamma rules at render time (shading §1.1).
  int effective_version = 362;
  int declared_version = 370;

  /// 1, 2 or 3: the version decides where nothing else does (builtin-functions §3).
  [[nodiscard]] int resolved_noise_generator() const {
    if (noise_generator != 0) return noise_generator;
    return declared_version >= 350 ? 2 : 1;
  }
};

/// An object of the scene's top level, with the default texture in force when it was complete.
struct Root {
  ObjectId object = none;
  TextureId default_texture = none;
};

struct Scene {
  Chunked<Object> objects;
  std::vector<Root> roots;  // in order of declaration
  std::vector<Light> lights;
  Chunked<Texture> textures;
  std::vector<Interior> interiors;
  std::vector<Media> atmosphere;  // media that fill the space outside of bodies, and hollow ones
  Camera camera;
  Colour background{.rgb = vec3(0.0F), .filter = 0, .transmit = 1};
  std::optional<SkySphere> sky_sphere;
  std::vector<Fog> fogs;  // in order of declaration
  std::vector<Rainbow> rainbows;
  Settings settings;
  Chunked<Origin, 12> origins{1};
};

}  // namespace durer::scene
