// Reads what image::write wrote, through OpenImageIO and as the codes stand in the file.
#pragma once

#include <OpenImageIO/imageio.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "image/image.h"
#include "tests/support/catch.h"

namespace durer::image::test {

/// A folder of its own for each test, gone afterwards.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "durer-image-XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  [[nodiscard]] std::string operator/(const std::string& name) const {
    return (path_ / name).string();
  }
  [[nodiscard]] std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
  }

 private:
  std::filesystem::path path_;
};

struct Stored {
  int width = 0;
  int height = 0;
  int channels = 0;
  int bits = 0;
  std::string colour_space;
  float gamma = 0;
  std::vector<double> values;  // codes, or numbers of a floating-point file
};

inline Stored read_back(const std::string& path) {
  OIIO::ImageSpec hints;
  hints.attribute("oiio:UnassociatedAlpha", 1);  // the codes, not their products with alpha
  const auto in = OIIO::ImageInput::open(path, &hints);
  REQUIRE(in);
  const OIIO::ImageSpec& spec = in->spec();
  Stored out{spec.width,
             spec.height,
             spec.nchannels,
             static_cast<int>(spec.format.basesize() * 8),
             std::string(spec.get_string_attribute("oiio:ColorSpace")),
             spec.get_float_attribute("oiio:Gamma"),
             {}};
  out.values.resize(static_cast<std::size_t>(spec.width) * spec.height * spec.nchannels);
  if (spec.format.is_floating_point()) {
    REQUIRE(in->read_image(0, 0, 0, -1, OIIO::TypeDesc::DOUBLE, out.values.data()));
    return out;
  }
  std::vector<std::uint16_t> codes(out.values.size());
  std::vector<std::uint8_t> bytes(out.values.size());
  if (out.bits == 16) {
    REQUIRE(in->read_image(0, 0, 0, -1, OIIO::TypeDesc::UINT16, codes.data()));
    out.values.assign(codes.begin(), codes.end());
  } else {
    REQUIRE(in->read_image(0, 0, 0, -1, OIIO::TypeDesc::UINT8, bytes.data()));
    out.values.assign(bytes.begin(), bytes.end());
  }
  return out;
}

inline std::string bytes_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A picture of one colour.
inline Image plain(int width, int height, float r, float g, float b, float alpha = 1) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    image.pixels[i] = r;
    image.pixels[i + 1] = g;
    image.pixels[i + 2] = b;
    image.pixels[i + 3] = alpha;
  }
  return image;
}

}  // namespace durer::image::test
