// The looks of most objects: one layer of one colour, without bumps.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "base/colour.h"

namespace durer::interpreter {

/// Two textures with equal looks cannot be told from each other.
struct PlainLook {
  Colour colour;
  const void* finish = nullptr;  // identity of the shared finish

  friend bool operator==(const PlainLook& a, const PlainLook& b) {
    return a.finish == b.finish && a.colour.rgb == b.colour.rgb &&
           a.colour.filter == b.colour.filter && a.colour.transmit == b.colour.transmit;
  }
  struct Hash {
    std::size_t operator()(const PlainLook& look) const {
      const Colour& c = look.colour;
      std::size_t h = reinterpret_cast<std::uintptr_t>(look.finish);
      for (const float x : {c.rgb.x, c.rgb.y, c.rgb.z, c.filter, c.transmit}) {
        h = (h ^ std::bit_cast<std::uint32_t>(x + 0.0F)) * 0x9E3779B97F4A7C15U;  // -0 equals 0
        h ^= h >> 29U;
      }
      return h;
    }
  };
};

}  // namespace durer::interpreter
