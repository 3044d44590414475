// Arrays of compiled primitives, one per type and kind of placement. The virtual functions here are
// called per type and batch, or once per hit; what runs per object is `nearest`, a plain function
// that was compiled for the type.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/bounds.h"
#include "base/ray.h"
#include "tracer/primitives/crossing.h"
#include "tracer/primitives/packet.h"
#include "tracer/primitives/shaft_hull.h"

namespace durer::tracer {

/// Who may see an object; a query sees it if the masks share a bit.
enum Visibility : std::uint8_t {
  seen_by_image = 1,
  seen_by_reflection = 2,
  casts_shadow = 4,
  blocks_light = 8,  // casts shadow and is opaque: no light passes at all
  seen_by_gathering = 16,
  seen_by_transmission = 32,
};

/// What hangs on a primitive besides its shape. Read only after the shape was hit.
struct Tag {
  std::uint32_t leaf = 0;
  std::uint8_t mask = 0;
  bool gated = false;  // the leaf has bounds that a ray must meet (objects §4)
};

/// A program's leaf and where its shape lies in the store.
struct LeafShape {
  std::uint32_t leaf = 0;
  std::uint32_t shape = 0;
};

struct RayQuery;

/// Objects of one sort, as the hierarchy sees them: boxes, and one function to ask.
class Targets {
 public:
  virtual ~Targets() = default;

  /// Lowers `query.t_to` and fills `query.found` if object `index` has a visible hit in range.
  using NearestFunction = void (*)(const Targets& targets, std::uint32_t index, RayQuery& query);
  /// The same for at most most_in_packet queries, which see the object at once.
  using NearestTogether = void (*)(const Targets& targets, std::uint32_t index,
                                   std::span<RayQuery* const> queries);
  /// The hits of a packet (of at least one ray) with object `index`, whoever may see it; `any`:
  /// some hit in the range will do.
  using PacketFunction = void (*)(const Targets& targets, std::uint32_t index,
                                  const PacketRays& rays, bool any, PacketHits& hits);

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(tags.size()); }
  /// World box of the surface that can be seen.
  [[nodiscard]] virtual Bounds3 surface_bounds(std::uint32_t index) const = 0;

  /// True if no ray inside of `hull` can meet object `index`, as far as that is found out quickly;
  /// more than its box says.
  [[nodiscard]] virtual bool misses(std::uint32_t /*index*/, const ShaftHull& /*hull*/) const {
    return false;
  }

  NearestFunction nearest = nullptr;
  /// Null: these objects answer one ray at a time. Others do not answer a query that has a list
  /// (RayQuery::later), but put themselves on it.
  NearestTogether nearest_together = nullptr;
  PacketFunction packet = nullptr;  // of the same objects
  std::vector<Tag> tags;
};

/// Textures that a part of an object brings, each with its share of the point.
struct TextureBlend {
  struct Part {
    std::uint32_t texture;  // index into the textures of the object; scene::none: its own
    float weight;
  };
  static constexpr std::uint32_t most = 16;
  std::array<Part, most> parts;  // not set beyond `count`: every hit makes one of these
  std::uint32_t count = 0;       // 0: the part looks like the object

  /// What there is no room for is left out; blobs have few components in one place.
  void add(std::uint32_t texture, float weight) {
    if (count < most) parts[count++] = {texture, weight};
  }
};

/// Placed primitives of one type.
class Store : public Targets {
 public:
  /// World box of the inside: everything, for half-spaces.
  [[nodiscard]] virtual Bounds3 inside_bounds(std::uint32_t index) const = 0;
  /// Where the inside can be within `box`: all of the box, if nothing better is known.
  [[nodiscard]] virtual Bounds3 inside_within(std::uint32_t index, const Bounds3& box) const = 0;
  [[nodiscard]] virtual bool contains(std::uint32_t index, dvec3 p) const = 0;
  /// World unit normal at the world point `p`, outward (of the primitive before any inversion).
  [[nodiscard]] virtual dvec3 normal(std::uint32_t index, dvec3 p, std::uint32_t part) const = 0;
  /// The same at several points of one shape, at least one.
  virtual void normals(std::uint32_t index, const PacketPoints& points,
                       PacketVectors& out) const = 0;
  /// Where the world point `p` lies on the surface. Objects without such coordinates use the
  /// world's x and y (objects §14).
  [[nodiscard]] virtual dvec2 uv(std::uint32_t index, dvec3 p, std::uint32_t part) const = 0;
  [[nodiscard]] virtual bool has_uv() const = 0;
  [[nodiscard]] virtual TextureBlend textures(std::uint32_t index, dvec3 p,
                                              std::uint32_t part) const = 0;
  /// Appends the crossings of the whole line with each of `leaves`, and to `begun` those leaves
  /// whose inside holds the line's beginning at t = -infinity.
  virtual void crossings(std::span<const LeafShape> leaves, const Ray& ray, Crossings& out,
                         std::vector<std::uint32_t>& begun) const = 0;
  /// What came to light about a shape while it was asked, as a message and its remedy; both are
  /// empty if nothing did.
  [[nodiscard]] virtual std::pair<std::string, std::string> doubt(std::uint32_t index) const = 0;
  /// True if the inside is convex: a box lies in it if its corners do.
  [[nodiscard]] virtual bool convex() const = 0;
};

}  // namespace durer::tracer
