// Reading objects whose operands are more than a few numbers in their places: words, lists of
// points, components. What the lists mean, and whether they make sense, is the business of the
// types themselves (TypeInfo::validate).
#pragma once

#include <vector>

#include "interpreter/interpreter.h"

namespace durer::interpreter {

class MeshBuilder;
struct MeshFile;
struct MeshMaterial;

/// How a component of a blob is moved. What leaves a ball a ball changes its centre and radius; from
/// the first step on that may not, there is a matrix. Only boxes tell the difference.
struct BlobMove {
  bool stays_ball = false;
  Transform kept;     // while it is a ball
  double growth = 1;  // of its radius
  Transform rest;

  void then(const Token& word, const Transform& step);
};

class ObjectReader {
 public:
  /// Reads into `object`, whose word is `word`.
  ObjectReader(Interpreter& in, scene::Object& object, const Token& word)
      : in_(in), object_(object), word_(word) {}

  void bicubic_patch();
  void blob();
  void height_field();
  void julia_fractal();
  void lathe();
  void polygon();
  void prism();
  void sor();
  void sphere_sweep();

  /// `import "file"` in a mesh; false, with nothing read, if there is none.
  bool imported(MeshBuilder& builder);

  /// Hands the operands over to the object.
  void finish() { object_.args = args_; }

 private:
  double number(const char* what);
  MeshFile file_of_mesh(const std::string& path, Span span);
  void add_material_files(MeshFile& file, const std::string& path, Span span);
  scene::TextureId material_texture(const MeshMaterial& material);
  bool accept(grammar::SymbolId word) { return in_.accept(word); }
  bool spline_word(double& kind);
  void points(double count, int width);
  void vector();
  void put_vector(std::size_t at, int width);
  scene::HeightField picture_heights();
  scene::HeightField function_heights();
  bool julia_function();
  void read_power();
  void blob_component(bool rod);
  void blob_modifiers(BlobMove& move, scene::TextureUse& texture);

  Interpreter& in_;
  scene::Object& object_;
  std::vector<double> args_;
  Token word_;
};

}  // namespace durer::interpreter
