// Indirect light that was gathered at some points, for use at the points around them
// (participating-and-global §2.7; Ward, Rubinstein, Clear: "A Ray Tracing Solution for Diffuse
// Interreflection", 1988).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace durer::tracer {

/// Light gathered at a point. World space.
struct IrradianceSample {
  dvec3 p{0.0};
  dvec3 n{0.0};           // unit; the side that the light came from
  dvec3 to_nearest{0.0};  // unit, towards the nearest surface around
  double nearest = 0;     // its distance
  double radius = 0;      // harmonic mean of all distances, within the limits of reuse
  vec3 light{0.0F};       // cosine-weighted mean of what arrives
  float quality = 0;      // 0…1
  std::uint32_t depth = 0;  // bounces between the camera and this point
};

/// A question: which samples speak for a point?
struct IrradianceQuery {
  dvec3 p{0.0};
  dvec3 n{0.0};
  double error = 0;  // greatest error of a sample that may be used
  std::uint32_t depth = 0;
  bool smooth = false;  // weights without a kink: where the result is seen directly
  double plenty = 0;    // weight that makes it superfluous to look for more samples
};

/// What samples together have to say.
struct IrradianceSum {
  dvec3 light{0.0};  // weighted
  double weight = 0;
};

/// Samples in a hash grid of many levels: each lies in all cells, at most eight, of the level whose
/// cells are as large as its reach. Cells hold what a first look needs, roughly, eight samples side by
/// side; only those that may count are asked. Answers do not depend on anything but the order of `add`.
class IrradianceCache {
 public:
  static constexpr std::uint32_t max_depth = 20;

  /// `reach`: distance up to which the sample will be found.
  void add(const IrradianceSample& sample, double reach);
  /// Adds the usable samples around to `sum`, those of small reach first, until there are plenty.
  void look_up(const IrradianceQuery& query, IrradianceSum& sum) const;
  void clear();

  [[nodiscard]] const std::vector<IrradianceSample>& samples() const { return samples_; }
  [[nodiscard]] bool empty() const { return samples_.empty(); }

 private:
  static constexpr std::uint32_t nothing = ~0U;
  static constexpr int levels = 64;
  static constexpr int level_of_one = 32;  // whose cells have side 1

  static constexpr std::size_t lanes = 8;
  using Eight = std::array<float, lanes>;

  struct Slot {
    std::uint64_t cell = 0;
    std::uint32_t first = nothing;  // index into blocks_
  };
  // Some of the samples of a cell, the latest first. Lanes are taken from the last to the first; those
  // that are not yet are infinitely far away.
  struct alignas(64) Block {
    std::array<Eight, 3> p;  // from the origin
    Eight radius;
    dvec3 origin;
    std::uint32_t next;  // of earlier ones
    std::uint32_t open;  // lanes
    std::array<std::uint32_t, lanes> sample;
    std::array<Eight, 3> n, to_nearest;
    Eight nearest;
  };
  // A question as blocks of a level see it.
  struct Look;

  [[nodiscard]] static std::uint64_t cell(std::uint32_t depth, int level, dvec3 scaled);
  [[nodiscard]] static unsigned near_lanes(const Block& block, const Look& look);
  void put(std::uint32_t id, std::uint32_t& first, dvec3 origin);
  void look_into_all(const IrradianceQuery& query, IrradianceSum& sum) const;
  void look_wide(const IrradianceQuery& query, IrradianceSum& sum) const;
  [[nodiscard]] std::uint32_t& first_in(std::uint64_t cell);
  [[nodiscard]] std::uint32_t first_in(std::uint64_t cell) const;
  void mark(std::uint64_t cell);
  [[nodiscard]] bool is_marked(std::uint64_t cell) const;
  void grow();

  std::vector<IrradianceSample> samples_;
  std::vector<Block> blocks_;
  std::vector<Slot> slots_;  // open addressing; a power of two
  std::vector<std::uint64_t> marks_;  // a bit for every cell: most questions need to see no more
  std::size_t used_ = 0;
  std::array<std::uint64_t, max_depth + 1> levels_used_{};  // bits
};

/// How much a sample counts in an answer; 0: not at all.
[[nodiscard]] double weight_of(const IrradianceSample& sample, const IrradianceQuery& query);

}  // namespace durer::tracer
