// Wavefront OBJ: vertices, normals, uv vectors, polygons and the names of their materials. Polygons
// become fans of triangles. Free-form surfaces are refused; points, lines, groups and smoothing groups
// have nothing that could be seen.
#include <array>
#include <unordered_map>

#include "interpreter/mesh_files/words.h"

namespace durer::interpreter {
namespace {

class ObjReader {
 public:
  explicit ObjReader(std::string_view text) : in_(text) {}

  MeshFile run() {
    while (in_.next_line()) line(in_.word());
    finish();
    return std::move(file_);
  }

 private:
  /// Indices of a corner; none: not given.
  struct Corner {
    std::uint32_t vertex = 0;
    std::uint32_t uv = scene::none;
    std::uint32_t normal = scene::none;
  };

  void line(std::string_view word) {
    scene::Mesh& mesh = file_.mesh;
    if (word == "v") {
      mesh.vertices.push_back(in_.vector());
    } else if (word == "vn") {
      const vec3 n = in_.vector();
      const float length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
      mesh.normals.push_back(length > 0 ? n / length : vec3(1, 0, 0));
    } else if (word == "vt") {
      const float u = in_.number();
      mesh.uvs.emplace_back(u, in_.at_line_end() ? 0.0F : in_.number());
    } else if (word == "f" || word == "fo") {
      face();
    } else if (word == "usemtl") {
      material_ = material(in_.rest());
    } else if (word == "mtllib") {
      file_.libraries.emplace_back(in_.rest());
    } else if (word == "cstype" || word == "curv" || word == "curv2" || word == "surf") {
      in_.fail("free-form curves and surfaces cannot be read; export the mesh as polygons");
    }
  }

  void face() {
    corners_.clear();
    while (!in_.at_line_end()) corners_.push_back(corner(in_.word()));
    if (corners_.size() < 3) in_.fail("a face has three corners or more");
    for (std::size_t i = 2; i < corners_.size(); ++i) {
      add({corners_[0], corners_[i - 1], corners_[i]});
    }
  }

  void add(const std::array<Corner, 3>& c) {
    scene::Mesh& mesh = file_.mesh;
    const std::size_t face = mesh.faces.size();
    mesh.faces.push_back({c[0].vertex, c[1].vertex, c[2].vertex});
    if (c[0].normal != scene::none && c[1].normal != scene::none && c[2].normal != scene::none) {
      put(mesh.face_normals, face, {c[0].normal, c[1].normal, c[2].normal});
    }
    if (c[0].uv != scene::none && c[1].uv != scene::none && c[2].uv != scene::none) {
      put(mesh.face_uvs, face, {c[0].uv, c[1].uv, c[2].uv});
    }
    if (material_ != scene::none) {
      file_.face_material.resize(face, scene::none);
      file_.face_material.push_back(material_);
    }
  }

  static void put(std::vector<scene::Triple>& list, std::size_t face, const scene::Triple& row) {
    list.resize(face, {scene::none, scene::none, scene::none});
    list.push_back(row);
  }

  /// `v`, `v/vt`, `v//vn` or `v/vt/vn`.
  Corner corner(std::string_view word) {
    Corner c;
    const auto part = [&word] {
      const std::size_t end = std::min(word.find('/'), word.size());
      const std::string_view first = word.substr(0, end);
      word.remove_prefix(std::min(end + 1, word.size()));
      return first;
    };
    c.vertex = index(part(), file_.mesh.vertices.size(), "vertex");
    if (const auto uv = part(); !uv.empty()) c.uv = index(uv, file_.mesh.uvs.size(), "uv vector");
    if (!word.empty()) c.normal = index(part(), file_.mesh.normals.size(), "normal");
    return c;
  }

  /// From 1; negative ones count back from the last.
  std::uint32_t index(std::string_view word, std::size_t count, std::string_view what) {
    std::int64_t i = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), i);
    if (error != std::errc{} || end != word.data() + word.size()) {
      in_.fail(fmt::format("`{}` is no index", WordReader::shown(word)));
    }
    const auto n = static_cast<std::int64_t>(count);
    const std::int64_t at = i < 0 ? n + i : i - 1;
    if (at < 0 || at >= n) in_.fail(fmt::format("there is no {} {} so far, of {}", what, i, n));
    return static_cast<std::uint32_t>(at);
  }

  std::uint32_t material(std::string_view name) {
    const auto [at, is_new] =
        known_.try_emplace(std::string(name), static_cast<std::uint32_t>(file_.materials.size()));
    if (is_new) file_.materials.push_back({std::string(name), vec3(0.8F), 1});
    return at->second;
  }

  void finish() {
    if (file_.mesh.face_normals.empty()) file_.mesh.normals.clear();
    // Where there are uvs, every face has some (scene::Mesh).
    if (file_.mesh.face_uvs.empty()) file_.mesh.uvs.clear();
  }

  WordReader in_;
  MeshFile file_;
  std::vector<Corner> corners_;
  std::uint32_t material_ = scene::none;
  std::unordered_map<std::string, std::uint32_t> known_;
};

}  // namespace

MeshFile read_obj(std::string_view text) { return ObjReader(text).run(); }

std::vector<MeshMaterial> read_mtl(std::string_view text) {
  WordReader in(text);
  std::vector<MeshMaterial> all;
  while (in.next_line()) {
    const std::string_view word = in.word();
    if (word == "newmtl") {
      all.push_back({std::string(in.rest()), vec3(0.8F), 1});
    } else if (all.empty()) {
      continue;
    } else if (word == "Kd") {
      const float red = in.number();
      const bool grey = in.at_line_end();
      const float green = grey ? red : in.number();
      all.back().diffuse = {red, green, grey ? red : in.number()};
    } else if (word == "d") {
      all.back().opacity = in.number();
    } else if (word == "Tr") {
      all.back().opacity = 1 - in.number();
    }
  }
  return all;
}

}  // namespace durer::interpreter
