// The looks of most objects: one layer of one colour, without bumps.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

#include "base/colour.h"
#include "scene/texture.h"

namespace durer::interpreter {

/// Two textures with equal looks cannot be told from each other.
struct PlainLook {
  Colour colour;
  const void* finish = nullptr;  // identity of the shared finish

  friend bool operator==(const PlainLook& a, const PlainLook& b) {
    return a.finish == b.finish && a.colour.rgb == b.colour.rgb &&
           a.colour.filter == b.colour.filter && a.colour.transmit == b.colour.transmit;
  }
  [[nodiscard]] std::size_t hash() const {
    // Not of the finish, whose address differs from run to run: what is shared must not.
    std::size_t h = 0;
    for (const float x : {colour.rgb.x, colour.rgb.y, colour.rgb.z, colour.filter,
                          colour.transmit}) {
      h = (h ^ std::bit_cast<std::uint32_t>(x + 0.0F)) * 0x9E3779B97F4A7C15U;  // -0 equals 0
      h ^= h >> 29U;
    }
    return h;
  }
};

/// The textures that have been made for plain looks. Scenes may give every object a colour of its
/// own, so it remembers only so many: then new ones replace old ones, and less is shared.
class KnownLooks {
 public:
  /// The texture that looks so; `none` if none is known.
  [[nodiscard]] scene::TextureId find(const PlainLook& look) const {
    if (entries_.empty()) return scene::none;
    const std::size_t home = look.hash();
    for (std::size_t i = 0; i < probes; ++i) {
      const Entry& e = entries_[place(home + i)];
      if (e.texture != scene::none && e.look == look) return e.texture;
    }
    return scene::none;
  }
  void add(const PlainLook& look, scene::TextureId texture) {
    if (2 * used_ >= entries_.size() && entries_.size() < most) grow();
    ++used_;
    insert({look, texture});
  }

 private:
  struct Entry {
    PlainLook look;
    scene::TextureId texture = scene::none;
  };
  static constexpr std::size_t least = 64;
  static constexpr std::size_t most = std::size_t{1} << 12U;  // what fits into a fast cache
  static constexpr std::size_t probes = 4;

  [[nodiscard]] std::size_t place(std::size_t hash) const { return hash & (entries_.size() - 1); }
  void insert(const Entry& entry) {
    const std::size_t home = entry.look.hash();
    std::size_t at = place(home);
    for (std::size_t i = 0; i < probes && entries_[at].texture != scene::none; ++i) {
      at = place(home + (i + 1) % probes);
    }
    entries_[at] = entry;
  }
  void grow() {
    const std::vector<Entry> old = std::exchange(entries_, {});
    entries_.resize(old.empty() ? least : 2 * old.size());
    for (const Entry& e : old) {
      if (e.texture != scene::none) insert(e);
    }
  }

  std::vector<Entry> entries_;
  std::size_t used_ = 0;
};

}  // namespace durer::interpreter
