#include "tracer/flatten.h"


#include <algorithm>
#include <cstring>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "tracer/extent.h"
#include "tracer/primitives/registry.h"
#include "tracer/primitives/store.h"

namespace durer::tracer {
namespace {

using scene::NodeKind;
using scene::none;
using scene::Object;

/// What an object receives from those around it.
struct Context {
  Transform to_world;  // from the space around the object
  bool inverted = false;
  bool scenery = true;      // false: part of a clip or bound, never seen
  bool muted = false;       // part of a clip
  bool splits = true;       // a plain union here falls apart into its children
  bool flags_count = true;  // inside an intersection the flags of children do not (objects §9.2)
  bool whole = false;  // inside a union that is not split: some flags of children do not either
  bool merged = false;      // inside a merge: they cast shadows in any case
  std::uint8_t mask = seen_by_image | seen_by_transmission | seen_by_reflection | casts_shadow |
                      seen_by_gathering;
  float importance = 1;
  bool double_illuminate = false;
  std::optional<bool> hollow;
  scene::TextureUse texture{none, {}};  // texture space → world
  bool uv_mapping = false;              // of the textures
  scene::TextureUse interior_texture{none, {}};
  std::uint32_t interior = none;  // instance
  std::uint32_t gate = none;
  std::uint32_t direct_of = none;  // the light group whose direct child this is
  std::uint32_t lamps = 0;         // index into lamp_sets_
  PhotonTraits photons;
  bool cutaway = false;        // bare surfaces look like what they lie in (objects §9.5) …
  bool keeps_bare = false;     // … and the parent leaves its children without a texture
  bool filtered = false;       // inside a solid or clip, which decides what of it is seen
  bool received_by_uv = false;  // what shared contents receive from outside lies on the surface
  BoxedObject boxed;            // the outermost union around that is not split, if there is one

  friend bool operator==(const Context&, const Context&) = default;
};

/// Finds the surface that looks the same, so that thousands of objects can share one.
class SurfaceTable {
 public:
  explicit SurfaceTable(std::vector<Surface>& surfaces) : surfaces_(&surfaces) {}

  std::uint32_t add(const Surface& s) {
    const auto next = static_cast<std::uint32_t>(surfaces_->size());
    const auto [at, is_new] = known_.try_emplace(key(s), next);
    if (is_new) surfaces_->push_back(s);
    return at->second;
  }

 private:
  static void append(std::string& key, const SharedTransform& transform) {
    static_assert(sizeof(Affine) == 12 * sizeof(double), "an Affine is plain numbers");
    key.append(reinterpret_cast<const char*>(&transform->forward), sizeof(Affine));
  }
  static void append(std::string& key, const scene::TextureUse& use) {
    key.append(reinterpret_cast<const char*>(&use.texture), sizeof use.texture);
    if (use.texture != none && !use.transform.is_identity()) append(key, use.transform);
  }
  static std::string key(const Surface& s) {
    std::string key(1, s.double_illuminate ? '1' : '0');
    key += s.uv_mapping ? '1' : '0';
    const PhotonTraits& p = s.photons;
    for (const std::optional<bool>& said : {p.refraction, p.reflection, p.collect}) {
      key += said ? (*said ? '1' : '0') : '-';
    }
    key += p.pass_through ? '1' : '0';
    key.append(reinterpret_cast<const char*>(&p.target), sizeof p.target);
    key.append(reinterpret_cast<const char*>(&s.lamps), sizeof s.lamps);
    key.append(reinterpret_cast<const char*>(&s.cutaway), sizeof s.cutaway);
    key.append(reinterpret_cast<const char*>(&s.part_textures), sizeof s.part_textures);
    if (s.part_textures != nullptr && !s.part_transform.is_identity()) {
      append(key, s.part_transform);
    }
    append(key, s.texture);
    append(key, s.interior_texture);
    return key;
  }

  std::vector<Surface>* surfaces_;
  std::unordered_map<std::string, std::uint32_t> known_;
};

class Flattener {
 public:
  Flattener(const scene::Scene& scene, Diagnostics& diagnostics, const SharingLimits& limits)
      : scene_(scene),
        diagnostics_(diagnostics),
        sharing_(scene, limits),
        surfaces_(flat_.surfaces) {
    flat_.scene = &scene;
    flat_.noise_generator = scene.settings.resolved_noise_generator();
  }

  Flat run() {
    for (const scene::Root& root : scene_.roots) add_root(root, {});
    return finish();
  }

