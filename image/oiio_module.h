// What the OpenImageIO module offers to the rest of the image library.
#pragma once

#include "image/oiio_file.h"

namespace durer::image {

/// Exported by the module under the name `durer_oiio_module`.
struct OiioModule {
  Encoded (*codes)(const char* plugin, const Image& size, const Codes& codes,
                   Attributes attributes);
  Encoded (*samples)(const char* plugin, const Image& size, const Samples& samples, bool half,
                     Attributes attributes);
  PictureRead (*read)(const std::string& path, const std::string& kind);
};

}  // namespace durer::image
