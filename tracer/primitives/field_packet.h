// Where several lines meet the zeros of a function field. They walk through its cells together, in
// single precision, which the bounds of cells allow for; roots are found in double precision.
#pragma once

#include <array>
#include <cstdint>
#include <glm/geometric.hpp>

#include "scene/function_surface.h"
#include "tracer/primitives/field_walk.h"
#include "tracer/primitives/function_field.h"
#include "tracer/primitives/packet.h"

namespace durer::tracer {

/// One search, for the first visible crossings.
class FieldPacket {
 public:
  static constexpr std::size_t size = most_in_packet;

  /// A field with bounds, in the container of `surface`. `least`: as for FieldSearch. `any`: it is
  /// enough to know that there is a crossing, and about where.
  FieldPacket(const FunctionField& field, const scene::Isosurface& surface, double least, bool any,
              const PacketRays& rays, PacketHits& hits)
      : field_(field),
        surface_(surface),
        least_(least),
        any_(any),
        half_diagonal_(glm::length(field.half())),
        rays_(rays),
        hits_(hits) {}

  /// Answers the rays. Each answer depends on its ray and the field only.
  void run() {
    static const FieldWalkVersion fastest = field_walks().back();
    run(fastest);
  }
  void run(FieldWalkVersion walk) { walk(*this); }

 private:
  template <class Instructions>
  friend class FieldWalk;

  template <class T>
  using PerLane = PerRay<T>;
  using Mask = std::uint32_t;  // a bit for every lane

  void settle(Mask lanes, bool inside, const PerLane<float>& where);
  void hit(std::size_t lane, double t, std::uint32_t part) {
    open_ &= ~(Mask{1} << lane);
    if (t < rays_.t_to[lane]) hits_.set(lane, t, part);
  }
  void enter(std::size_t lane);
  /// Part of a line, the values at its ends, and the slopes between.
  struct Piece {
    double from, to;
    double value_from, value_to;
    Interval slope;
  };
  void alone(std::size_t lane, const Piece& piece);
  void leave(Mask lanes);
  /// Among the faces of a box that look along x, y, z: which one a line meets. One is the last.
  struct FaceOf {
    Mask y = 0, z = 0;
    [[nodiscard]] int axis(std::size_t lane) const {
      return (z >> lane & 1) != 0 ? 2 : static_cast<int>(y >> lane & 1);
    }
  };
  void hit_face(std::size_t lane, const FaceOf& face, double t, bool leaves);

  const FunctionField& field_;
  const scene::Isosurface& surface_;
  double least_;
  bool any_;
  double half_diagonal_;  // of the field
  const PacketRays& rays_;
  PacketHits& hits_;

  // Lines as p + u · d: they begin, at u = 0, where they enter the container or their range.
  alignas(64) std::array<PerLane<double>, 3> p_;
  alignas(64) std::array<PerLane<double>, 3> d_;
  alignas(64) PerLane<double> begin_;  // on the ray
  alignas(64) PerLane<double> enter_;  // likewise, where it goes into the container …
  alignas(64) PerLane<double> leave_;  // … and comes out
  alignas(64) PerLane<double> fine_;   // what counts as nothing, in units of u
  // In single precision, p from the centre of the field.
  alignas(64) std::array<PerLane<float>, 3> short_p_;
  alignas(64) std::array<PerLane<float>, 3> short_d_;
  alignas(64) std::array<PerLane<float>, 3> inverse_;
  alignas(64) PerLane<float> end_;
  alignas(64) PerLane<float> doubt_;  // errors of u in single precision
  FaceOf enter_face_;
  FaceOf leave_face_;
  Mask open_ = 0;      // lanes that are still looking
  Mask known_ = 0;     // those that know on which side they are …
  Mask inside_ = 0;    // … and are inside
  Mask entering_ = 0;  // those that begin at the face of the container
};

}  // namespace durer::tracer