  Flat run(scene::ObjectId object, const Transform& to_world) {
    Context alone;
    alone.to_world = to_world;
    alone.flags_count = false;
    add_root({object, none}, alone);
    flat_.scene = nullptr;  // `inside` knows of no boxes
    return finish();
  }

 private:
  Flat finish() {
    flat_.world = std::move(world_);
    for (const LampSet& set : lamp_sets_) {
      flat_.lamp_sets.push_back(set.outside);
      flat_.lamp_sets.back().insert(flat_.lamp_sets.back().end(), set.inside.begin(),
                                    set.inside.end());
    }
    return std::move(flat_);
  }

  void add_root(const scene::Root& root, const Context& around) {
    default_texture_ = root.default_texture;
    if (const std::uint32_t node = visit(root.object, around); node != none) {
      const BoxedObject boxed{root.object, frame_of(around.to_world)};
      group_->entries.push_back({node, entry_interior_, none, boxed});
    }
  }

  /// Siblings, which are visited one after another, share theirs.
  std::uint32_t frame_of(const Transform& to_group) {
    if (to_group.is_identity()) return 0;
    if (!(flat_.frames.back() == to_group)) flat_.frames.push_back(to_group);
    return static_cast<std::uint32_t>(flat_.frames.size() - 1);
  }

  /// The node made for the object; none if it has fallen apart, or has no geometry.
  std::uint32_t visit(scene::ObjectId id, const Context& around) {
    const Object& object = scene_.objects[id];
    if (object.kind == NodeKind::unsupported || !object.extras->unsupported.empty()) {
      report(id, object);
      return none;
    }
    if (object.kind == NodeKind::light) return light(object, around);
    Context own = inherit(id, around);
    own.direct_of = none;
    if (object.kind == NodeKind::light_group) enter_group(object, own);
    if (scene_.settings.photons && own.scenery) inherit_photons(id, around, own);
    if (own.scenery && around.splits && !own.cutaway && depth_ < max_placement_depth &&
        object.extras->clips.empty() && sharing_.shares(object, own.to_world) &&
        !holds_targets(object)) {
      add_placement(id, own, around);
      return none;
    }
    const std::uint32_t body =
        object.kind == NodeKind::primitive ? add_leaf(object, own) : add_csg(object, own, around);
    if (body == none) return none;
    if (own.scenery) entry_interior_ = own.interior;
    return clip(object, around, body);
  }

  Context inherit(scene::ObjectId id, const Context& around) {
    const Object& object = scene_.objects[id];
    Context own = around;
    own.to_world = object.transform.then(around.to_world);
    own.inverted = around.inverted != object.inverse;
    own.double_illuminate = around.double_illuminate || object.double_illuminate;
    if (object.hollow) own.hollow = object.hollow;
    if (own.flags_count) {
      const auto hide_from = [&own](int who) { own.mask &= static_cast<std::uint8_t>(~who); };
      if (object.no_image) hide_from(seen_by_transmission | (around.whole ? 0 : seen_by_image));
      if (object.no_reflection) hide_from(seen_by_reflection);
      if (object.no_shadow && !around.whole && !around.merged) hide_from(casts_shadow);
      if (object.no_radiosity) hide_from(seen_by_gathering);
    }
    if (object.importance > 0) own.importance = object.importance;
    own.whole = object.kind == NodeKind::union_ &&
                (around.whole || !around.splits || stays_whole(object));
    if (own.whole && !around.whole) own.boxed = {id, frame_of(around.to_world)};
    own.merged = around.merged || object.kind == NodeKind::merge;
    if (!own.scenery) return own;
    const auto place = [&](const scene::TextureUse& use, scene::TextureUse& to) {
      if (use.texture == none) return;
      // Objects of one plain colour share a surface, wherever they are.
      const bool moves = !object.uv_mapping && scene::has_place(scene_.textures[use.texture]);
      to = moves ? scene::TextureUse{use.texture, use.transform.then(around.to_world)}
                 : scene::TextureUse{use.texture, object.uv_mapping ? use.transform : SharedTransform()};
      own.uv_mapping = object.uv_mapping;
    };
    own.uv_mapping = around.uv_mapping || object.uv_mapping;
    place(object.texture, own.texture);
    place(object.extras->interior_texture, own.interior_texture);
    own.cutaway = around.cutaway || object.cutaway_textures;
    if (own.cutaway && own.texture.texture == none && !around.keeps_bare && !has_texture(id)) {
      own.texture = {default_texture_, {}};
    }
    if (object.interior != none || own.interior == none) {
      own.interior = static_cast<std::uint32_t>(group_->interiors.size());
      SharedTransform media;
      if (object.interior != none && !scene_.interiors[object.interior].media->empty()) {
        media = object.extras->media_transform.then(around.to_world);
      }
      group_->interiors.push_back({object.interior, false, media});
    }
    group_->interiors[own.interior].hollow = own.hollow.value_or(false);
    if (!object.extras->bounds.empty()) add_gate(id, around, own);
    return own;
  }

