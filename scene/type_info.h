// What the language needs to know about a kind of primitive or pattern: its name, its operands and
// their checks. The tracer describes its types with these tables, `cli` hands them to the
// interpreter, and the two never see each other.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/colour.h"

namespace durer::scene {

/// How an operand is written, and how many doubles it takes in `args`.
enum class ArgKind : std::uint8_t {
  number,   // one expression of one component: 1 double
  vector2,  // 2 doubles
  vector,   // 3 doubles; a float is promoted
  pair,     // two expressions of one component: 2 doubles
  flag,     // a word without operand: 1 double, 0 or 1
};

[[nodiscard]] constexpr std::size_t width(ArgKind kind) {
  switch (kind) {
    case ArgKind::vector: return 3;
    case ArgKind::vector2:
    case ArgKind::pair: return 2;
    default: return 1;
  }
}

/// One operand. Positional ones come first, in order, with optional commas between them; the others
/// are named by a word and may come in any order after that.
struct Param {
  std::string_view name;
  ArgKind kind = ArgKind::number;
  std::string_view doc;
  bool positional = true;
  bool optional = false;             // a positional operand that may be missing
  std::array<double, 3> fallback{};  // value when not written
};

struct TypeInfo {
  std::string_view name;
  std::string_view doc;
  std::span<const Param> params;
  /// Says what is wrong with complete operands, or nothing. Null if nothing can be.
  std::optional<std::string> (*validate)(std::span<const double> args) = nullptr;
  /// The same for operands that make sense, but probably not what was meant.
  std::optional<std::string> (*doubt)(std::span<const double> args) = nullptr;
  bool open_ended = false;    // more operands follow those of `params`, as many as these tell
  bool keeps_bounds = false;  // `bounded_by` cuts it; the oracle drops those of other primitives
  bool is_patch = false;      // has no inside (objects §8.3)

  [[nodiscard]] constexpr std::size_t arg_count() const {
    std::size_t n = 0;
    for (const Param& p : params) n += width(p.kind);
    return n;
  }
};

enum class Wave : std::uint8_t { ramp, sine, triangle, scallop, cubic, poly };

struct MapEntry {
  float key;
  Colour colour;
};

/// A pattern: a function from points to values that select in a map or list (textures §3, §5, §6).
struct PatternInfo : TypeInfo {
  Wave wave = Wave::ramp;
  /// Block patterns choose among this many entries (checker 2, hexagon 3 …); 0: takes a map.
  int list_size = 0;
  /// Entries used where none are written: colours of a list at keys 0, 1, 2…, or a default map.
  std::span<const MapEntry> default_map;
  bool unwrapped = false;       // frequency is 0 unless it is set; so it is for block patterns
  bool takes_function = false;  // `{ … }` of x, y, z follows its name
  bool takes_pigment = false;   // `{ … }` as of a pigment follows its name
  bool takes_image = false;     // `{ … }` with a picture follows its name
  bool takes_voxels = false;    // `df3` and the name of a density file follow its name
  bool takes_object = false;    // `{ … }` with an object and a list follows its name
  bool averages = false;        // all entries of its map count, by weight
  bool only_pigment = false;    // has colours of its own instead of a value
  bool only_normal = false;     // cannot colour anything
  bool only_texture = false;    // chooses among textures alone
};

/// Everything the interpreter may bind, in the order of the registration lists; indices into these
/// are stored in the scene.
struct Registry {
  std::span<const TypeInfo* const> primitives;
  std::span<const PatternInfo* const> patterns;
  std::span<const TypeInfo* const> warps = {};
};

}  // namespace durer::scene
