// What a name of the language can stand for.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "base/colour.h"
#include "base/transform.h"
#include "base/vec.h"
#include "grammar/ast.h"
#include "interpreter/text.h"
#include "scene/scene.h"

namespace durer::functions {
class Spline;
}

namespace durer::interpreter {

/// `=` of the language: the tolerance is absolute, and NaN equals everything, as in the oracle
/// (language §2.5).
[[nodiscard]] inline bool nearly_equal(double a, double b) { return !(std::abs(a - b) > epsilon); }

/// One to five components: float, uv-vector, vector, four-vector, colour (language §2.1).
///
/// `length` is what the language thinks it is; slots beyond it can still matter: `.y` writes slot 0
/// and sets the length to 1, and a reader of three components then takes the old slots 1 and 2 with
/// it (language §2.4). Slots of vectors beyond their length are 0.
struct Num {
  std::array<double, 5> v{};
  int length = 1;

  Num() = default;
  explicit Num(double x) : v{x} {}
  explicit Num(dvec3 p) : v{p.x, p.y, p.z}, length(3) {}
  explicit Num(const Colour& c) : v{c.rgb.x, c.rgb.y, c.rgb.z, c.filter, c.transmit}, length(5) {}

  /// A float where `n` components are wanted: every slot filled, `n` long.
  [[nodiscard]] static Num filled(double x, int n) {
    Num r;
    for (int i = 0; i < n; ++i) r.v[static_cast<std::size_t>(i)] = x;
    r.length = n;
    return r;
  }
  [[nodiscard]] dvec3 vec() const { return {v[0], v[1], v[2]}; }
  [[nodiscard]] Colour colour() const {
    return {{static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])},
            static_cast<float>(v[3]),
            static_cast<float>(v[4])};
  }
};

struct Value;

/// One to five dimensions, row-major. The first element assigned fixes the kind of all.
struct Array {
  Array() = default;
  Array(const Array&) = default;
  Array& operator=(const Array&) = delete;
  ~Array();
  std::vector<std::size_t> sizes;
  std::vector<Value> elements;
  bool mixed = false;  // elements of any kinds (since 3.8)
  bool grows = false;  // assigning beyond the end makes room (since 3.8; one dimension)
};

/// Values of any kinds by name (since 3.8). Entries without value count as absent.
struct Dictionary;

/// A macro is its syntax; nothing is copied.
struct MacroRef {
  const ast::Tree* tree = nullptr;
  const ast::Macro* macro = nullptr;
};

struct ObjectRef {
  scene::ObjectId id = scene::none;
};
struct TextureRef {
  scene::TextureId id = scene::none;
};
struct InteriorRef {
  scene::InteriorId id = scene::none;
};
struct Material {
  scene::TextureId texture = scene::none;
  scene::TextureId interior_texture = scene::none;
  scene::InteriorId interior = scene::none;
};
struct ColourMap {
  std::vector<scene::PigmentEntry> entries;
  std::vector<scene::Pigment> children;
};
struct Density {
  scene::Pigment pigment;
};
struct DensityMap {
  std::vector<scene::PigmentEntry> entries;
  std::vector<scene::Pigment> children;
};
struct NormalMap {
  std::vector<scene::NormalEntry> entries;
  std::vector<scene::Normal> children;
};
struct SlopeMap {
  std::vector<scene::SlopeEntry> entries;
};
struct TextureMap {
  std::vector<scene::TextureEntry> entries;
};
/// The written state of a camera, before angle and look_at are worked out (shading §2.2).
struct CameraSpec;
class DataFile;
struct UserFunction;

/// A value of a kind that this version knows but cannot use yet. It may be declared and passed
/// around; whoever uses it gets an error that names `feature`.
struct Unsupported {
  std::string feature;
  Span span;
};

/// What a name stands for whose declaration failed: errors about it are consequences of that one.
struct Poison {};

template <typename T>
using Shared = std::shared_ptr<const T>;

