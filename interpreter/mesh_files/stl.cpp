// STL: bare triangles, as text or as numbers. Corners that are equal become one vertex, so that
// normals can be smoothed.
#include <cstring>

#include "interpreter/mesh_builder.h"
#include "interpreter/mesh_files/words.h"

namespace durer::interpreter {
namespace {

constexpr std::size_t header_size = 80;
constexpr std::size_t record_size = 50;  // a normal, three corners, two bytes of no use to us

std::uint32_t number_of_triangles(std::string_view bytes) {
  std::uint32_t n = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    n |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[header_size + i])) << (8 * i);
  }
  return n;
}

float real(const char* from) {
  std::uint32_t n = 0;
  for (unsigned i = 0; i < 4; ++i) {
    n |= static_cast<std::uint32_t>(static_cast<unsigned char>(from[i])) << (8 * i);
  }
  float x = 0;
  std::memcpy(&x, &n, sizeof x);
  return x;
}

MeshFile finish(MeshBuilder& builder) {
  MeshFile file;
  file.mesh = builder.finish();
  return file;
}

MeshFile read_binary(std::string_view bytes) {
  const std::uint32_t count = number_of_triangles(bytes);
  MeshBuilder builder;
  builder.mesh.faces.reserve(count);
  const char* at = bytes.data() + header_size + 4;
  for (std::uint32_t i = 0; i < count; ++i, at += record_size) {
    MeshBuilder::Triangle triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      const char* corner = at + 12 * (k + 1);
      triangle.corners[k] = {real(corner), real(corner + 4), real(corner + 8)};
    }
    builder.add(triangle);
  }
  return finish(builder);
}

MeshFile read_text(std::string_view text) {
  WordReader in(text);
  MeshBuilder builder;
  MeshBuilder::Triangle triangle;
  std::size_t corners = 0;
  while (in.next_line()) {
    const std::string_view word = in.word();
    if (word == "vertex") {
      if (corners == 3) in.fail("a facet has more than three corners");
      triangle.corners[corners++] = in.vector();
    } else if (word == "endloop") {
      if (corners != 3) in.fail("a facet has less than three corners");
      builder.add(triangle);
      corners = 0;
    } else if (word != "solid" && word != "facet" && word != "outer" && word != "endfacet" &&
               word != "endsolid") {
      in.fail(fmt::format("`{}` does not belong into an STL file", WordReader::shown(word)));
    }
  }
  if (corners != 0) in.fail("the file ends within a facet");
  return finish(builder);
}

}  // namespace

// Files of numbers may begin with the word `solid` too: their length tells.
MeshFile read_stl(std::string_view bytes) {
  if (bytes.size() >= header_size + 4 &&
      bytes.size() == header_size + 4 + record_size * number_of_triangles(bytes)) {
    return read_binary(bytes);
  }
  const bool has_zeros = bytes.substr(0, header_size + 4).find('\0') != std::string_view::npos;
  if (bytes.substr(0, 5) == "solid" && !has_zeros) return read_text(bytes);
  if (bytes.size() < header_size + 4) throw MeshFileError{"it is too short for an STL file"};
  throw MeshFileError{fmt::format("it announces {} triangles and holds {} bytes of them",
                                  number_of_triangles(bytes), bytes.size() - header_size - 4)};
}

}  // namespace durer::interpreter
