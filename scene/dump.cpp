#include "scene/dump.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "scene/arity.h"
#include "scene/dump_writers.h"
#include "scene/fields.h"

namespace durer::scene {
namespace {

// A struct with a new member must get a line in fields.h.
template <typename Struct>
inline constexpr bool complete =
    arity<Struct>() == std::tuple_size_v<decltype(Fields<Struct>::all)>;
static_assert(complete<Object>);
static_assert(complete<ObjectExtras>);
static_assert(complete<HeightField>);
static_assert(complete<Mesh>);
static_assert(complete<Container>);
static_assert(complete<Isosurface>);
static_assert(complete<Parametric>);
static_assert(complete<TextureUse>);
static_assert(complete<Root>);
static_assert(complete<Light>);
static_assert(complete<LightArea>);
static_assert(complete<Camera>);
static_assert(complete<Lens>);
static_assert(complete<MeshCamera>);
static_assert(complete<SkySphere>);
static_assert(complete<Fog>);
static_assert(complete<Rainbow>);
static_assert(complete<Settings>);
static_assert(complete<PigmentEntry>);
static_assert(complete<Warp>);
static_assert(complete<Pattern>);
static_assert(complete<PaletteChange>);
static_assert(complete<Image>);
static_assert(complete<Voxels>);
static_assert(complete<Pigment>);
static_assert(complete<Finish>);
static_assert(complete<NormalEntry>);
static_assert(complete<SlopeEntry>);
static_assert(complete<Normal>);
static_assert(complete<Layer>);
static_assert(complete<TextureEntry>);
static_assert(complete<Texture>);
static_assert(complete<Interior>);
static_assert(complete<Media>);
static_assert(complete<Colour>);
static_assert(complete<GammaCurve>);
static_assert(complete<Affine>);
// Each member of Scene has its own line in Dumper::scene(), origins are written with their users.
static_assert(arity<Scene>() == 13);

template <typename T>
concept HasWords = requires {
  Words<T>::all;
};

/// Equality of everything that can be in a scene; places do not count.
template <typename T>
bool same(const T& a, const T& b);
bool same(const SharedTransform& a, const SharedTransform& b);

template <typename T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::ranges::equal(a, b, [](const T& x, const T& y) { return same(x, y); });
}

template <typename T>
bool same(const SharedList<T>& a, const SharedList<T>& b) {
  return a == b;
}

bool same(const SharedTransform& a, const SharedTransform& b) {
  return a.get().forward == b.get().forward;
}

template <typename T>
bool same(const Boxed<T>& a, const Boxed<T>& b) {
  return a.same(b) || same(*a, *b);
}

template <typename T>
bool same(const T& a, const T& b) {
  if constexpr (HasFields<T>) {
    return std::apply(
        [&](const auto&... f) {
          return ((f.role == Role::place || same(a.*f.member, b.*f.member)) && ...);
        },
        Fields<T>::all);
  } else {
    return a == b;
  }
}

/// Line numbers of many places: SourceMap::place counts from the beginning of the file each time.
class Lines {
 public:
  explicit Lines(const SourceMap& sources) : sources_(sources) {}

  Place place(Loc loc) {
    const FileId file = sources_.file_of(loc);
    std::vector<std::size_t>& starts = starts_[file];
    const std::string_view text = sources_.text(file);
    if (starts.empty()) {
      starts.push_back(0);
      for (std::size_t i = text.find('\n'); i != text.npos; i = text.find('\n', i + 1)) {
        starts.push_back(i + 1);
      }
    }
    const std::size_t offset = std::min<std::size_t>(loc - sources_.base(file), text.size());
    const auto after = std::ranges::upper_bound(starts, offset);
    return {sources_.path(file), static_cast<std::uint32_t>(after - starts.begin()),
            static_cast<std::uint32_t>(offset - *(after - 1) + 1)};
  }

 private:
  const SourceMap& sources_;
  std::map<FileId, std::vector<std::size_t>> starts_;
};

/// Shortest text that reads back as the same number.
template <typename Writer, typename T>
std::string text_of(T x) {
  if constexpr (std::is_floating_point_v<T>) {
    if (!std::isfinite(x)) return Writer::special(fmt::format("{}", x));
  }
  return fmt::format("{}", x);
}

/// Size and kind of a picture, and a hash of its pixels: pictures that differ have other words.
std::string summary(const Picture& p) {
  std::uint64_t hash = 14695981039346656037U;
  const auto add = [&](std::uint64_t x) { hash = (hash ^ x) * 1099511628211U; };
  for (const std::uint16_t code : p.codes) add(code);
  for (const float sample : p.samples) add(std::bit_cast<std::uint32_t>(sample));
  for (const auto& colour : p.palette) {
    for (const std::uint8_t part : colour) add(part);
  }
  return fmt::format("{}x{}, {} x {} bits, {} colours, {:016x}", p.width, p.height, p.channels,
                     p.bits, p.palette.size(), hash);
}

template <typename Writer>
class Dumper {
 public:
  Dumper(Writer& writer, const Scene& scene, const Registry& registry, const SourceMap* sources)
      : out_(writer), scene_(scene), registry_(registry) {
    if (sources) lines_.emplace(*sources);
  }

