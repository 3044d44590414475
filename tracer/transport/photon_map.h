// Photons in space, and those nearest to a point (participating-and-global §3.7-3.9; Jensen,
// "Realistic Image Synthesis Using Photon Mapping", 2001).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.h"

namespace durer::tracer {

/// A photon where it was caught. World space.
struct Photon {
  vec3 p{0.0F};
  vec3 power{0.0F};
  vec3 l{0.0F};  // unit, back to where it came from
};

/// Which photons are wanted.
struct PhotonQuery {
  dvec3 p{0.0};
  dvec3 n{0.0};  // unit: photons off this plane count as farther away; 0: all directions are alike
  std::size_t most = 0;
  double radius = 0;
};

/// The photons around a point that somebody found last. Keeps its memory, and remembers how large
/// answers were: the next question is mostly asked near an earlier one.
struct FoundPhotons {
  std::vector<std::uint32_t> indices;  // of PhotonMap, ascending
  std::vector<float> distances2;       // squares, as the question measures them; parallel
  std::size_t count = 0;               // the buffers may be longer
  double radius = 0;                   // of the region that they stand for

  // How far away the last of the photons wanted is, around the points of a cell of space. No radius:
  // nothing is known.
  struct Hint {
    std::uint32_t cell = 0;
    float radius = 0;
  };
  std::array<Hint, 512> hints;  // by cell, as far as there is room
  float last_radius = 0;

  [[nodiscard]] std::span<const std::uint32_t> photons() const { return {indices.data(), count}; }
};

/// A tree over blocks of photons. Immutable; answers do not depend on the thread, nor on what was
/// asked before.
class PhotonMap {
 public:
  PhotonMap() = default;
  explicit PhotonMap(std::vector<Photon> photons);

  [[nodiscard]] bool empty() const { return photons_.empty(); }
  [[nodiscard]] std::size_t size() const { return photons_.size(); }
  [[nodiscard]] const Photon& operator[](std::uint32_t i) const { return photons_[i]; }

  /// Fills `found` with the photons within the query's radius, the nearest ones if there are more
  /// than `most` (of those equally far, the first ones). Its radius becomes that of the query, or
  /// the distance of the last one if others had to be left out.
  void nearest(const PhotonQuery& query, FoundPhotons& found) const;

 private:
  static constexpr std::size_t lanes = 8;
  // Where the photons of one leaf are; what is missing in the last one is infinitely far away.
  struct Block {
    std::array<float, lanes> x, y, z;
  };
  // The boxes around its children, which lie one after the other: blocks, or nodes of the level
  // below. Boxes that are missing are infinitely far away.
  struct Node {
    std::array<std::array<float, lanes>, 3> lo, hi;
    std::uint32_t first = 0;
  };
  class Search;

  void order_blocks(std::span<std::uint32_t> order, const std::vector<Photon>& from);
  void add_nodes();
  void set_boxes(std::size_t level, Node& node, std::size_t children) const;

  std::vector<Photon> photons_;  // in the order of the blocks
  std::vector<Block> blocks_;
  std::vector<std::vector<Node>> levels_;  // from those of blocks up to the one of all
};

/// How photons around a point are looked for: at first within a radius; then, if they are few,
/// within a larger one (participating-and-global §3.9).
struct PhotonGathering {
  std::size_t least = 20;
  std::size_t most = 100;
  double radius = 0;
  double expand_increase = 0.2;  // of their density that a larger radius may bring
  std::size_t expand_min = 35;   // below so many it may bring any
};

/// Finds the photons around `p`.
void gather(const PhotonMap& map, const PhotonGathering& how, dvec3 p, dvec3 n,
            FoundPhotons& found);

/// A radius that holds about as many photons as wanted where they are as dense as usual
/// (participating-and-global §3.8). `flat`: they lie on surfaces.
[[nodiscard]] double usual_radius(const PhotonMap& map, std::size_t most, bool flat);

}  // namespace durer::tracer
