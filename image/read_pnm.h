#pragma once

#include <cstdio>

#include "base/picture.h"

namespace durer::image {

/// Reads PBM, PGM and PPM files, in text or binary. Numbers that are no bytes or 16 bits, because
/// the file counts to something else, become real samples: nothing is rounded.
[[nodiscard]] PictureRead read_pnm(std::FILE* file);

}  // namespace durer::image