  void scene() {
    out_.open_struct("");
    value("settings", scene_.settings);
    value("camera", scene_.camera);
    value("background", scene_.background);
    value("sky_sphere", scene_.sky_sphere);
    value("fogs", scene_.fogs);
    value("rainbows", scene_.rainbows);
    value("lights", scene_.lights);
    value("roots", scene_.roots);
    value("objects", scene_.objects);
    value("textures", scene_.textures);
    value("interiors", scene_.interiors);
    value("atmosphere", scene_.atmosphere);
    // Objects share meshes, and there they are numbers.
    out_.open_list("meshes");
    for (const Mesh* mesh : meshes_) structure("", *mesh);
    out_.close_list();
    out_.close_struct();
  }

 private:
  template <typename T>
  void value(std::string_view name, const T& x) {
    if constexpr (HasFields<T>) {
      structure(name, x);
    } else if constexpr (HasWords<T>) {
      out_.word(name, Words<T>::all[static_cast<std::size_t>(x)]);
    } else {
      out_.number(name, number_text(x));
    }
  }
  void value(std::string_view name, const std::string& x) { out_.word(name, x); }
  void value(std::string_view name, const vec3& v) { triple(name, v); }
  void value(std::string_view name, const dvec3& v) { triple(name, v); }
  void value(std::string_view name, const SharedTransform& t) {
    if (t.is_identity()) {
      out_.nothing(name);
    } else {
      structure(name, t.get().forward);
    }
  }
  template <typename T>
  void value(std::string_view name, const Boxed<T>& x) {
    value(name, *x);
  }
  void value(std::string_view name, const std::shared_ptr<const Pigment>& x) {
    x ? structure(name, *x) : out_.nothing(name);
  }
  void value(std::string_view name, const std::shared_ptr<const Image>& x) {
    x ? structure(name, *x) : out_.nothing(name);
  }
  void value(std::string_view name, const std::shared_ptr<const Picture>& x) {
    x ? out_.word(name, summary(*x)) : out_.nothing(name);
  }
  void value(std::string_view name, const std::shared_ptr<const Voxels>& x) {
    x ? structure(name, *x) : out_.nothing(name);
  }
  void value(std::string_view name, const std::shared_ptr<const Isosurface>& x) {
    x ? structure(name, *x) : out_.nothing(name);
  }
  void value(std::string_view name, const std::shared_ptr<const Parametric>& x) {
    x ? structure(name, *x) : out_.nothing(name);
  }
  void value(std::string_view name, const std::array<functions::FunctionRef, 3>& list) {
    out_.open_list(name);
    for (const functions::FunctionRef& x : list) value("", x);
    out_.close_list();
  }
  void value(std::string_view name, const dvec2& v) {
    out_.numbers(name, {number_text(v.x), number_text(v.y)});
  }
  void value(std::string_view name, const std::shared_ptr<const HeightField>& x) {
    x ? structure(name, *x) : out_.nothing(name);
  }
  void value(std::string_view name, const functions::FunctionRef& x) {
    x ? out_.word(name, functions::dump(*x)) : out_.nothing(name);
  }
  void value(std::string_view name, const std::shared_ptr<const Mesh>& mesh) {
    if (!mesh) return out_.nothing(name);
    const auto [known, is_new] = mesh_ids_.emplace(mesh.get(), meshes_.size());
    if (is_new) meshes_.push_back(mesh.get());
    out_.number(name, number_text(known->second));
  }
  template <typename T>
  void value(std::string_view name, const std::optional<T>& x) {
    x ? value(name, *x) : out_.nothing(name);
  }
  template <typename T>
  void value(std::string_view name, const Chunked<T>& list) {
    out_.open_list(name);
    for (const T& x : list) value("", x);
    out_.close_list();
  }
  template <typename T>
  void value(std::string_view name, const SharedList<T>& list) {
    value(name, std::vector<T>(list.begin(), list.end()));
  }
  template <typename T>
  void value(std::string_view name, const std::vector<T>& list) {
    if constexpr (std::is_arithmetic_v<T>) {
      std::vector<std::string> texts;
      for (const T x : list) texts.push_back(number_text(x));
      out_.numbers(name, texts);
    } else {
      out_.open_list(name);
      for (const T& x : list) value("", x);
      out_.close_list();
    }
  }

