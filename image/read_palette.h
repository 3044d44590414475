#pragma once

#include <cstdio>
#include <optional>

#include "base/picture.h"

namespace durer::image {

/// BMP and TGA files with a palette, from the file's beginning on: OpenImageIO gives colours only,
/// and height fields are made of the indices. None if the file is no such file, or packed in a way
/// that is not known here.
[[nodiscard]] std::optional<Picture> read_bmp_palette(std::FILE* file);
[[nodiscard]] std::optional<Picture> read_tga_palette(std::FILE* file);

}  // namespace durer::image