  void inherit_photons(scene::ObjectId id, const Context& around, Context& own) {
    const scene::ObjectPhotons& said = scene_.objects[id].extras->photons;
    PhotonTraits& p = own.photons;
    // The outermost who says something decides.
    if (!p.refraction) p.refraction = said.refraction;
    if (!p.reflection) p.reflection = said.reflection;
    if (!p.collect) p.collect = said.collect;
    p.pass_through = p.pass_through || said.pass_through;
    if (said.target == 0 || p.target != none || !lamp_sets_[own.lamps].global) return;
    p.target = static_cast<std::uint32_t>(flat_.photon_targets.size());
    flat_.photon_targets.push_back({said.target, p.refraction, p.reflection, p.collects(),
                                    extent_of(scene_, id, around.to_world)});
  }

  // Photons are sent to places, so a target is one thing in one place.
  bool holds_targets(const Object& object) {
    if (!scene_.settings.photons) return false;
    const auto [known, is_new] = holds_targets_.try_emplace(object.children.identity(), false);
    if (!is_new) return known->second;
    const bool holds =
        std::any_of(object.children.begin(), object.children.end(), [&](scene::ObjectId child) {
          const Object& o = scene_.objects[child];
          return o.extras->photons.target > 0 || (!o.children.empty() && holds_targets(o));
        });
    return holds_targets_[object.children.identity()] = holds;
  }

  // The oracle splits unions into their children, but not those that are clipped, or bounded and
  // finite. Of what is not split, all casts shadows and is seen, or nothing (objects §9.2).
  bool stays_whole(const Object& object) {
    if (object.kind != NodeKind::union_) return false;
    if (object.kept_whole || !object.extras->clips.empty()) return true;
    if (object.extras->bounds.empty()) return false;
    const auto [known, is_new] = endless_.try_emplace(object.children.identity(), false);
    if (is_new) {
      known->second = std::any_of(
          object.children.begin(), object.children.end(),
          [&](scene::ObjectId child) { return extent_of(scene_, child).infinite(); });
    }
    return !known->second;
  }

  std::uint32_t add_leaf(const Object& object, const Context& own) {
    FlatLeaf part{&object, SharedTransform(own.to_world), own.inverted, own.muted, false,
                  own.mask, own.gate, none};
    if (own.scenery) {
      Surface surface;
      surface.texture = own.texture;
      surface.interior_texture = own.interior_texture;
      surface.double_illuminate = own.double_illuminate;
      surface.uv_mapping = own.uv_mapping;
      surface.lamps = own.lamps;
      surface.photons = own.photons;
      const std::vector<scene::TextureId>& parts = object.extras->mesh != nullptr
                                                       ? object.extras->mesh->textures
                                                       : object.extras->part_textures;
      if (!parts.empty()) {
        surface.part_textures = &parts;
        if (!own.uv_mapping) surface.part_transform = own.to_world;
      }
      if (own.cutaway && surface.texture.texture == none) surface.cutaway = cutaway();
      if (surface.texture.texture == none) surface.texture = {default_texture_, {}};
      part.by_uv = surface.cutaway != none || needs_uv(surface, own);
      part.leaf = static_cast<std::uint32_t>(flat_.leaves.size());
      group_->interiors[own.interior].texture = surface.texture.texture;
      flat_.leaves.push_back({surfaces_.add(surface), own.interior, object.origin, own.importance});
    }
    flat_.parts.push_back(part);
    return add_node({Op::leaf, {}, static_cast<std::uint32_t>(flat_.parts.size() - 1), {}});
  }

  // Inversion goes down to the leaves: the inverse of a union is the intersection of the inverses,
  // that of an intersection the merge of the inverses (objects §8.5).
  static Op op_of(NodeKind kind, bool inverted) {
    if (kind == NodeKind::intersection || kind == NodeKind::difference) {
      return inverted ? Op::merge : Op::all;
    }
    if (inverted) return Op::all;
    return kind == NodeKind::merge ? Op::merge : Op::any;
  }

