// Surfaces as plain data. Every texture is immutable once it is in the scene; users refer to it by
// id and bring their own transform, so that a copy costs nothing.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/boxed.h"
#include "base/colour.h"
#include "base/transform.h"
#include "scene/origin.h"
#include "scene/pattern.h"

namespace durer::scene {

using TextureId = std::uint32_t;
using InteriorId = std::uint32_t;

struct Pigment;

/// One entry of a colour map, pigment map or list. `pigment` (an index into `Pigment::children`)
/// is used instead of `colour` when it is not `none`.
struct PigmentEntry {
  float key = 0;
  Colour colour;
  std::uint32_t pigment = none;
};

/// A colour for every point. Without a pattern: the plain `colour` everywhere.
struct Pigment {
  Boxed<Pattern> pattern;
  Colour colour;
  std::vector<PigmentEntry> entries;  // in written order, never sorted (textures §11.1)
  std::vector<Pigment> children;
  /// Looked up at (u, v, 0) of the object; transformations of the texture do not move it.
  bool uv_mapping = false;
  /// Shown instead at quality 5 and below, unless one of its components is -1 (textures §11.8).
  Colour quick_colour{vec3(-1.0F)};
  OriginId origin = 0;
  /// Name of a feature in it that cannot be rendered yet; such a pigment may be declared, not used.
  std::string unsupported;
};

/// Surface model (shading §4.1). Colours are rgb in working space.
struct Finish {
  vec3 ambient{0.1F};
  vec3 emission{0.0F};
  float diffuse = 0.6F;
  float diffuse_back = 0;
  // Both as they are written: `albedo` does not change what indirect light does.
  float indirect = 0.6F;
  float indirect_back = 0;
  float brilliance = 1;
  float phong = 0;
  float phong_size = 40;
  float specular = 0;
  float roughness = 0.05F;  // the exponent is 1/roughness; 0 means exponent 0
  float metallic = 0;
  float crand = 0;
  vec3 reflection_min{0.0F};
  vec3 reflection_max{0.0F};
  float reflection_falloff = 1;
  float reflection_exponent = 1;  // as written; light is raised to 1/exponent
  float reflection_metallic = 0;
  bool fresnel = false;
  bool conserve_energy = false;
  float irid = 0;
  float irid_thickness = 0;
  float irid_turbulence = 0;
  /// Mean way of light below the surface, in mm: then it is not reflected where it falls, but
  /// comes out around there. 0: at once.
  vec3 translucency{0.0F};
  bool subsurface = false;
  /// Legacy values that move into the object's interior (objects §8.6); negative: not written.
  float ior = -1;
  float caustics = -1;
  float refraction = -1;
  std::string unsupported;
};

struct Normal;

/// One entry of a normal map or list; `normal` is an index into `Normal::children`.
struct NormalEntry {
  float key = 0;
  std::uint32_t normal = none;
};
/// One entry of a slope map (textures §13.3).
struct SlopeEntry {
  float key = 0;
  float height = 0;
  float slope = 0;
};

/// Bumps: how a surface bends its normal (textures §13). Without a pattern: not at all.
struct Normal {
  Boxed<Pattern> pattern;
  float amount = 0.5F;
  float accuracy = 0.02F;  // how far apart the values are taken that tell the slope
  bool no_bump_scale = false;
  bool uv_mapping = false;           // looked up at (u, v, 0), as pigments are
  std::vector<NormalEntry> entries;  // empty: the pattern itself makes the bumps
  std::vector<Normal> children;
  std::vector<SlopeEntry> slopes;
  OriginId origin = 0;
  std::string unsupported;
};

/// True if it, or something in it, is looked up at (u, v, 0) of the object.
[[nodiscard]] bool uses_uv(const Pattern& pattern);
template <typename Look>  // Pigment or Normal
[[nodiscard]] bool uses_uv(const Look& look) {
  if (look.uv_mapping || uses_uv(*look.pattern)) return true;
  for (const Look& child : look.children) {
    if (uses_uv(child)) return true;
  }
  return false;
}

inline bool uses_uv(const Pattern& pattern) {
  return pattern.pigment != nullptr && uses_uv(*pattern.pigment);
}

struct Layer {
  Boxed<Pigment> pigment;
  Boxed<Finish> finish;
  std::string unsupported;
  Boxed<Normal> normal = {};
};

/// One entry of a texture map or list.
struct TextureEntry {
  float key = 0;
  TextureId texture = none;
};

/// Either layers in written order, the last of which is the outermost and seen first; or other
/// textures that a pattern chooses among. These are looked up where the pattern has moved the
/// point to.
struct Texture {
  std::vector<Layer> layers;
  OriginId origin = 0;
  std::string unsupported;  // material_map …
  Boxed<Pattern> pattern = {};
  std::vector<TextureEntry> entries = {};
  bool uv_mapping = false;     // the one entry is looked up at (u, v, 0)
  bool no_bump_scale = false;  // of a patterned texture

  [[nodiscard]] bool patterned() const { return !entries.empty(); }
};

/// False if the texture looks the same wherever it is placed: plain colours, no bumps.
[[nodiscard]] inline bool has_place(const Texture& texture) {
  if (texture.patterned()) return true;
  for (const Layer& l : texture.layers) {
    if (l.pigment->pattern->exists() || l.normal->pattern->exists()) return true;
  }
  return false;
}

struct Media;

/// Volume side of a surface (shading §5).
struct Interior {
  double ior = -1;  // negative: the atmosphere's
  double dispersion = 1;
  int dispersion_samples = 7;
  float caustics = 0;  // as written, before the factor 45
  double fade_distance = 0;
  double fade_power = 0;
  vec3 fade_colour{0.0F};
  float refraction = 1;
  Boxed<std::vector<Media>> media;  // all of them act at once
  OriginId origin = 0;
  std::string unsupported;
};

/// A texture as attached to an object: the texture, then the transforms made since.
struct TextureUse {
  TextureId texture = none;
  SharedTransform transform;  // texture space → space around the object that carries it

  friend bool operator==(const TextureUse&, const TextureUse&) = default;
};

}  // namespace durer::scene
