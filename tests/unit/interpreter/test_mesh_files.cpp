// Meshes from OBJ, PLY and STL files, and `mesh { import … }`.
#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "interpreter/mesh_files/mesh_file.h"
#include "support.h"
#include "tests/support/catch.h"

using namespace durer;
using namespace durer::interpreter;
using namespace durer::interpreter::test;
using scene::Triple;

namespace {

std::string error_in(std::string_view bytes, std::string_view extension) {
  try {
    static_cast<void>(read_mesh_file(bytes, extension));
  } catch (const MeshFileError& error) {
    return error.message;
  }
  return "no error";
}

template <typename T>
void append(std::string& bytes, T value, bool big = false) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  if (big) std::reverse(raw, raw + sizeof value);  // the tests run on little-endian machines
  bytes.append(raw, sizeof value);
}

std::string stl(std::uint32_t announced, std::uint32_t triangles) {
  std::string bytes(80, ' ');
  append(bytes, announced);
  for (std::uint32_t i = 0; i < triangles; ++i) {
    const float x = static_cast<float>(i);
    for (const float v : {0.0F, 0.0F, 1.0F, x, 0.0F, 0.0F, x + 1, 0.0F, 0.0F, x, 1.0F, 0.0F}) {
      append(bytes, v);
    }
    bytes.append(2, '\0');
  }
  return bytes;
}

/// A folder of files for as long as a test runs.
struct Folder {
  std::filesystem::path path;
  explicit Folder(const char* name)
      : path(std::filesystem::temp_directory_path() / (std::string("durer-test-") + name)) {
    std::filesystem::create_directories(path);
  }
  ~Folder() { std::filesystem::remove_all(path); }
  void write(const char* name, std::string_view bytes) const {
    std::ofstream(path / name, std::ios::binary) << bytes;
  }
  [[nodiscard]] std::string name(const char* file) const { return (path / file).string(); }
};

}  // namespace

TEST_CASE("obj: corners name vertices, uvs and normals, from the front or the back",
          "[interpreter][mesh]") {
  const MeshFile f = read_obj(
      "# a square\no thing\nv 0 0 0\nv 1 0 0 1.0\nv 1 +1 0\r\nv 0 1e0 0\n"
      "vt 0 0\nvt 1 0.5\nvt 1\nvn 0 0 2\ng side\ns 1\n"
      "f 1/1/1 2/2/1 \\\n 3/3/1 4/3/-1\nf -4 -3 -2\n");
  CHECK(f.mesh.vertices == std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  CHECK(f.mesh.faces == std::vector<Triple>{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}});
  CHECK(f.mesh.normals == std::vector<vec3>{{0, 0, 1}});
  CHECK(f.mesh.face_normals == std::vector<Triple>{{0, 0, 0}, {0, 0, 0}});
  CHECK(f.mesh.normals_of(2)[0] == scene::none);
  CHECK(f.mesh.face_uvs == std::vector<Triple>{{0, 1, 2}, {0, 2, 2}});
  CHECK(f.mesh.uvs[2] == glm::vec2(1, 0));
}

TEST_CASE("obj: materials go by name", "[interpreter][mesh]") {
  const MeshFile f = read_obj(
      "mtllib some file.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl red\nf 1 2 3\n"
      "usemtl green\nf 3 2 1\nusemtl red\nf 2 3 1\n");
  CHECK(f.libraries == std::vector<std::string>{"some file.mtl"});
  REQUIRE(f.materials.size() == 2);
  CHECK(f.materials[1].name == "green");
  CHECK(f.face_material == std::vector<std::uint32_t>{scene::none, 0, 1, 0});
  const auto known = read_mtl("newmtl red\nKd 1 0.5 0.25\nillum 2\nd 0.5\nnewmtl grey\nKd .3\nTr 1\n");
  REQUIRE(known.size() == 2);
  CHECK(known[0].diffuse == vec3(1, 0.5F, 0.25F));
  CHECK(known[0].opacity == 0.5F);
  CHECK(known[1].diffuse == vec3(0.3F));
  CHECK(known[1].opacity == 0);
}

TEST_CASE("obj: what is wrong is told with its line", "[interpreter][mesh]") {
  CHECK(error_in("v 0 0 0\nv 1 0 zz\n", ".obj") == "line 2: `zz` is no number");
  CHECK(error_in("v 0 0\n", ".obj") == "line 1: a number is missing");
  CHECK(error_in("v 0 0 0\n\nf 1 1 2\n", ".obj") ==
        "line 3: there is no vertex 2 so far, of 1");
  CHECK(error_in("v 0 0 0\nf 1 1 0\n", ".obj") == "line 2: there is no vertex 0 so far, of 1");
  CHECK(error_in("v 0 0 0\nf 1 1\n", ".obj") == "line 2: a face has three corners or more");
  CHECK(error_in("v 0 0 0\nf 1 1 x\n", ".obj") == "line 2: `x` is no index");
  CHECK(error_in("cstype bezier\n", ".obj").find("free-form") != std::string::npos);
  CHECK(error_in("", ".obj") == "it holds no faces");
  CHECK(error_in("", ".3ds").find("`.3ds`") != std::string::npos);
}

