#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace durer::interpreter {

/// Outlines and metrics of one font file (TrueType, OpenType), in units of the em.
class Font {
 public:
  struct Glyph {
    /// Arcs as the `text` primitive takes them; empty for a space.
    std::vector<double> outline;
    double advance = 0;
    double bearing = 0;  // from the pen to the left edge of the outline
  };

  /// None if there is no such font, or no outlines in it.
  [[nodiscard]] static std::unique_ptr<Font> open(const std::string& path);
  ~Font();

  /// Which tables of characters are preferred: those for Unicode, or the old Macintosh ones.
  void prefer_unicode(bool unicode);
  /// The glyph for a code of a string; 0 is what the font shows for what it lacks.
  [[nodiscard]] unsigned index_of(char16_t code) const;
  [[nodiscard]] const Glyph& glyph(unsigned index);
  /// By how much two neighbours are moved together.
  [[nodiscard]] double kerning(unsigned left, unsigned right) const;

 private:
  Font();
  struct Face;
  std::unique_ptr<Face> face_;
};

}  // namespace durer::interpreter
