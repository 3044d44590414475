// Objects as plain data: a forest of nodes. Nodes are immutable and shared: `object { Tree … }`
// makes one new node, whatever hangs below it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/boxed.h"
#include "base/shared_list.h"
#include "scene/function_surface.h"
#include "scene/height_field.h"
#include "scene/mesh.h"
#include "scene/photons.h"
#include "scene/texture.h"

namespace durer::scene {

using ObjectId = std::uint32_t;
using LightId = std::uint32_t;

enum class NodeKind : std::uint8_t {
  primitive,
  union_,
  merge,
  intersection,
  difference,   // first child minus the others
  light,        // a light source that stands among objects (and moves with them); its child, if it
                // has one, is what it looks like
  light_group,  // a union whose own lights are for it alone
  unsupported,  // may be declared, must not be used
};

/// What few objects have.
struct ObjectExtras {
  std::shared_ptr<const Mesh> mesh;  // `mesh`, `mesh2`: instead of `args`
  std::shared_ptr<const Isosurface> isosurface;  // likewise
  std::shared_ptr<const Parametric> parametric;
  std::shared_ptr<const HeightField> heights;  // `height_field`: besides `args`
  /// Textures of single parts (blob components), placed with the object.
  std::vector<TextureId> part_textures;
  TextureUse interior_texture;       // seen when hit from inside; none: same as texture
  std::vector<ObjectId> clips;       // `clipped_by`: a hit survives if inside all of them
  std::vector<ObjectId> bounds;      // `bounded_by`
  /// The clips and bounds above live in this space of their own → surrounding space.
  SharedTransform clip_transform;
  SharedTransform bound_transform;
  SharedTransform media_transform;  // of the densities inside → surrounding space
  ObjectPhotons photons;
  std::string unsupported;  // the feature's name, when it cannot be rendered yet
};

/// One object. Spaces: `transform` maps the node's local space (that of its operands, or of its
/// children) to the space around it. Texture, clips and bounds carry transforms of their own that
/// lead to the same surrounding space, because what is attached after a transformation is not
/// moved by it (objects §6.4).
struct Object {
  NodeKind kind = NodeKind::primitive;
  bool inverse = false;
  bool no_shadow = false;
  bool no_image = false;
  bool no_reflection = false;
  bool no_radiosity = false;
  bool double_illuminate = false;
  bool sturm = false;
  float importance = 0;  // of radiosity, 0…1; 0: not said, that of the object around, or 1
  bool kept_whole = false;  // a union: `split_union off`
  bool cutaway_textures = false;  // bare surfaces look like what they lie in; children inherit it
  std::optional<bool> hollow;
  /// Textures are looked up at (u, v, 0) and stay where they are when the object is moved.
  bool uv_mapping = false;
  /// light_group: lit by the lights outside as well. Of groups in each other the outermost decides.
  bool global_lights = false;
  std::uint32_t type = none;  // primitive: index into Registry::primitives
  LightId light = none;
  InteriorId interior = none;
  OriginId origin = 0;
  SharedList<double> args;        // primitive: operands, laid out by its Params
  SharedList<ObjectId> children;  // CSG
  SharedTransform transform;
  TextureUse texture;  // .texture == none: inherits (objects §9.3)
  Boxed<ObjectExtras> extras;
};

}  // namespace durer::scene
