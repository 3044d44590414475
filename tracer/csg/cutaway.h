// `cutaway_textures`: a bare surface of a solid looks like whatever it lies in (objects §9.5).
#pragma once

#include <cstdint>
#include <vector>

#include "tracer/csg/build.h"

namespace durer::tracer {

/// The outermost solid around bare surfaces: who holds a point, and has a texture to lend.
class Cutaway {
 public:
  struct Node {
    Op op = Op::leaf;
    Lenders lenders = Lenders::all;
    std::vector<std::uint32_t> children;
    // Of a leaf:
    const Store* store = nullptr;  // null: it has neither surface nor inside
    std::uint32_t shape = 0;
    bool inverted = false;
    std::uint32_t leaf = scene::none;     // none: part of a clip
    std::uint32_t surface = scene::none;  // none: nothing to lend
  };

  /// Children before parents; the last one is the solid itself.
  explicit Cutaway(std::vector<Node> nodes) : nodes_(std::move(nodes)) {}

  /// The surfaces that lend their textures to the world point `p` of `leaf`, in equal parts. Where
  /// there are none, two parts of no weight. `p` lies on the border of that leaf, and in it if it is
  /// seen from inside: rounding must not decide that.
  [[nodiscard]] TextureBlend lenders(dvec3 p, std::uint32_t leaf, bool from_inside) const;

 private:
  struct Place {
    dvec3 p;
    std::uint32_t leaf;
    bool in_leaf;
  };
  [[nodiscard]] bool holds(const Node& node, const Place& at) const;
  [[nodiscard]] bool lends(const Node& node, const Place& at) const;
  void gather(const Node& node, const Place& at, TextureBlend& out) const;

  std::vector<Node> nodes_;
};

[[nodiscard]] Cutaway make_cutaway(const Flat& flat, std::uint32_t root,
                                   const std::vector<Leaf>& leaves, const PlacePart& place);

}  // namespace durer::tracer