  void value(std::string_view name, const Triple& t) {
    std::vector<std::string> texts;
    for (const std::uint32_t x : t) texts.push_back(x == none ? "null" : number_text(x));
    out_.numbers(name, texts);
  }
  void value(std::string_view name, const glm::vec2& v) {
    out_.numbers(name, {number_text(v.x), number_text(v.y)});
  }
  template <typename T>
  static std::string number_text(T x) {
    return text_of<Writer>(x);
  }

  template <typename Vector>
  void triple(std::string_view name, const Vector& v) {
    out_.numbers(name, {number_text(v.x), number_text(v.y), number_text(v.z)});
  }

  template <typename T>
  void structure(std::string_view name, const T& x) {
    static const T plain{};
    out_.open_struct(name);
    members(x, plain);
    out_.close_struct();
  }

  template <typename T>
  void members(const T& x, const T& plain) {
    std::apply([&](const auto&... f) { (member(x, plain, f), ...); }, Fields<T>::all);
  }

  template <typename T, typename Member>
  void member(const T& x, const T& plain, const Field<T, Member>& f) {
    if constexpr (std::is_same_v<Member, OriginId>) {
      if (f.role == Role::place) return place(f.name, x.*f.member);
    }
    if constexpr (std::is_same_v<Member, Boxed<ObjectExtras>>) {
      return members(*(x.*f.member), *(plain.*f.member));  // as if they were the object's own
    }
    if (!Writer::writes_defaults && same(x.*f.member, plain.*f.member)) return;
    if constexpr (std::is_same_v<Member, std::uint32_t>) {
      if (x.*f.member == none) return out_.nothing(f.name);
    }
    if constexpr (std::is_same_v<T, Object> || std::is_same_v<T, Pattern> ||
                  std::is_same_v<T, Warp>) {
      if (f.role == Role::operands) return operands(type_of(x), x.args);
      if (f.role == Role::primitive || f.role == Role::pattern || f.role == Role::warp) {
        return out_.word(f.name, type_of(x)->name);
      }
    }
    value(f.name, x.*f.member);
  }

  const TypeInfo* type_of(const Object& o) const {
    return o.type == none ? nullptr : registry_.primitives[o.type];
  }
  const TypeInfo* type_of(const Pattern& p) const {
    return p.type == none ? nullptr : registry_.patterns[p.type];
  }
  const TypeInfo* type_of(const Warp& p) const {
    return p.type == none ? nullptr : registry_.warps[p.type];
  }

  /// By name; what an open-ended type takes beyond its parameters is called `more`.
  void operands(const TypeInfo* type, std::span<const double> args) {
    out_.open_struct("args");
    std::size_t at = 0;
    const auto take = [&](std::string_view name, std::size_t count) {
      const auto first = args.begin() + static_cast<std::ptrdiff_t>(at);
      const std::vector<double> part(first, first + static_cast<std::ptrdiff_t>(count));
      count == 1 ? value(name, part.front()) : value(name, part);
      at += count;
    };
    if (type) {
      for (const Param& p : type->params) {
        if (at + width(p.kind) <= args.size()) take(p.name, width(p.kind));
      }
    }
    if (at < args.size()) take("more", args.size() - at);
    out_.close_struct();
  }

  /// Where it was written: "desk.pov:41:3", then the macro calls and includes that led there.
  void place(std::string_view name, OriginId id) {
    if (!lines_ || id == 0 || id >= scene_.origins.size()) return;
    out_.open_list(name);
    for (int i = 0; id != 0 && i < most_calls; ++i, id = scene_.origins[id].parent) {
      const Place p = lines_->place(scene_.origins[id].span.begin);
      out_.word("", fmt::format("{}:{}:{}", p.path, p.line, p.column));
    }
    out_.close_list();
  }

  static constexpr int most_calls = 8;  // enough to find the way; recursion would fill pages

  Writer& out_;
  const Scene& scene_;
  const Registry& registry_;
  std::optional<Lines> lines_;
  std::vector<const Mesh*> meshes_;  // in the order of their first use
  std::map<const Mesh*, std::size_t> mesh_ids_;
};

}  // namespace

void dump(const Scene& scene, const Registry& registry, const SourceMap* sources, DumpStyle style,
          const std::function<void(std::string_view)>& write) {
  DumpSink sink(write);
  if (style == DumpStyle::json) {
    JsonWriter writer(sink);
    Dumper(writer, scene, registry, sources).scene();
  } else {
    TextWriter writer(sink);
    Dumper(writer, scene, registry, sources).scene();
  }
}

std::string dump_text(const Scene& scene, const Registry& registry, const SourceMap* sources,
                      DumpStyle style) {
  std::string out;
  dump(scene, registry, sources, style, [&](std::string_view text) { out += text; });
  return out;
}

}  // namespace durer::scene
