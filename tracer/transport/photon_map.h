// Photons in space, and those nearest to a point (participating-and-global §3.7-3.9; Jensen,
// "Realistic Image Synthesis Using Photon Mapping", 2001).
#pragma once

#include <array>
#include <bit>
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

/// One of the photons around a point, in one number that sorts by distance.
class NearPhoton {
 public:
  NearPhoton() = default;
  NearPhoton(float distance2, std::uint32_t index)
      : key_(std::uint64_t{std::bit_cast<std::uint32_t>(distance2)} << 32 | index) {}

  /// Square of its distance, as the question measures it.
  [[nodiscard]] float distance2() const {
    return std::bit_cast<float>(static_cast<std::uint32_t>(key_ >> 32));
  }
  /// Of PhotonMap.
  [[nodiscard]] std::uint32_t index() const { return static_cast<std::uint32_t>(key_); }

  friend bool operator<(NearPhoton a, NearPhoton b) { return a.key_ < b.key_; }

 private:
  std::uint64_t key_ = 0;
};

/// Which photons are wanted.
struct PhotonQuery {
  dvec3 p{0.0};
  dvec3 n{0.0};  // unit: photons off this plane count as farther away; 0: all directions are alike
  std::size_t most = 0;
  double radius = 0;
};

/// A balanced kd-tree over blocks of photons. Immutable; answers do not depend on the thread.
class PhotonMap {
 public:
  PhotonMap() = default;
  explicit PhotonMap(std::vector<Photon> photons);

  [[nodiscard]] bool empty() const { return photons_.empty(); }
  [[nodiscard]] std::size_t size() const { return photons_.size(); }
  [[nodiscard]] const Photon& operator[](std::uint32_t i) const { return photons_[i]; }

  /// Fills `found` with the photons within the query's radius, the nearest ones if there are more
  /// than `most`, in no particular order. Returns the radius of the region that they stand for: that
  /// of the query, or the distance of the last one if others had to be left out.
  double nearest(const PhotonQuery& query, std::vector<NearPhoton>& found) const;

 private:
  static constexpr std::size_t lanes = 8;
  // Where the photons of one leaf are; what is missing in the last one is infinitely far away.
  struct Block {
    std::array<float, lanes> x, y, z;
  };
  // Where a range of blocks is cut: those before `Tree` index i hold photons up to `at`.
  struct Cut {
    float at = 0;
    std::uint32_t axis = 0;
  };
  class Search;

  void build(std::span<std::uint32_t> order, const std::vector<Photon>& from, std::size_t first);

  std::vector<Photon> photons_;  // in the order of the blocks
  std::vector<Block> blocks_;
  std::vector<Cut> cuts_;  // by the first block behind the cut
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

/// The photons around a point that somebody found last.
struct FoundPhotons {
  std::vector<NearPhoton> photons;
  double radius = 0;  // that they stand for
};

/// Finds the photons around `p`.
void gather(const PhotonMap& map, const PhotonGathering& how, dvec3 p, dvec3 n,
            FoundPhotons& found);

/// A radius that holds about as many photons as wanted where they are as dense as usual
/// (participating-and-global §3.8). `flat`: they lie on surfaces.
[[nodiscard]] double usual_radius(const PhotonMap& map, std::size_t most, bool flat);

}  // namespace durer::tracer
