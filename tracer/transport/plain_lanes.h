// Points that are lit the short way, side by side in vector registers: for plain_together.cpp, and
// for tests.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/vec.h"
#include "tracer/lights/light.h"
#include "tracer/primitives/packet.h"
#include "tracer/shading/finish.h"

namespace durer::tracer {

/// Points of one finish that a lamp may light, number by number. What is not set here stays as it
/// is: there is one of these for every packet.
struct PlainPoints {
  static constexpr std::size_t size = most_in_packet;
  /// Registers are filled with so many points at once.
  static constexpr std::size_t group = 8;
  template <typename T>
  using PerPoint = std::array<T, size>;
  template <typename T>
  using Vectors = std::array<PerPoint<T>, 3>;
  using Mask = std::uint32_t;  // a bit for each point

  // All of these are set: beyond `count`, to those of one point or another.
  PacketRays to_lamp;                // from these places; the rest by PlainLanes::aim
  alignas(64) Vectors<double> d, n;  // direction of the view, normal of the layer
  alignas(64) Vectors<float> pigment, lit;
  PerPoint<std::uint32_t> noise;  // states of their random numbers
  const Finish* finish;
  std::size_t count;

  // One lamp as seen from the points: see Incidence.
  alignas(64) PerPoint<double> distance, cosine;
  Mask facing;  // those that turn towards the lamp …
  Mask apart;   // … those that it is not itself at …
  Mask shaded;  // … and those that are so far away that something can stand in between

  [[nodiscard]] const Vectors<double>& p() const { return to_lamp.o.of; }
  [[nodiscard]] Vectors<double>& p() { return to_lamp.o.of; }
  [[nodiscard]] const Vectors<double>& l() const { return to_lamp.d.of; }
};

/// What a lamp throws on some points.
struct PlainBeam {
  vec3 colour{0.0F};
  const float* shares = nullptr;  // of the colour, for each point; null: all of it
  float diffuse = 0;
  bool highlights = true;
};

/// Written for several instruction sets; all give the same bits.
struct PlainLanes {
  /// Fills in what a lamp looks like, with its whole area at its centre, and the rays to it.
  void (*aim)(PlainPoints& points, const Light& lamp);
  /// Adds what these points send back of the light of the lamp that they were aimed at: as
  /// Tracer::shade_from() has it.
  void (*shade)(PlainPoints& points, const PlainBeam& beam, PlainPoints::Mask lit);
};
/// One for each set of instructions that this processor has, the fastest last.
[[nodiscard]] std::span<const PlainLanes> plain_lanes();

}  // namespace durer::tracer
