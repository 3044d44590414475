// The only file that knows FreeType.
#include "interpreter/font.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H
#include FT_TRUETYPE_TABLES_H

#include <array>
#include <unordered_map>

namespace durer::interpreter {

struct Font::Face {
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  std::unordered_map<unsigned, Glyph> glyphs;

  ~Face() {
    if (face != nullptr) FT_Done_Face(face);
    if (library != nullptr) FT_Done_FreeType(library);
  }
  [[nodiscard]] double em() const { return face->units_per_EM; }
};

namespace {

/// Writes arcs as FreeType walks along an outline.
struct Pen {
  std::vector<double>& out;
  double em;

  void point(const FT_Vector* p) {
    out.push_back(static_cast<double>(p->x) / em);
    out.push_back(static_cast<double>(p->y) / em);
  }
  template <typename... Points>
  static int add(void* pen, double degree, const Points*... points) {
    auto& self = *static_cast<Pen*>(pen);
    self.out.push_back(degree);
    (self.point(points), ...);
    return 0;
  }
};

int move_to(const FT_Vector* to, void* pen) { return Pen::add(pen, 0, to); }
int line_to(const FT_Vector* to, void* pen) { return Pen::add(pen, 1, to); }
int conic_to(const FT_Vector* c, const FT_Vector* to, void* pen) { return Pen::add(pen, 2, c, to); }
int cubic_to(const FT_Vector* a, const FT_Vector* b, const FT_Vector* to, void* pen) {
  return Pen::add(pen, 3, a, b, to);
}

/// Tables that old readers understand.
bool is_simple(FT_CharMap map) {
  const FT_Long format = FT_Get_CMap_Format(map);
  return format == 0 || format == 4 || format == 6;
}

}  // namespace

Font::Font() : face_(std::make_unique<Face>()) {}
Font::~Font() = default;

std::unique_ptr<Font> Font::open(const std::string& path) {
  std::unique_ptr<Font> font(new Font);
  Face& face = *font->face_;
  if (FT_Init_FreeType(&face.library) != 0) return nullptr;
  if (FT_New_Face(face.library, path.c_str(), 0, &face.face) != 0) return nullptr;
  if (!FT_IS_SCALABLE(face.face) || face.face->units_per_EM == 0) return nullptr;
  return font;
}

// The order of the oracle (objects §10.15); fonts of today may have none of these tables.
void Font::prefer_unicode(bool unicode) {
  const std::array<int, 3> platforms = unicode ? std::array{0, 3, 1} : std::array{1, 3, 0};
  for (const int platform : platforms) {
    for (FT_Int i = 0; i < face_->face->num_charmaps; ++i) {
      FT_CharMap map = face_->face->charmaps[i];
      if (map->platform_id != platform || !is_simple(map)) continue;
      FT_Set_Charmap(face_->face, map);
      return;
    }
  }
  FT_Select_Charmap(face_->face, FT_ENCODING_UNICODE);
}

unsigned Font::index_of(char16_t code) const {
  const FT_UInt found = FT_Get_Char_Index(face_->face, code);
  // Symbol fonts keep their characters in a private area.
  return found == 0 && code < 256 ? FT_Get_Char_Index(face_->face, code + 0xF000U) : found;
}

const Font::Glyph& Font::glyph(unsigned index) {
  const auto [at, is_new] = face_->glyphs.try_emplace(index);
  Glyph& glyph = at->second;
  if (!is_new) return glyph;
  FT_Face face = face_->face;
  if (FT_Load_Glyph(face, index, FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING) != 0) return glyph;
  glyph.advance = static_cast<double>(face->glyph->metrics.horiAdvance) / face_->em();
  glyph.bearing = static_cast<double>(face->glyph->metrics.horiBearingX) / face_->em();
  if (face->glyph->format != FT_GLYPH_FORMAT_OUTLINE) return glyph;
  FT_Outline_Funcs walk{};
  walk.move_to = move_to;
  walk.line_to = line_to;
  walk.conic_to = conic_to;
  walk.cubic_to = cubic_to;
  Pen pen{glyph.outline, face_->em()};
  FT_Outline_Decompose(&face->glyph->outline, &walk, &pen);
  return glyph;
}

double Font::kerning(unsigned left, unsigned right) const {
  FT_Vector k{};
  if (!FT_HAS_KERNING(face_->face)) return 0;
  if (FT_Get_Kerning(face_->face, left, right, FT_KERNING_UNSCALED, &k) != 0) return 0;
  return static_cast<double>(k.x) / face_->em();
}

}  // namespace durer::interpreter
