// PLY: a header that describes the elements, then their properties as text or as numbers in either
// byte order. Vertices and faces are taken, other elements passed over. Polygons become fans.
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "interpreter/mesh_files/words.h"

namespace durer::interpreter {
namespace {

enum class Form : std::uint8_t { text, little, big };

/// Number types by their size and sort.
struct Type {
  std::uint8_t size = 0;
  char sort = 'u';  // unsigned, i: signed, f: real
};

struct Property {
  std::string name;
  Type type;
  std::optional<Type> count;  // of a list
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;

  [[nodiscard]] std::size_t find(std::initializer_list<std::string_view> names) const {
    for (std::size_t i = 0; i < properties.size(); ++i) {
      for (const std::string_view n : names) {
        if (properties[i].name == n) return i;
      }
    }
    return properties.size();
  }
};

class PlyReader {
 public:
  explicit PlyReader(std::string_view bytes) : bytes_(bytes), in_(bytes) {}

  MeshFile run() {
    header();
    for (const Element& e : elements_) {
      if (e.name == "vertex") {
        vertices(e);
      } else if (e.name == "face") {
        faces(e);
      } else {
        pass_over(e);
      }
    }
    return std::move(file_);
  }

 private:
  void header() {
    if (!in_.next_line() || in_.word() != "ply") throw MeshFileError{"it is no PLY file"};
    bool has_form = false;
    while (in_.next_line()) {
      const std::string_view word = in_.word();
      if (word == "format") {
        form_ = form_of(in_.word());
        has_form = true;
      } else if (word == "element") {
        Element& e = elements_.emplace_back();
        e.name = in_.word();
        e.count = count_of(in_.word());
      } else if (word == "property") {
        if (elements_.empty()) in_.fail("a property before any element");
        elements_.back().properties.push_back(property());
      } else if (word == "end_header") {
        if (!has_form) in_.fail("the header does not tell the format");
        at_ = bytes_.find('\n', in_.offset());
        at_ = at_ == std::string_view::npos ? bytes_.size() : at_ + 1;
        return;
      } else if (word != "comment" && word != "obj_info") {
        in_.fail(fmt::format("`{}` does not belong into a header", WordReader::shown(word)));
      }
    }
    in_.fail("the header does not end");
  }

  Form form_of(std::string_view word) {
    if (word == "ascii") return Form::text;
    if (word == "binary_little_endian") return Form::little;
    if (word == "binary_big_endian") return Form::big;
    in_.fail(fmt::format("`{}` is no format of PLY files", WordReader::shown(word)));
  }

  std::size_t count_of(std::string_view word) {
    std::uint64_t n = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), n);
    if (error != std::errc{} || end != word.data() + word.size() || n >= scene::none) {
      in_.fail(fmt::format("`{}` is no number of elements", WordReader::shown(word)));
    }
    return n;
  }

  Property property() {
    Property p;
    std::string_view word = in_.word();
    if (word == "list") {
      p.count = type_of(in_.word());
      word = in_.word();
    }
    p.type = type_of(word);
    p.name = in_.word();
    return p;
  }

  Type type_of(std::string_view word) {
    if (word == "char" || word == "int8") return {1, 'i'};
    if (word == "uchar" || word == "uint8") return {1, 'u'};
    if (word == "short" || word == "int16") return {2, 'i'};
    if (word == "ushort" || word == "uint16") return {2, 'u'};
    if (word == "int" || word == "int32") return {4, 'i'};
    if (word == "uint" || word == "uint32") return {4, 'u'};
    if (word == "float" || word == "float32") return {4, 'f'};
    if (word == "double" || word == "float64") return {8, 'f'};
    in_.fail(fmt::format("`{}` is no type of a property", WordReader::shown(word)));
  }

  // ---- values ----

