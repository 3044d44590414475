// Rays of the most common camera, sixteen at a time.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "scene/camera.h"
#include "tracer/primitives/packet.h"

namespace durer::tracer {

/// Places in a picture, and the rays that look there. All places have to be set.
struct alignas(64) PinholeRays {
  template <typename T>
  using PerLane = std::array<T, most_in_packet>;

  PerLane<double> x, y;  // in pixels: whole numbers are their centres
  PerLane<std::uint32_t>
      key;          // tells samples of a pixel apart; afterwards: start of random numbers
  PacketRays rays;  // their directions; origins and ranges are whoever's who looks
};

/// A pinhole without bumps, and the size of its picture in pixels.
struct Pinhole {
  const scene::Camera* camera = nullptr;
  int width = 1;
  int height = 1;
};

/// Fills in the rays: what Camera::ray has, normalised, and sample_seed(), to the last bit.
using PinholeVersion = void (*)(const Pinhole& pinhole, PinholeRays& rays);
/// One for each set of instructions that this processor has, the fastest last. All give the same
/// bits.
[[nodiscard]] std::span<const PinholeVersion> pinhole_versions();

}  // namespace durer::tracer
