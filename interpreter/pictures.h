#pragma once

#include <array>
#include <optional>
#include <string>

#include "base/gamma.h"
#include "base/picture.h"
#include "base/source.h"
#include "grammar/vocabulary.h"

namespace durer::interpreter {

/// `[format] "file" [gamma …] [premultiplied …]`: a picture and what the scene says about it.
struct PictureFile {
  std::shared_ptr<const Picture> picture;
  std::string kind;  // "png", "jpeg" …: as written, or as the file's name tells
  std::optional<GammaCurve> curve;
  std::optional<bool> premultiplied;
  Span span;
};


}  // namespace durer::interpreter