  std::uint32_t add_csg(const Object& object, const Context& own, const Context& around) {
    const Op op = op_of(object.kind, own.inverted);
    Context inner = own;
    inner.splits = around.splits && op == Op::any && object.extras->clips.empty();
    inner.flags_count = own.flags_count && op != Op::all;
    inner.keeps_bare = own.cutaway && op == Op::all;
    inner.filtered = own.filtered || op != Op::any || !object.extras->clips.empty();
    const bool outermost = inner.filtered && !own.filtered;
    const std::uint32_t cutaway_around = outermost ? std::exchange(cutaway_, none) : none;
    FlatNode node{op, Lenders::all, none, {}};
    if (object.kind == NodeKind::difference && op == Op::all) node.lenders = Lenders::first;
    for (std::size_t i = 0; i < object.children.size(); ++i) {
      inner.inverted = own.inverted != (object.kind == NodeKind::difference && i > 0);
      const std::uint32_t child = visit(object.children[i], inner);
      if (child == none && i == 0 && node.lenders == Lenders::first) node.lenders = Lenders::nobody;
      if (child == none) continue;
      if (inner.splits) {
        const BoxedObject boxed =
            inner.whole ? inner.boxed : BoxedObject{object.children[i], frame_of(inner.to_world)};
        group_->entries.push_back({child, entry_interior_, none, boxed});
      } else {
        node.children.push_back(child);
      }
    }
    const std::uint32_t index = node.children.empty() ? none : add_node(std::move(node));
    if (outermost) {
      if (cutaway_ != none) flat_.cutaways[cutaway_] = index;
      cutaway_ = cutaway_around;
    }
    return index;
  }

  /// That of the outermost solid around, which is being visited.
  std::uint32_t cutaway() {
    if (cutaway_ == none) {
      cutaway_ = static_cast<std::uint32_t>(flat_.cutaways.size());
      flat_.cutaways.push_back(none);
    }
    return cutaway_;
  }

  /// True if the object or anything in it has a texture of its own.
  [[nodiscard]] bool has_texture(scene::ObjectId id) const {
    const Object& object = scene_.objects[id];
    return object.texture.texture != none ||
           std::any_of(object.children.begin(), object.children.end(),
                       [this](scene::ObjectId child) { return has_texture(child); });
  }

  /// Clipping keeps what lies inside all clips, and makes no caps: the clips take part as an
  /// intersection whose surfaces are never seen.
  std::uint32_t clip(const Object& object, const Context& around, std::uint32_t body) {
    if (object.extras->clips.empty()) return body;
    // The oracle's patches take no notice of clips of their own, only of those around them.
    if (object.kind == NodeKind::primitive &&
        primitive_infos()[object.type]->name == "bicubic_patch") {
      return body;
    }
    FlatNode node{Op::all, Lenders::body, none, {body}};
    Context hidden = behind_the_scenes(object.extras->clip_transform, around);
    hidden.muted = true;
    for (const scene::ObjectId id : object.extras->clips) {
      if (const std::uint32_t child = visit(id, hidden); child != none) {
        node.children.push_back(child);
      }
    }
    return add_node(std::move(node));
  }

  // The oracle drops the bounds of primitives that stand alone, but keeps the box that they left
  // behind; elsewhere the bounds themselves are asked (objects §7, "Removal of user bounds").
  void add_gate(scene::ObjectId id, const Context& around, Context& own) {
    const Object& object = scene_.objects[id];
    FlatGate gate;
    gate.outer = around.gate;
    const bool drops_bounds =
        object.kind == NodeKind::primitive && !primitive_infos()[object.type]->keeps_bounds;
    if (drops_bounds && around.splits) {
      const auto box = bounding_box_of(scene_, id, around.to_world);
      if (!box) return;
      gate.box = *box;
    } else {
      const Context hidden = behind_the_scenes(object.extras->bound_transform, around);
      for (const scene::ObjectId bound : object.extras->bounds) {
        if (const auto node = visit(bound, hidden); node != none) gate.nodes.push_back(node);
      }
      if (gate.nodes.empty()) return;
    }
    own.gate = static_cast<std::uint32_t>(flat_.gates.size());
    flat_.gates.push_back(std::move(gate));
  }

  static Context behind_the_scenes(const Transform& space, const Context& around) {
    Context hidden;
    hidden.to_world = space.then(around.to_world);
    hidden.scenery = false;
    hidden.splits = false;
    hidden.mask = 0;
    return hidden;
  }

