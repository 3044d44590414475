#pragma once

#include <string>

#include "base/picture.h"

namespace durer::image {

/// Reads a picture file of any format: PNG by libpng; GIF, Amiga's IFF and portable maps here, the
/// others by OpenImageIO. What the file is shows in its first bytes; `kind` is asked only where they
/// tell nothing.
[[nodiscard]] PictureRead read(const std::string& path, const std::string& kind = {});

}  // namespace durer::image
