// `mesh { import "file" … }`, an addition of ours: triangles from files of other programs. `import`
// is no reserved word: nothing else can stand before a string in a mesh.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "base/read_file.h"
#include "interpreter/mesh_builder.h"
#include "interpreter/mesh_files/mesh_file.h"
#include "interpreter/object_reader.h"

namespace durer::interpreter {

namespace w = grammar::words;

namespace {

std::string lower_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return extension;
}

}  // namespace

/// The name of the file, then `smooth` if normals are to be made.
bool ObjectReader::imported(MeshBuilder& builder) {
  const Token word = in_.peek();
  const auto* import = word.node<ast::Name>();
  if (import == nullptr || in_.name_of(import->name) != "import") return false;
  in_.next();
  const Span span = in_.peek().span;
  const std::string name = in_.read_text(true).bytes();
  const auto path = in_.find_file(name, span, {});
  if (!path) in_.missing_file(name, span, {});
  MeshFile file = file_of_mesh(*path, span);
  builder.mesh = std::move(file.mesh);
  std::vector<std::uint32_t> textures;
  for (const MeshMaterial& material : file.materials) {
    textures.push_back(builder.texture(material_texture(material)));
  }
  for (std::size_t face = 0; face < file.face_material.size(); ++face) {
    const std::uint32_t material = file.face_material[face];
    if (material == scene::none) continue;
    builder.set_textures(face, {textures[material], scene::none, scene::none});
  }
  for (;;) {
    if (accept(w::smooth)) {
      if (in_.read_switch(true)) smooth_normals(builder.mesh);
    } else if (accept(w::inside_vector)) {
      builder.set_inside(in_.read_vector());
    } else {
      return true;
    }
  }
}

/// The triangles in a file, and the colours of their materials.
MeshFile ObjectReader::file_of_mesh(const std::string& path, Span span) {
  const auto unreadable = [&](std::string_view why) {
    in_.fail(Code::file_not_found, span, fmt::format("`{}` cannot be read{}", path, why));
  };
  MeshFile file;
  try {
    const auto bytes = read_file(path);
    if (!bytes) unreadable("");
    file = read_mesh_file(*bytes, lower_extension(path));
  } catch (const MeshFileError& error) {
    unreadable(": " + error.message);
  }
  const auto is_broken = [](const vec3& v) {
    return !std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z);
  };
  const std::vector<vec3>& vertices = file.mesh.vertices;
  const auto broken = std::find_if(vertices.begin(), vertices.end(), is_broken);
  if (broken != vertices.end()) {
    unreadable(fmt::format(": vertex {} is not finite", broken - vertices.begin()));
  }
  add_material_files(file, path, span);
  return file;
}

/// Looks the materials of an OBJ file up in the files that it names; a missing one is worth a
/// warning, because shapes can be seen without it.
void ObjectReader::add_material_files(MeshFile& file, const std::string& path, Span span) {
  std::vector<MeshMaterial> known;
  for (const std::string& name : file.libraries) {
    const auto beside = (std::filesystem::path(path).parent_path() / name).string();
    auto found = in_.find_file(beside, span, {});
    if (!found) found = in_.find_file(name, span, {});
    const auto text = found ? read_file(*found) : std::nullopt;
    if (!text) {
      in_.warn(Code::file_not_found, span, fmt::format("the materials in `{}` were not found", name));
      continue;
    }
    try {
      const std::vector<MeshMaterial> more = read_mtl(*text);
      known.insert(known.end(), more.begin(), more.end());
    } catch (const MeshFileError& error) {
      in_.fail(Code::file_not_found, span,
               fmt::format("`{}` cannot be read: {}", *found, error.message));
    }
  }
  std::vector<std::uint32_t> without(file.materials.size(), 0);
  for (std::size_t i = 0; i < file.materials.size(); ++i) {
    MeshMaterial& material = file.materials[i];
    const auto found = std::find_if(known.begin(), known.end(), [&](const MeshMaterial& k) {
      return k.name == material.name;
    });
    if (found == known.end()) {
      without[i] = 1;
    } else {
      material = *found;
    }
  }
  // What has no colour of its own looks like the mesh.
  for (std::uint32_t& m : file.face_material) {
    if (m != scene::none && without[m] != 0) m = scene::none;
  }
}

/// The default texture in the colour of the material.
scene::TextureId ObjectReader::material_texture(const MeshMaterial& material) {
  scene::Texture t = in_.scene_.textures[in_.default_texture_];
  if (t.patterned()) t = {};
  if (t.layers.empty()) t.layers.emplace_back();
  t.layers.erase(t.layers.begin(), t.layers.end() - 1);
  scene::Pigment pigment;
  pigment.colour = {material.diffuse, 0, 1 - material.opacity};
  t.layers[0].pigment = pigment;
  return in_.add_texture(std::move(t));
}

}  // namespace durer::interpreter
