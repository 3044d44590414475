// All components of a blob, and what a line meets of them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tracer/accel/wide_walk.h"
#include "tracer/primitives/blob_field.h"

namespace durer::tracer {

/// What one line meets, filled by BlobData::gather.
struct BlobLine {
  double t_from = 0;
  double t_to = 0;
  std::vector<BlobStretch> stretches;
  std::vector<const BlobStretch*> order;   // by their beginnings
  std::vector<const BlobStretch*> active;  // those of the place that a sweep has come to

  /// This thread's line, empty.
  static BlobLine& of_thread(double t_from, double t_to);
  /// The sum of what begins where the line does.
  [[nodiscard]] double field_at_begin() const;
};

/// How far a line is followed.
enum class BlobReach : std::uint8_t {
  whole,
  to_first,  // until some component is strong enough by itself: one that begins outside ends there
  any_full,  // the same, but nothing else is wanted if there is such a place
};

/// What all objects that show one blob share.
class BlobData {
 public:
  /// `list`: see blob_components.
  BlobData(double threshold, std::span<const double> list);

  /// Fills the line with what it meets in t_from…t_to, or as far as `reach` says; true if
  /// `any_full` found a place.
  bool gather(const Ray& ray, BlobReach reach, BlobLine& line) const;

  /// How the field falls at a point.
  [[nodiscard]] dvec3 fall(dvec3 p) const;

  /// Calls f(component) for those that may be felt at `p`.
  template <typename F>
  void each_near(dvec3 p, F&& f) const {
    wide::at(tree, p, [&](std::uint32_t i) {
      const Block& block = blocks[i];
      for (std::size_t k = 0; k < block.count; ++k) f(components[block.component[k]]);
    });
  }
  /// Of what every component reaches.
  [[nodiscard]] const Bounds3& bounds() const { return tree.bounds; }

  static constexpr std::size_t block_size = 4;
  /// Components that lie next to each other: balls, or the balls around what is none.
  struct alignas(32) Block {
    std::array<double, block_size> x, y, z, radius2;
    std::array<double, block_size> strength;  // 0: no ball, ask the component
    std::array<double, block_size> full;      // see BlobComponent
    std::array<std::uint32_t, block_size> component;
    std::uint32_t count = 0;
    unsigned others = 0;  // a bit for each that is no ball
  };

  double threshold = 1;
  std::vector<BlobComponent> components;
  std::vector<Block> blocks;
  WideNodes tree;  // over the blocks
  Bounds3 seen;    // where the surface may lie
  bool textured = false;
};

}  // namespace durer::tracer
