#pragma once

#include <cstdio>

#include "base/picture.h"

namespace durer::image {

/// The first picture of a GIF file, from the file's beginning on, with its palette: OpenImageIO
/// gives colours only, and height fields are made of the indices.
[[nodiscard]] PictureRead read_gif(std::FILE* file);

}  // namespace durer::image
