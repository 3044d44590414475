#include "image/read.h"

#include <array>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <string_view>

#include "image/oiio_file.h"
#include "image/read_gif.h"
#include "image/read_iff.h"
#include "image/read_palette.h"
#include "image/read_png.h"
#include "image/read_pnm.h"

namespace durer::image {
namespace {

// These files have no mark by which to know them.
bool is_tga(const std::string& path, const std::string& kind) {
  if (!kind.empty()) return kind == "tga";
  const auto ends_with = [&path](std::string_view end) {
    return path.size() >= end.size() && path.compare(path.size() - end.size(), end.size(), end) == 0;
  };
  return ends_with(".tga") || ends_with(".TGA");
}

}  // namespace

PictureRead read(const std::string& path, const std::string& kind) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  if (!file) return {nullptr, "it cannot be opened"};
  std::array<unsigned char, 8> magic{};
  const std::size_t got = std::fread(magic.data(), 1, magic.size(), file.get());
  constexpr std::array<unsigned char, 8> png = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  if (got == magic.size() && magic == png) {
    std::rewind(file.get());
    return read_png(file.get());
  }
  if (got >= 6 && std::memcmp(magic.data(), "GIF8", 4) == 0) {
    std::rewind(file.get());
    return read_gif(file.get());
  }
  if (got >= 4 && std::memcmp(magic.data(), "FORM", 4) == 0) {
    std::rewind(file.get());
    return read_iff(file.get());
  }
  if (got >= 2 && magic[0] == 'P' && magic[1] >= '1' && magic[1] <= '6') {
    std::rewind(file.get());
    return read_pnm(file.get());
  }
  const bool is_bmp = got >= 2 && std::memcmp(magic.data(), "BM", 2) == 0;
  if (is_bmp || is_tga(path, kind)) {
    std::rewind(file.get());
    auto picture = is_bmp ? read_bmp_palette(file.get()) : read_tga_palette(file.get());
    if (picture) return {std::make_shared<const Picture>(std::move(*picture)), ""};
  }
  return picture_of_file(path, kind);
}

}  // namespace durer::image
