// The one door to OpenImageIO: samples that are already what the file shall hold become bytes. The
// library is loaded at the first call.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/picture.h"
#include "image/codes.h"

namespace durer::image {

/// What a format says about its file beyond the samples, in OpenImageIO's names.
using Attributes = std::vector<std::pair<std::string, std::variant<int, float, std::string>>>;

/// A file with integer samples. The codes are stored as they are: no colour conversion, no
/// multiplication with alpha.
[[nodiscard]] Encoded file_of_codes(const char* plugin, const Image& size, const Codes& codes,
                                    Attributes attributes);

/// A file with floating-point samples, `half` or full.
[[nodiscard]] Encoded file_of_samples(const char* plugin, const Image& size, const Samples& samples,
                                      bool half, Attributes attributes);

/// A picture file of any format that OpenImageIO reads; `kind` as in read().
[[nodiscard]] PictureRead picture_of_file(const std::string& path, const std::string& kind);

/// The attributes by which readers learn which curve integer codes are in.
[[nodiscard]] Attributes curve_attributes(const GammaCurve& curve);

}  // namespace durer::image
