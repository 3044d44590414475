#pragma once

#include <cstdio>

#include "base/picture.h"

namespace durer::image {

/// Portable Network Graphics from the file's beginning on. Greys of less than 8 bits are stretched
/// to 8, palettes stay.
[[nodiscard]] PictureRead read_png(std::FILE* file);

}  // namespace durer::image