  /// A lamp, and what stands in its place if it looks like something.
  std::uint32_t light(const Object& object, const Context& around) {
    if (around.scenery) add_light(object, around);
    if (object.children.empty()) return none;
    Context own = around;
    own.to_world = object.transform.then(around.to_world);
    own.direct_of = none;
    own.photons.pass_through = true;  // the lamp's own light does not stop there
    return visit(object.children[0], own);
  }

  void add_light(const Object& object, const Context& around) {
    scene::Light light = scene_.lights[object.light];
    const Transform to_world = object.transform.then(around.to_world);
    light.position = to_world.point(light.position);
    light.point_at = to_world.point(light.point_at);
    light.area.u = to_world.vector(light.area.u);
    light.area.v = to_world.vector(light.area.v);
    const auto id = static_cast<std::uint32_t>(flat_.lights.size());
    if (light.projected_through != none) {
      flat_.projections.push_back({id, light.projected_through, to_world});
    }
    flat_.lights.push_back(light);
    const bool grouped = around.direct_of != none;
    for (LampSet& set : lamp_sets_) {
      if (grouped && set.group == around.direct_of) set.inside.push_back(id);
      if (!grouped && set.global) set.outside.push_back(id);
    }
  }

  // The outermost group tells whether lamps outside of it count; of groups inside of each other, the
  // innermost that has lamps of its own lights what is in it.
  void enter_group(const Object& group, Context& own) {
    LampSet set = lamp_sets_[own.lamps];
    if (own.lamps == 0) {
      set.global = group.global_lights;
      if (!set.global) set.outside.clear();
    }
    own.direct_of = groups_++;
    if (std::any_of(group.children.begin(), group.children.end(), [&](scene::ObjectId id) {
          return scene_.objects[id].kind == NodeKind::light;
        })) {
      set.group = own.direct_of;
      set.inside.clear();
    }
    own.lamps = static_cast<std::uint32_t>(lamp_sets_.size());
    lamp_sets_.push_back(std::move(set));
  }

  /// What shared contents inherit: everything that is the same for all placements of them. Textures
  /// and the interior that come from outside are received, and looked up where they are placed.
  Context received(const Context& own) const {
    Context inner = own;
    inner.to_world = {};
    inner.texture = {texture_of_placement, {}};
    if (own.interior_texture.texture != none) inner.interior_texture = inner.texture;
    inner.interior = 0;
    inner.gate = none;
    inner.boxed = {};  // the placement has it
    inner.received_by_uv = own.received_by_uv || by_uv(own.texture.texture) ||
                           by_uv(own.interior_texture.texture);
    return inner;
  }

  void add_placement(scene::ObjectId id, const Context& own, const Context& around) {
    const Object& object = scene_.objects[id];
    Placement placement;
    placement.to_outer = own.to_world;
    placement.group = group_of(object, received(own));
    placement.gate = own.gate;
    const FlatGroup& contents = flat_.groups[placement.group];
    if (contents.entries.empty()) return;
    Surface surface;
    surface.texture = own.texture;
    surface.interior_texture = own.interior_texture;
    if (surface.texture.texture == none) surface.texture = {default_texture_, {}};
    placement.surface = surfaces_.add(surface);
    placement.interior = own.interior;
    placement.first_interior = static_cast<std::uint32_t>(group_->interiors.size()) - 1;
    add_interiors(contents, own, surface.texture.texture);
    BoxedObject boxed = own.boxed;
    const bool falls_apart = op_of(object.kind, own.inverted) == Op::any;
    if (!falls_apart && !around.whole) boxed = {id, frame_of(around.to_world)};
    group_->entries.push_back(
        {none, own.interior, static_cast<std::uint32_t>(flat_.placements.size()), boxed});
    flat_.placements.push_back(placement);
  }

  /// Every placement is matter of its own.
  void add_interiors(const FlatGroup& contents, const Context& own, scene::TextureId texture) {
    const auto resolved = [&](InteriorInstance instance) {
      instance.to_world = instance.to_world.then(own.to_world);
      if (instance.texture == texture_of_placement) instance.texture = texture;
      return instance;
    };
    const InteriorInstance first = resolved(contents.interiors[0]);
    InteriorInstance& outer = group_->interiors[own.interior];
    outer.hollow = first.hollow;
    if (first.texture != none) outer.texture = first.texture;
    for (std::size_t i = 1; i < contents.interiors.size(); ++i) {
      group_->interiors.push_back(resolved(contents.interiors[i]));
    }
  }

