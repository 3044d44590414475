// `mesh` and `mesh2` (objects §11.5, §11.6).
#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "interpreter/mesh_builder.h"
#include "interpreter/object_reader.h"

namespace durer::interpreter {

namespace w = grammar::words;

namespace {

/// No list may be longer: indices are 32 bits, and the greatest means "none".
constexpr double longest_list = 4294967294.0;
/// Lists grow as they are read; room for no more than this is made on the scene's word alone.
constexpr std::size_t most_trusted = 1U << 22;

template <typename T>
void prepare_list(std::vector<T>& list, std::size_t count) {
  list.clear();
  list.reserve(std::min(count, most_trusted));
}

}  // namespace

// ---- lists of numbers --------------------------------------------------------------------------

/// Takes up to `most` elements from the list, as take(components, place); returns how many.
template <typename Take>
std::size_t Interpreter::take_literals(Frame& frame, std::size_t most, Take&& take) {
  const grammar::LiteralRun& run = frame.tree->literals[frame.node];
  grammar::LiteralReader reader(run, frame.pos);
  std::size_t taken = 0;
  double v[5];
  bool more = true;
  while (taken < most && more) {
    const auto at = static_cast<Loc>(frame.call.begin + reader.offset(run));
    reader.read(v);
    take(v, Span{at, 1});
    ++taken;
    more = reader.comma() && reader.offset(run) < run.text.size();
  }
  frame.pos = static_cast<std::uint32_t>(reader.offset(run));
  return taken;
}

/// `{ n, <…>, <…> … }`: vectors of `width` components, each given to take(components, place). Long
/// lists of literals come straight from the text.
template <typename Start, typename Take>
void Interpreter::read_vectors(int width, std::string_view block, Start&& start, Take&& take) {
  read_counted(block, start, [&](std::size_t i, std::size_t count) -> std::size_t {
    if (Frame* list = literals_ahead(width)) return take_literals(*list, count - i, take);
    last_span_ = peek().span;
    const Num n = fit(read_num(width), width);
    take(n.v.data(), last_span_);
    return 1;
  });
}

/// `{ n, item… }`: reads the count, calls start(n), then read(i, n), which takes one item or more
/// and returns how many, until there are n.
template <typename Start, typename Read>
void Interpreter::read_counted(std::string_view block, Start&& start, Read&& read) {
  const Span opened = peek().span;
  expect_open(block);
  const Span at = peek().span;
  const double n = std::trunc(read_scalar("the number of items"));
  if (!(n >= 0 && n <= longest_list)) {
    fail(Code::out_of_range, at, fmt::format("`{}` cannot hold {} items", block, n));
  }
  const auto count = static_cast<std::size_t>(n);
  start(count);
  for (std::size_t i = 0; i < count;) {
    optional_comma();
    if (!at_literals() && (peek().kind == Token::Kind::close || peek().kind == Token::Kind::end)) {
      Diagnostic d;
      d.code = Code::missing_argument;
      d.span = peek().span;
      d.message = fmt::format("`{}` announces {} items, here are {}", block, count, i);
      d.labels.push_back({at, "the number of items"});
      fail(std::move(d));
    }
    i += read(i, count);
  }
  optional_comma();
  expect_close(block, opened);
}

dvec2 Interpreter::read_uv() {
  last_span_ = peek().span;
  const Num n = fit(read_num(2), 2);
  return {n.v[0], n.v[1]};
}

/// Three indices, each below `limit`.
scene::Triple Interpreter::to_triple(const double* v, std::size_t limit, std::string_view what,
                                     Span span) {
  scene::Triple triple{};
  for (std::size_t i = 0; i < 3; ++i) triple[i] = to_index(v[i], limit, what, span);
  return triple;
}

/// Fractions of an index are cut off (objects §11.6).
std::uint32_t Interpreter::to_index(double value, std::size_t limit, std::string_view what,
                                    Span span) {
  const double index = std::trunc(value);
  if (!(index >= 0 && index < static_cast<double>(limit))) {
    fail(Code::out_of_range, span, fmt::format("there is no {} {}", what, index),
         limit == 0 ? fmt::format("this mesh has no list of them")
                    : fmt::format("they are numbered from 0 to {}", limit - 1));
  }
  return static_cast<std::uint32_t>(index);
}

/// True if a float follows, and not a vector.
bool Interpreter::starts_float(const Token& t) {
  if (!starts_number(t) || t.node<ast::Vector>() != nullptr) return false;
  if (const auto* g = t.node<ast::OpenGroup>()) return g->kind != ast::OpenGroup::Kind::vector;
  if (t.node<ast::Name>() != nullptr || t.node<ast::Index>() != nullptr) {
    const Value* v = lookup(*t.tree, t.expr, false);
    const Num* n = v == nullptr ? nullptr : v->get<Num>();
    return n == nullptr || n->length == 1;
  }
  return true;
}

// ---- mesh2 -------------------------------------------------------------------------------------

scene::Object Interpreter::read_mesh2(std::uint32_t type, const Token& word) {
  MeshBuilder builder;
  read_mesh2_vectors(builder, word);
  read_mesh2_faces(builder, word);
  read_mesh2_indices(builder, word);
  return finish_mesh(type, word, builder);
}

void Interpreter::read_mesh2_vectors(MeshBuilder& builder, const Token& word) {
  scene::Mesh& mesh = builder.mesh;
  const auto again = [&](const Token& t, bool had_one) {
    if (had_one) {
      warn(Code::scene, t.span, fmt::format("a second `{}` replaces the first", name_of(t.word)));
    }
  };
  for (;;) {
    const Token t = peek();
    if (t.is(w::vertex_vectors)) {
      next();
      again(t, !mesh.vertices.empty());
      read_vectors(3, "vertex_vectors", [&](std::size_t n) { prepare_list(mesh.vertices, n); },
                   [&](const double* v, Span) { mesh.vertices.push_back(vec3(v[0], v[1], v[2])); });
    } else if (t.is(w::normal_vectors)) {
      next();
      again(t, !mesh.normals.empty());
      read_vectors(3, "normal_vectors", [&](std::size_t n) { prepare_list(mesh.normals, n); },
                   [&](const double* v, Span) {
                     mesh.normals.push_back(builder.unit({v[0], v[1], v[2]}));
                   });
    } else if (t.is(w::uv_vectors)) {
      next();
      again(t, !mesh.uvs.empty());
      read_vectors(2, "uv_vectors", [&](std::size_t n) { prepare_list(mesh.uvs, n); },
                   [&](const double* v, Span) { mesh.uvs.push_back(glm::vec2(v[0], v[1])); });
    } else if (t.is(w::texture_list)) {
      next();
      read_counted("texture_list", [&](std::size_t n) { prepare_list(mesh.textures, n); },
                   [&](std::size_t, std::size_t) {
                     mesh.textures.push_back(read_listed_texture());
                     return std::size_t{1};
                   });
      break;  // it is the last (objects §11.6)
    } else if (t.is_punct(',') || t.is_punct(';')) {
      next();
    } else {
      break;
    }
  }
  if (mesh.vertices.empty()) {
    fail(Code::missing_argument, word.span, "this `mesh2` has no vertices",
         "begin with `vertex_vectors { n, <x, y, z>, … }`");
  }
}

scene::TextureId Interpreter::read_listed_texture() {
  const Token t = next();
  if (t.is(w::texture)) return read_texture("texture");
  const Value* v = t.kind == Token::Kind::expr ? lookup(*t.tree, t.expr, true) : nullptr;
  const TextureRef* ref = v == nullptr ? nullptr : v->get<TextureRef>();
  if (ref == nullptr) unexpected(t, "a texture");
  return ref->id;
}

void Interpreter::read_mesh2_faces(MeshBuilder& builder, const Token& word) {
  scene::Mesh& mesh = builder.mesh;
  optional_comma();
  if (!accept(w::face_indices)) {
    fail(Code::missing_argument, peek().span,
         fmt::format("expected `face_indices` in this `{}`, found {}", name_of(word.word),
                     describe(peek())));
  }
  const auto start = [&](std::size_t n) {
    if (n == 0) fail(Code::out_of_range, word.span, "this `mesh2` has no faces");
    prepare_list(mesh.faces, n);
  };
  const auto add = [&](const double* v, Span at) {
    mesh.faces.push_back(to_triple(v, mesh.vertices.size(), "vertex", at));
  };
  if (mesh.textures.empty()) {
    read_vectors(3, "face_indices", start, add);
    return;
  }
  read_counted("face_indices", start, [&](std::size_t face, std::size_t) {
    const dvec3 v = read_vector();
    add(&v.x, last_span_);
    read_mesh2_textures(builder, face);
    return std::size_t{1};
  });
}

/// Up to three indices of textures may follow the vertices of a face.
void Interpreter::read_mesh2_textures(MeshBuilder& builder, std::size_t face) {
  scene::Triple textures{scene::none, scene::none, scene::none};
  for (std::uint32_t& texture : textures) {
    // The comma may also be the one before the next face: it is taken either way.
    optional_comma();
    if (!starts_float(peek())) break;
    const Span at = peek().span;
    texture =
        to_index(read_scalar("the index of a texture"), builder.mesh.textures.size(), "texture", at);
  }
  if (textures[0] == scene::none) return;
  if (textures[1] != scene::none && textures[2] == scene::none) {
    fail(Code::missing_argument, peek().span, "a face has one texture or three, here are two");
  }
  builder.set_textures(face, textures);
}

void Interpreter::read_mesh2_indices(MeshBuilder& builder, const Token& word) {
  scene::Mesh& mesh = builder.mesh;
  for (;;) {
    const Token t = peek();
    const bool uvs = t.is(w::uv_indices);
    if (!uvs && !t.is(w::normal_indices)) break;
    next();
    std::vector<scene::Triple>& list = uvs ? mesh.face_uvs : mesh.face_normals;
    if (!list.empty()) {
      fail(Code::scene, t.span, fmt::format("this mesh has `{}` already", name_of(t.word)));
    }
    const std::size_t limit = uvs ? mesh.uvs.size() : mesh.normals.size();
    const auto start = [&](std::size_t n) {
      if (uvs ? n != mesh.faces.size() : n > mesh.faces.size()) {
        fail(Code::out_of_range, t.span,
             fmt::format("`{}` holds {} triples for {} faces", name_of(t.word), n,
                         mesh.faces.size()));
      }
      prepare_list(list, n);
    };
    read_vectors(3, name_of(t.word), start, [&](const double* v, Span at) {
      list.push_back(to_triple(v, limit, uvs ? "uv vector" : "normal", at));
    });
    optional_comma();
  }
  if (mesh.face_uvs.empty() && !mesh.uvs.empty()) {
    mesh.uvs_by_vertex = mesh.uvs.size() == mesh.vertices.size();
    if (!mesh.uvs_by_vertex && mesh.uvs.size() != 1) missing_indices("uv_indices", word);
    if (!mesh.uvs_by_vertex) mesh.face_uvs.assign(mesh.faces.size(), scene::Triple{0, 0, 0});
  }
  if (mesh.face_normals.empty() && !mesh.normals.empty()) {
    mesh.normals_by_vertex = mesh.normals.size() == mesh.vertices.size();
    if (!mesh.normals_by_vertex) missing_indices("normal_indices", word);
  }
}

void Interpreter::missing_indices(std::string_view block, const Token& word) {
  fail(Code::missing_argument, word.span,
       fmt::format("this `{}` needs `{}`: its lists differ in length", name_of(word.word), block));
}

// ---- mesh --------------------------------------------------------------------------------------

scene::Object Interpreter::read_mesh(std::uint32_t type, const Token& word) {
  MeshBuilder builder;
  scene::Object unused;
  if (ObjectReader(*this, unused, word).imported(builder)) return finish_mesh(type, word, builder);
  for (;;) {
    const Token t = peek();
    if (t.is(w::triangle) || t.is(w::smooth_triangle)) {
      next();
      read_mesh_triangle(builder, t);
    } else if (t.is(w::inside_vector)) {
      next();
      builder.set_inside(read_vector());
    } else if (t.is_punct(';')) {
      next();
    } else {
      break;
    }
  }
  if (builder.mesh.faces.empty()) {
    fail(Code::degenerate, word.span, "this `mesh` has no triangle with an area");
  }
  return finish_mesh(type, word, builder);
}

void Interpreter::read_mesh_triangle(MeshBuilder& builder, const Token& word) {
  const std::string_view block = name_of(word.word);
  const Span opened = peek().span;
  expect_open(block);
  MeshBuilder::Triangle triangle;
  triangle.smooth = word.is(w::smooth_triangle);
  for (std::size_t i = 0; i < 3; ++i) {
    if (i > 0) optional_comma();
    triangle.corners[i] = vec3(read_vector());
    if (!triangle.smooth) continue;
    optional_comma();
    triangle.normals[i] = builder.unit(read_vector());
  }
  if (accept(w::uv_vectors)) {
    triangle.has_uvs = true;
    for (std::size_t i = 0; i < 3; ++i) {
      if (i > 0) optional_comma();
      triangle.uvs[i] = glm::vec2(read_uv());
    }
  }
  if (accept(w::texture)) {
    triangle.textures[0] = builder.texture(read_texture("texture"));
  } else if (accept(w::texture_list)) {
    const Span list = peek().span;
    expect_open("texture_list");
    for (std::size_t i = 0; i < 3; ++i) {
      if (i > 0) optional_comma();
      triangle.textures[i] = builder.texture(read_listed_texture());
    }
    expect_close("texture_list", list);
  }
  expect_close(block, opened);
  builder.add(triangle);
}

// ---- both --------------------------------------------------------------------------------------

scene::Object Interpreter::finish_mesh(std::uint32_t type, const Token& word,
                                       MeshBuilder& builder) {
  optional_comma();
  if (accept(w::inside_vector)) builder.set_inside(read_vector());
  if (builder.zero_normals) {
    warn(Code::degenerate, word.span, "a normal of this mesh is <0, 0, 0>; x is used instead");
  }
  scene::Object o = primitive(type, word);
  o.extras.edit().mesh = std::make_shared<const scene::Mesh>(builder.finish());
  return o;
}

}  // namespace durer::interpreter
