// `mesh` and `mesh2` → scene::Mesh.
#include "support.h"
#include "tests/support/catch.h"

using namespace durer;
using namespace durer::interpreter::test;
using scene::Triple;

namespace {

const scene::Object& object(const Run& r, std::size_t i = 0) {
  return r.scene->objects[r.scene->roots[i].object];
}
const scene::Mesh& mesh_of(const Run& r, std::size_t i = 0) {
  REQUIRE(r.scene);
  REQUIRE(object(r, i).extras->mesh != nullptr);
  return *object(r, i).extras->mesh;
}

const std::string corners = "vertex_vectors { 4, <0,0,0>, <1,0,0>, <1,1,0>, <0,1,0> } ";
const std::string faces = "face_indices { 2, <0,1,2>, <0,2,3> } ";
std::string mesh2(const std::string& inside) { return "mesh2 { " + inside + "}"; }

}  // namespace

TEST_CASE("mesh2: lists with and without commas, and with a number for a vector",
          "[interpreter][mesh]") {
  const Run r = run("mesh2 { vertex_vectors { 3 0 x y } face_indices { 1 <0 1 2> } }");
  const scene::Mesh& m = mesh_of(r);
  CHECK(m.vertices == std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(m.faces == std::vector<Triple>{{0, 1, 2}});
  CHECK_FALSE(m.has_inside());
}

TEST_CASE("mesh2: lists may come out of loops and macros", "[interpreter][mesh]") {
  const Run r = run(
      "#macro V(I) <I, I*I, 0> #end\n"
      "mesh2 { vertex_vectors { 4, #local I = 0; #while (I < 4) V(I), #local I = I + 1; #end }\n"
      "face_indices { 2, #for (I, 0, 1) <I, I + 1, I + 2.9> #end } inside_vector 2*y }");
  const scene::Mesh& m = mesh_of(r);
  CHECK(m.vertices[3] == vec3(3, 9, 0));
  CHECK(m.faces == std::vector<Triple>{{0, 1, 2}, {1, 2, 3}});
  CHECK(m.inside_vector == dvec3(0, 1, 0));
}

TEST_CASE("mesh2: normals and uvs by vertex, by index, or one for all", "[interpreter][mesh]") {
  const Run r = run(
      mesh2(corners + "normal_vectors { 4, -2*z, -z, 0, -z } uv_vectors { 4, 0, <1,0>, <1,1>, <0,1> } " +
            faces) +
      mesh2(corners + "normal_vectors { 1, -z } uv_vectors { 1, 0.5 } " + faces +
            "normal_indices { 1, <0,0,0> }") +
      mesh2(corners + "uv_vectors { 2, 0, 1 } " + faces + "uv_indices { 2, <0,1,0>, <1,1,1> }"));
  const scene::Mesh& by_vertex = mesh_of(r, 0);
  CHECK(by_vertex.normals_by_vertex);
  CHECK(by_vertex.normals[0] == vec3(0, 0, -1));
  CHECK(by_vertex.normals[2] == vec3(1, 0, 0));
  CHECK(r.warnings.size() == 1);  // of the zero normal
  CHECK(by_vertex.uvs_of(1) == Triple{0, 2, 3});
  const scene::Mesh& indexed = mesh_of(r, 1);
  CHECK(indexed.normals_of(0)[0] == 0);
  CHECK(indexed.normals_of(1)[0] == scene::none);
  CHECK(indexed.uvs_of(1) == Triple{0, 0, 0});
  CHECK(mesh_of(r, 2).uvs_of(0) == Triple{0, 1, 0});
}

TEST_CASE("mesh2: texture indices may follow a face", "[interpreter][mesh]") {
  const Run r = run(
      "#declare N = 1; #declare F = <0,2,3>;\n" +
      mesh2(corners + "texture_list { 2, texture { pigment { rgb 1 } } texture { } } " +
            "face_indices { 3, <0,1,2>, 0, 1, 0 F, N <0,1,3> }"));
  const scene::Mesh& m = mesh_of(r);
  CHECK(m.textures.size() == 2);
  CHECK(m.textures_of(0) == Triple{0, 1, 0});
  CHECK(m.textures_of(1) == Triple{1, scene::none, scene::none});
  CHECK(m.textures_of(2)[0] == scene::none);
}

TEST_CASE("mesh2: errors name the index, the list and the place", "[interpreter][mesh]") {
  CHECK(error_of(mesh2(corners + "face_indices { 1, <0,1,4> }")) ==
        "D0302 at 1:84: there is no vertex 4");
  CHECK(error_of(mesh2(corners + "face_indices { 1, <0,1,-1> }")).substr(0, 5) == "D0302");
  CHECK(error_of(mesh2(corners + "face_indices { 3, <0,1,2>, <0,2,3> }")).find("announces 3") !=
        std::string::npos);
  CHECK(error_of(mesh2(corners + "face_indices { 1, <0,1,2>, <0,2,3> }")).substr(0, 5) == "D0201");
  CHECK(error_of(mesh2(corners + "face_indices { 0 }")).substr(0, 5) == "D0302");
  CHECK(error_of(mesh2(corners)).find("face_indices") != std::string::npos);
  CHECK(error_of(mesh2(faces)).find("no vertices") != std::string::npos);
  CHECK(error_of(mesh2("vertex_vectors { 1e30 }")).substr(0, 5) == "D0302");
  CHECK(error_of(mesh2("vertex_vectors { -1 }")).substr(0, 5) == "D0302");
  CHECK(error_of(mesh2(corners + "normal_vectors { 1, x } " + faces)).find("normal_indices") !=
        std::string::npos);
  CHECK(error_of(mesh2(corners + "uv_vectors { 2, 0, 0 } " + faces)).find("uv_indices") !=
        std::string::npos);
  CHECK(error_of(mesh2(corners + "uv_vectors { 2, 0, 0 } " + faces + "uv_indices { 1, 0 }"))
            .substr(0, 5) == "D0302");
  CHECK(error_of(mesh2(corners + "uv_vectors { 1, x } " + faces)).substr(0, 5) == "D0204");
  CHECK(error_of(mesh2(corners + "texture_list { 2, texture { } texture { } } " +
                       "face_indices { 1, <0,1,2>, 0, 1 }"))
            .find("one texture or three") != std::string::npos);
  CHECK(error_of(mesh2(corners + faces + "normal_indices { 1, 0 }")).find("no normal 0") !=
        std::string::npos);
}

TEST_CASE("mesh: equal corners are merged, triangles without area dropped", "[interpreter][mesh]") {
  const Run r = run(
      "mesh { triangle { 0, x, y } triangle { 0 x x } inside_vector z\n"
      "smooth_triangle { 0, -z, x, x-z, z, y-z } smooth_triangle { 0, -z, y, -z, z, -z } }");
  const scene::Mesh& m = mesh_of(r);
  CHECK(m.vertices.size() == 4);
  CHECK(m.faces.size() == 3);
  CHECK(m.normals_of(0)[0] == scene::none);
  CHECK(m.normals_of(1)[0] == 0);
  CHECK(m.normals_of(2)[0] == scene::none);  // three times the same
  CHECK(m.has_inside());
  CHECK(error_of("mesh { triangle { 0, 0, x } }").substr(0, 5) == "D0401");
  CHECK(error_of("mesh { }").substr(0, 5) == "D0401");
}

TEST_CASE("mesh: triangles bring textures and uvs", "[interpreter][mesh]") {
  const Run r = run(
      "#declare A = texture { pigment { rgb 1 } } #declare B = texture { pigment { rgb x } }\n"
      "mesh { triangle { 0, x, y } triangle { 0, x, z uv_vectors 0, <1,0>, <0,1> texture { B } }\n"
      "triangle { 0, y, z texture_list { A, B A } } }");
  const scene::Mesh& m = mesh_of(r);
  CHECK(m.textures.size() == 2);
  CHECK(m.textures_of(0)[0] == scene::none);
  CHECK(m.textures_of(1) == Triple{0, scene::none, scene::none});
  CHECK(m.textures_of(2) == Triple{1, 0, 1});
  CHECK(m.uvs_of(0)[0] == scene::none);
  CHECK(m.uvs_of(1) == Triple{0, 1, 2});
}

TEST_CASE("mesh: copies share the triangles", "[interpreter][mesh]") {
  const Run r = run("#declare M = mesh { triangle { 0, x, y } } object { M } object { M scale 2 }");
  CHECK(&mesh_of(r, 0) == &mesh_of(r, 1));
}

TEST_CASE("uv_mapping: keeps textures in place, and must come first", "[interpreter][mesh]") {
  const Run r = run("sphere { 0, 1 uv_mapping pigment { rgb 1 } translate x }");
  REQUIRE(r.scene);
  CHECK(object(r).uv_mapping);
  CHECK(object(r).texture.transform.is_identity());
  CHECK(error_of("sphere { 0, 1 pigment { rgb 1 } uv_mapping }").substr(0, 5) == "D0402");
}