  double value(Type type) {
    if (form_ == Form::text) {
      if (in_.at_line_end() && !in_.next_line()) throw MeshFileError{"it ends too early"};
      return in_.number();
    }
    if (bytes_.size() - at_ < type.size) throw MeshFileError{"it ends too early"};
    std::uint64_t n = 0;
    for (unsigned i = 0; i < type.size; ++i) {
      const unsigned shift = form_ == Form::little ? i : type.size - 1U - i;
      n |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes_[at_ + i])) << (8 * shift);
    }
    at_ += type.size;
    if (type.sort == 'f') {
      return type.size == 8 ? std::bit_cast<double>(n)
                            : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(n)));
    }
    const bool negative = type.sort == 'i' && ((n >> (8U * type.size - 1U)) & 1U) != 0;
    return static_cast<double>(n) - (negative ? std::ldexp(1.0, 8 * type.size) : 0);
  }

  /// The length of a list.
  std::size_t length(Type type) {
    const double n = value(type);
    if (!(n >= 0 && n <= 1e6)) throw MeshFileError{fmt::format("a list of {} items", n)};
    return static_cast<std::size_t>(n);
  }

  void skip(const Property& p) {
    const std::size_t n = p.count ? length(*p.count) : 1;
    for (std::size_t i = 0; i < n; ++i) value(p.type);
  }

  void pass_over(const Element& e) {
    for (std::size_t i = 0; i < e.count; ++i) {
      for (const Property& p : e.properties) skip(p);
    }
  }

  // ---- elements ----

  void vertices(const Element& e) {
    enum { x, y, z, nx, ny, nz, u, v, wanted };
    const std::array<std::size_t, wanted> at = {
        e.find({"x"}),  e.find({"y"}),  e.find({"z"}),
        e.find({"nx"}), e.find({"ny"}), e.find({"nz"}),
        e.find({"u", "s", "texture_u"}), e.find({"v", "t", "texture_v"})};
    const std::size_t absent = e.properties.size();
    if (at[x] == absent || at[y] == absent || at[z] == absent) {
      throw MeshFileError{"its vertices have no `x`, `y` and `z`"};
    }
    const bool normals = at[nx] != absent && at[ny] != absent && at[nz] != absent;
    const bool uvs = at[u] != absent && at[v] != absent;
    std::vector<double> row(e.properties.size() + 1, 0.0);
    scene::Mesh& mesh = file_.mesh;
    for (std::size_t i = 0; i < e.count; ++i) {
      for (std::size_t k = 0; k < e.properties.size(); ++k) {
        const Property& p = e.properties[k];
        if (p.count) {
          skip(p);
        } else {
          row[k] = value(p.type);
        }
      }
      mesh.vertices.emplace_back(row[at[x]], row[at[y]], row[at[z]]);
      if (normals) mesh.normals.push_back(unit({row[at[nx]], row[at[ny]], row[at[nz]]}));
      if (uvs) mesh.uvs.emplace_back(row[at[u]], row[at[v]]);
    }
    mesh.normals_by_vertex = normals;
    mesh.uvs_by_vertex = uvs;
  }

  static vec3 unit(dvec3 n) {
    const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    return length > 0 ? vec3(n / length) : vec3(1, 0, 0);
  }

  void faces(const Element& e) {
    const std::size_t corners = e.find({"vertex_indices", "vertex_index"});
    if (corners == e.properties.size() || !e.properties[corners].count) {
      throw MeshFileError{fmt::format("its element `{}` has no list `vertex_indices`", e.name)};
    }
    std::vector<std::uint32_t> polygon;
    for (std::size_t i = 0; i < e.count; ++i) {
      for (std::size_t k = 0; k < e.properties.size(); ++k) {
        const Property& p = e.properties[k];
        if (k != corners) {
          skip(p);
          continue;
        }
        polygon.clear();
        const std::size_t n = length(*p.count);
        for (std::size_t c = 0; c < n; ++c) polygon.push_back(index(value(p.type)));
      }
      for (std::size_t c = 2; c < polygon.size(); ++c) {
        file_.mesh.faces.push_back({polygon[0], polygon[c - 1], polygon[c]});
      }
    }
  }

  std::uint32_t index(double i) {
    if (!(i >= 0 && i < static_cast<double>(file_.mesh.vertices.size()))) {
      throw MeshFileError{fmt::format("a face has the vertex {}, there are {} before it", i,
                                      file_.mesh.vertices.size())};
    }
    return static_cast<std::uint32_t>(i);
  }

  std::string_view bytes_;
  WordReader in_;
  Form form_ = Form::text;
  std::size_t at_ = 0;  // of numbers
  std::vector<Element> elements_;
  MeshFile file_;
};

}  // namespace

MeshFile read_ply(std::string_view bytes) { return PlyReader(bytes).run(); }

}  // namespace durer::interpreter