  /// The contents of the object as they look to all who inherit the same.
  std::uint32_t group_of(const Object& object, const Context& inner) {
    std::vector<KnownGroup>& known = known_groups_[object.children.identity()];
    for (const KnownGroup& k : known) {
      if (k.inner == inner) return k.group;
    }
    FlatGroup group;
    group.interiors.push_back({none, inner.hollow.value_or(false)});
    FlatGroup* const outer = std::exchange(group_, &group);
    const std::uint32_t outer_interior = std::exchange(entry_interior_, 0);
    ++depth_;
    const std::uint32_t node = add_csg(object, inner, inner);
    if (node != none) group.entries.push_back({node, 0, none, {}});
    --depth_;
    entry_interior_ = outer_interior;
    group_ = outer;
    const auto index = static_cast<std::uint32_t>(flat_.groups.size());
    flat_.groups.push_back(std::move(group));
    known_groups_[object.children.identity()].push_back({inner, index});
    return index;
  }

  std::uint32_t add_node(FlatNode node) {
    flat_.nodes.push_back(std::move(node));
    return static_cast<std::uint32_t>(flat_.nodes.size() - 1);
  }

  [[nodiscard]] bool needs_uv(const Surface& surface, const Context& own) const {
    return own.received_by_uv || surface.uv_mapping || by_uv(surface.texture.texture) ||
           by_uv(surface.interior_texture.texture);
  }

  // True if anything in a texture lies on the surface rather than in space.
  [[nodiscard]] bool by_uv(scene::TextureId id) const {
    if (id == none || id == texture_of_placement) return false;
    const scene::Texture& t = scene_.textures[id];
    return t.uv_mapping || scene::uses_uv(*t.pattern) ||
           std::any_of(t.layers.begin(), t.layers.end(),
                       [](const scene::Layer& l) {
                         return scene::uses_uv(*l.pigment) || scene::uses_uv(*l.normal);
                       }) ||
           std::any_of(t.entries.begin(), t.entries.end(),
                       [&](const scene::TextureEntry& e) { return by_uv(e.texture); });
  }

  void report(scene::ObjectId id, const Object& object) {
    if (!reported_.insert(id).second) return;
    report(object,
           object.extras->unsupported.empty() ? std::string_view("object") : object.extras->unsupported);
  }

  void report(const Object& object, std::string_view what) {
    Diagnostic d;
    d.code = Code::not_supported;
    d.span = scene_.origins[object.origin].span;
    d.message = std::string(what) + " is not supported yet";
    for (auto at = scene_.origins[object.origin].parent; at != 0; at = scene_.origins[at].parent) {
      d.trace.push_back({scene_.origins[at].span, "expanded from here"});
    }
    diagnostics_.report(std::move(d));
  }

  const scene::Scene& scene_;
  Diagnostics& diagnostics_;
  struct KnownGroup {
    Context inner;
    std::uint32_t group = 0;
  };

  Sharing sharing_;
  Flat flat_;
  FlatGroup world_;
  FlatGroup* group_ = &world_;  // to which entries, interiors and lights are added
  std::uint32_t depth_ = 0;     // of shared contents around
  std::unordered_map<const void*, std::vector<KnownGroup>> known_groups_;  // by Object::children
  SurfaceTable surfaces_;
  /// Who lights an object: what it inherits from the light groups around it. Set 0: no group.
  struct LampSet {
    std::uint32_t group = none;          // whose lamps light it
    bool global = true;                  // lamps outside of any group do, too
    std::vector<std::uint32_t> outside;  // lamps: those of the scene …
    std::vector<std::uint32_t> inside;   // … then those of groups
  };
  std::vector<LampSet> lamp_sets_{1};
  std::uint32_t groups_ = 0;
  std::unordered_map<const void*, bool> endless_;  // by Object::children
  std::unordered_map<const void*, bool> holds_targets_;  // likewise
  scene::TextureId default_texture_ = none;
  std::uint32_t cutaway_ = none;      // of the outermost solid being visited; none: not needed yet
  std::uint32_t entry_interior_ = 0;  // of the object that `visit` has just returned
  std::unordered_set<scene::ObjectId> reported_;
};

}  // namespace

Flat flatten(const scene::Scene& scene, Diagnostics& diagnostics, const SharingLimits& limits) {
  return Flattener(scene, diagnostics, limits).run();
}

Flat flatten_object(const scene::Scene& scene, scene::ObjectId object, Diagnostics& diagnostics,
                    const Transform& to_world) {
  return Flattener(scene, diagnostics, {}).run(object, to_world);
}

}  // namespace durer::tracer
