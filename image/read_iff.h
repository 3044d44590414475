#pragma once

#include <cstdio>

#include "base/picture.h"

namespace durer::image {

/// An Amiga picture (`FORM ILBM`), from the file's beginning on: 1 to 8 planes with a palette, of
/// which colours 32 to 63 may be dim ones; held colours to be modified (HAM); 24 planes. Masks and
/// transparent colours are alpha.
/// Errors:  files that end too early, lack a chunk, or say what makes no sense; other `FORM`s.
/// Source:  Morrison, "ILBM" IFF Interleaved Bitmap, in EA IFF 85, Electronic Arts, 1986; for eight
///          planes of held colours, Commodore's Amiga Graphics Architecture.
[[nodiscard]] PictureRead read_iff(std::FILE* file);

}  // namespace durer::image