/// What only blocks make and use; one allocation each.
using Thing =
    std::variant<ObjectRef, TextureRef, Boxed<scene::Pigment>, Boxed<scene::Finish>,
                 Boxed<scene::Normal>, Shared<ColourMap>, Shared<NormalMap>, Shared<SlopeMap>,
                 Shared<TextureMap>, Shared<Density>, Shared<DensityMap>, Shared<scene::Media>,
                 InteriorRef, Shared<Material>, Shared<Transform>,
                 Shared<CameraSpec>, Shared<scene::SkySphere>, Shared<scene::Fog>, Shared<scene::Rainbow>,
                 std::shared_ptr<DataFile>,
                 Shared<UserFunction>, Shared<functions::Spline>, Shared<Unsupported>, std::shared_ptr<Dictionary>, Poison>;

/// The few kinds that loops copy and overwrite all the time are alternatives of their own; the
/// others share one, so that copying a value is a short switch.
struct Value {
  using Node = std::variant<std::monostate, Num, Shared<Text>, std::shared_ptr<Array>, MacroRef,
                            Shared<Thing>>;
  Node node;

  Value() = default;
  template <typename T>
  Value(T x) {  // NOLINT: values convert freely, as in the language
    if constexpr (is_direct<T>) {
      node = std::move(x);
    } else {
      node = std::make_shared<const Thing>(std::move(x));
    }
  }

  template <typename T>
  [[nodiscard]] const T* get() const {
    if constexpr (is_direct<T>) {
      return std::get_if<T>(&node);
    } else {
      const auto* thing = std::get_if<Shared<Thing>>(&node);
      return thing == nullptr ? nullptr : std::get_if<T>(thing->get());
    }
  }
  /// To change it in place; things are shared and never change.
  template <typename T>
  [[nodiscard]] auto* get() {
    if constexpr (is_direct<T>) {
      return std::get_if<T>(&node);
    } else {
      return std::as_const(*this).template get<T>();
    }
  }
  [[nodiscard]] bool defined() const { return node.index() != 0; }
  [[nodiscard]] bool is_num() const { return node.index() == 1; }
  void clear() {
    if (defined()) node.emplace<std::monostate>();
  }
  /// Overwrites a number with a number without going through the other kinds.
  void set(const Num& n) {
    if (Num* old = std::get_if<Num>(&node)) {
      *old = n;
    } else {
      node = n;
    }
  }

 private:
  template <typename T>
  static constexpr bool is_direct =
      std::is_same_v<T, std::monostate> || std::is_same_v<T, Num> ||
      std::is_same_v<T, Shared<Text>> || std::is_same_v<T, std::shared_ptr<Array>> ||
      std::is_same_v<T, MacroRef>;
};

/// A string as a value. Its text is nobody else's, so that who alone holds it may change it.
[[nodiscard]] inline Value text_value(Text text) {
  return Value(Shared<Text>(std::make_shared<Text>(std::move(text))));
}

struct Dictionary {
  Dictionary() = default;
  Dictionary(const Dictionary&) = default;
  Dictionary& operator=(const Dictionary&) = delete;
  ~Dictionary();
  std::map<Text, Value> entries;
};

/// What the array or dictionary in `v` holds, for writing: copies share it until one is written. Null
/// if `v` is none.
Array* own_array(Value& v);
Dictionary* own_dictionary(Value& v);

/// The slot of a component that a member names (language §2.4): x u red 0, y v green 1, z blue 2,
/// t filter 3, transmit 4; -1 for every other word.
[[nodiscard]] int component_slot(grammar::SymbolId member);

/// True if both are of one kind, whatever their values; numbers of any length are of one kind.
[[nodiscard]] bool same_alternative(const Value& a, const Value& b);

/// "a float", "a vector", "a string", … for messages.
[[nodiscard]] std::string_view kind_name(const Value& v);

}  // namespace durer::interpreter
