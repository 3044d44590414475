// Bumps as flat programs: from a point and a normal to the normal that light sees (textures §13).
#pragma once

#include <cstdint>
#include <glm/geometric.hpp>
#include <vector>

#include "scene/texture.h"
#include "tracer/patterns/program.h"

namespace durer::tracer {

/// Index of a node of a NormalStore.
using NormalId = std::uint32_t;

/// The way of a normal into the space of a pattern and back. It keeps the depth of bumps in
/// proportion to their size, which no transformation of normals proper would (textures §13.1).
class NormalFrame {
 public:
  NormalFrame() = default;
  /// `keep_scale`: the word `no_bump_scale`, lengths are left as they are.
  NormalFrame(const scene::Pattern& pattern, const Transform& to_world, bool keep_scale);

  [[nodiscard]] dvec3 enter(dvec3 n) const {
    if (moved_) n = into_.covector(n);
    return keep_scale_ ? n : glm::normalize(n);
  }
  [[nodiscard]] dvec3 leave(dvec3 n) const {
    if (!keep_scale_) n = glm::normalize(n);
    if (!moved_) return n;
    n = back_.covector(n);
    return keep_scale_ ? n : glm::normalize(n);
  }

 private:
  bool moved_ = false;
  bool keep_scale_ = false;
  Affine into_;
  Affine back_;
};

/// All normals of a compiled scene.
class NormalStore {
 public:
  explicit NormalStore(const scene::Settings& settings = {}) : patterns_(settings) {}

  /// Adds a normal and everything below it; `to_world` leads from the space around it to the world.
  NormalId add(const scene::Normal& normal, const Transform& to_world);

  /// What becomes of the normal `n` at `p`, both in the space around the normal. Not of unit
  /// length if the word `no_bump_scale` says so.
  [[nodiscard]] dvec3 at(NormalId id, const dvec3& p, const dvec3& n,
                         const SurfaceView* view) const;

  /// The same at several points, for a normal each, in place. `points` are moved about meanwhile.
  /// Not for what asks for a view, or is looked up at (u, v, 0).
  static constexpr std::size_t most_points = 16;
  void at(NormalId id, std::span<dvec3> points, dvec3* normals) const;

 private:
  struct Entry {
    float key;
    NormalId child;
  };
  struct Node {
    PatternProgram pattern;
    NormalFrame frame;
    float amount = 0.5F;
    float accuracy = 0.02F;
    std::uint32_t first_entry = 0;  // none: the pattern itself makes the bumps
    std::uint32_t end_entry = 0;
    std::uint32_t first_slope = 0;
    std::uint32_t end_slope = 0;
    bool by_uv = false;  // looked up at (u, v, 0)
  };

  [[nodiscard]] dvec3 perturbed(const Node& node, const dvec3& p, const dvec3& n,
                                const SurfaceView* view) const;
  [[nodiscard]] dvec3 average(const Node& node, const dvec3& p, const dvec3& n,
                              const SurfaceView* view) const;
  [[nodiscard]] dvec3 blend(const Node& node, const dvec3& p, const dvec3& n,
                            const SurfaceView* view) const;
  [[nodiscard]] dvec3 slide(const Node& node, const dvec3& p, const dvec3& n,
                            const SurfaceView* view) const;
  void heights(const Node& node, std::span<const dvec3> points, const SurfaceView* view,
               double* out) const;
  [[nodiscard]] double height(const Node& node, double value) const;

  PatternStore patterns_;
  std::vector<Node> nodes_;
  std::vector<Entry> entries_;
  std::vector<scene::SlopeEntry> slopes_;
};

}  // namespace durer::tracer