TEST_CASE("ply: text, with what else may be in it", "[interpreter][mesh]") {
  const MeshFile f = read_ply(
      "ply\r\nformat ascii 1.0\ncomment hello\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nproperty uchar red\nproperty float s\nproperty float t\n"
      "element face 2\nproperty list uchar int vertex_indices\nproperty list uchar float q\n"
      "element edge 1\nproperty int a\nend_header\n"
      "0 0 0 255 0 0\n1 0 0 255 1 0\n1 1 0 3 1 1\n0 1 0 4 0 1\n4 0 1 2 3 0\n3 0 1\n2 1 7\n0\n");
  CHECK(f.mesh.vertices.size() == 4);
  CHECK(f.mesh.faces == std::vector<Triple>{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}});
  CHECK(f.mesh.uvs_by_vertex);
  CHECK(f.mesh.uvs[2] == glm::vec2(1, 1));
}

TEST_CASE("ply: numbers in either order of bytes", "[interpreter][mesh]") {
  const bool big = GENERATE(false, true);
  std::string bytes = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                      "_endian 1.0\nelement vertex 3\nproperty double x\nproperty float y\n"
                      "property short z\nproperty float nx\nproperty float ny\nproperty float nz\n"
                      "element face 1\nproperty list uchar uint vertex_index\nend_header\n";
  for (int i = 0; i < 3; ++i) {
    append(bytes, i == 1 ? 1.5 : 0.0, big);
    append(bytes, i == 2 ? 2.5F : 0.0F, big);
    append(bytes, static_cast<std::int16_t>(-i), big);
    for (const float n : {0.0F, 0.0F, 2.0F}) append(bytes, n, big);
  }
  bytes += '\3';
  for (std::uint32_t i = 0; i < 3; ++i) append(bytes, i, big);
  const MeshFile f = read_ply(bytes);
  CHECK(f.mesh.vertices == std::vector<vec3>{{0, 0, 0}, {1.5F, 0, -1}, {0, 2.5F, -2}});
  CHECK(f.mesh.normals_by_vertex);
  CHECK(f.mesh.normals[0] == vec3(0, 0, 1));
  CHECK(f.mesh.faces == std::vector<Triple>{{0, 1, 2}});
  bytes.pop_back();
  CHECK(error_in(bytes, ".ply") == "it ends too early");
}

TEST_CASE("ply: broken headers and indices", "[interpreter][mesh]") {
  CHECK(error_in("solid", ".ply") == "it is no PLY file");
  CHECK(error_in("ply\nelement vertex 1\n", ".ply").find("does not end") != std::string::npos);
  CHECK(error_in("ply\nformat ascii 1.0\nelement vertex 1\nproperty float a\nend_header\n0\n", ".ply")
            .find("no `x`") != std::string::npos);
  CHECK(error_in("ply\nformat ascii 1.0\nelement vertex -1\nend_header\n", ".ply") ==
        "line 3: `-1` is no number of elements");
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n";
  CHECK(error_in(head + "3 0 0 1\n", ".ply") == "a face has the vertex 1, there are 1 before it");
  CHECK(error_in(head + "3000000000\n", ".ply").find("a list of") != std::string::npos);
}

TEST_CASE("stl: numbers and text, equal corners are one vertex", "[interpreter][mesh]") {
  const MeshFile numbers = read_stl(stl(3, 3));
  CHECK(numbers.mesh.faces.size() == 3);
  CHECK(numbers.mesh.vertices.size() == 7);
  const MeshFile text = read_stl(
      "solid a\nfacet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n"
      " endloop\nendfacet\nendsolid a\n");
  CHECK(text.mesh.faces == std::vector<Triple>{{0, 1, 2}});
  CHECK(error_in(stl(4, 3), ".stl") == "it announces 4 triangles and holds 150 bytes of them");
  CHECK(error_in("hello", ".stl") == "it is too short for an STL file");
  CHECK(error_in("solid a\nvertex 0 0 0\nendloop\n", ".stl") ==
        "line 3: a facet has less than three corners");
}

TEST_CASE("mesh files: normals are smoothed by area", "[interpreter][mesh]") {
  MeshFile f = read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\n");
  smooth_normals(f.mesh);
  REQUIRE(f.mesh.normals_by_vertex);
  CHECK(f.mesh.normals[1] == vec3(0, 0, 1));
  CHECK(f.mesh.normals[3] == vec3(1, 0, 0));
  CHECK(f.mesh.normals[0].x == Approx(f.mesh.normals[0].z));
}

TEST_CASE("import: a mesh from a file, with its colours", "[interpreter][mesh]") {
  const Folder folder("import");
  folder.write("t.obj",
               "mtllib t.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\nusemtl lost\nf 3 2 1\n");
  folder.write("t.mtl", "newmtl red\nKd 1 0 0\n");
  const Run r = run("mesh { import \"" + folder.name("t.obj") + "\" smooth pigment { rgb 1 } }");
  REQUIRE(r.scene);
  const scene::Mesh& mesh = *r.scene->objects[r.scene->roots[0].object].extras->mesh;
  CHECK(mesh.normals_by_vertex);
  REQUIRE(mesh.textures_of(0)[0] != scene::none);
  const scene::Texture& red = r.scene->textures[mesh.textures[mesh.textures_of(0)[0]]];
  CHECK(red.layers.back().pigment->colour.rgb == vec3(1, 0, 0));
  CHECK(mesh.textures_of(1)[0] == scene::none);
}

TEST_CASE("import: what cannot be read is an error at the name", "[interpreter][mesh]") {
  const Folder folder("import-errors");
  folder.write("nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder.write("mesh.3ds", "");
  CHECK(error_of("mesh { import \"nowhere.ply\" }").find("D0601 at 1:15") == 0);
  CHECK(error_of("mesh { import \"" + folder.name("nan.obj") + "\" }").find("not finite") !=
        std::string::npos);
  CHECK(error_of("mesh { import \"" + folder.name("mesh.3ds") + "\" }").find("`.obj`") !=
        std::string::npos);
}
