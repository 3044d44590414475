// Pictures that come back as they were written, whatever the format.
#include "image/read.h"

#include <png.h>

#include <cstdio>

#include "image/image.h"
#include "tests/unit/image/read_back.h"

namespace durer::image::test {
namespace {

Image ramp() {
  Image image(5, 3);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) {
      const auto p = image.at(x, y);
      p[0] = static_cast<float>(x) / 4;
      p[1] = static_cast<float>(y) / 2;
      p[2] = 0.25F;
      p[3] = 1;
    }
  }
  return image;
}

Encoding raw(int bits) {
  Encoding e;
  e.encode = false;
  e.bits = bits;
  return e;
}

}  // namespace

TEST_CASE("read: palettes of BMP and TGA files stay palettes", "[image][read]") {
  const Folder folder;
  const auto number = [](std::string& to, std::uint32_t n, int bytes) {
    for (int i = 0; i < bytes; ++i) to += static_cast<char>((n >> (8 * i)) & 0xFFU);
  };
  std::string bmp = "BM";
  for (const std::uint32_t n : {0U, 0U, 14U + 40 + 8, 40U, 3U, 2U}) number(bmp, n, 4);
  number(bmp, 1, 2);
  number(bmp, 1, 2);  // one bit a pixel
  for (const std::uint32_t n : {0U, 0U, 0U, 0U, 2U, 0U}) number(bmp, n, 4);
  for (const std::uint32_t bgr : {0x102030U, 0xFF0001U}) number(bmp, bgr, 4);
  for (const std::uint32_t row : {0xA0U, 0x60U}) number(bmp, row, 4);  // 101, then 011 above it
  std::string tga;
  for (const std::uint32_t b : {0U, 1U, 9U, 0U, 0U, 2U, 0U, 24U, 0U, 0U, 0U, 0U, 3U, 0U, 2U, 0U, 8U, 0x20U}) {
    number(tga, b, 1);
  }
  for (const std::uint32_t bgr : {0x102030U, 0xFF0001U}) number(tga, bgr, 3);
  for (const std::uint32_t b : {0U, 0U, 0x82U, 1U, 1U, 0U, 1U}) number(tga, b, 1);
  const auto check = [&](const char* name, const std::string& bytes) {
    CAPTURE(name);
    const std::string path = folder / name;
    std::FILE* file = std::fopen(path.c_str(), "wb");
    REQUIRE(file != nullptr);
    std::fwrite(bytes.data(), 1, bytes.size(), file);
    std::fclose(file);
    const PictureRead read = image::read(path, "");
    REQUIRE(read.picture != nullptr);
    CHECK(read.picture->codes == std::vector<std::uint16_t>{0, 1, 1, 1, 0, 1});
    REQUIRE(read.picture->palette.size() == 2);
    CHECK(read.picture->palette[1] == std::array<std::uint8_t, 4>{0xFF, 0, 1, 255});
  };
  check("p.bmp", bmp);
  check("p.tga", tga);
}

TEST_CASE("read: 8-bit formats give back their codes", "[image][read]") {
  const Folder folder;
  for (const char* name : {"png", "ppm", "bmp", "tga"}) {
    CAPTURE(name);
    const Format* format = format_named(name);
    if (format == nullptr) continue;
    const std::string path = folder / (std::string("ramp.") + name);
    REQUIRE_FALSE(write(ramp(), path, *format, raw(8)));
    const PictureRead read = image::read(path);
    CAPTURE(read.error);
    REQUIRE(read.picture);
    const Picture& p = *read.picture;
    CHECK(p.width == 5);
    CHECK(p.height == 3);
    REQUIRE(p.bits == 8);
    REQUIRE(p.channels >= 3);
    CHECK(p.codes[p.index(4, 0, 0)] == 255);
    CHECK(p.codes[p.index(0, 0, 0)] == 0);
    CHECK(p.codes[p.index(0, 2, 1)] == 255);
  }
}

TEST_CASE("read: 16 bits stay 16 bits, floats stay floats", "[image][read]") {
  const Folder folder;
  REQUIRE_FALSE(write(ramp(), folder / "a.png", *format_named("png"), raw(16)));
  const PictureRead png = image::read(folder / "a.png");
  REQUIRE(png.picture);
  CHECK(png.picture->bits == 16);
  CHECK(png.picture->codes[png.picture->index(4, 0, 0)] == 65535);
  const Format* exr = format_named("exr");
  REQUIRE(exr != nullptr);
  REQUIRE_FALSE(write(ramp(), folder / "a.exr", *exr, raw(16)));
  const PictureRead real = image::read(folder / "a.exr");
  CAPTURE(real.error);
  REQUIRE(real.picture);
  CHECK(real.picture->is_real());
  CHECK(real.picture->samples.size() >= 45);
}

TEST_CASE("read: palettes stay palettes", "[image][read]") {
  const Folder folder;
  const std::string path = folder / "p.png";
  std::FILE* file = std::fopen(path.c_str(), "wb");
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, file);
  png_set_IHDR(png, info, 2, 1, 4, PNG_COLOR_TYPE_PALETTE, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  const png_color colours[3] = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  png_set_PLTE(png, info, colours, 3);
  png_write_info(png, info);
  const unsigned char row[1] = {0x21};  // indices 2 and 1
  png_write_row(png, row);
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  std::fclose(file);
  const PictureRead read = image::read(path);
  CAPTURE(read.error);
  REQUIRE(read.picture);
  REQUIRE(read.picture->palette.size() == 3);
  CHECK(read.picture->palette[2][0] == 7);
  CHECK(read.picture->codes == std::vector<std::uint16_t>{2, 1});
}

TEST_CASE("read: GIF gives indices", "[image][read]") {
  const Folder folder;
  // Two by one pixels, four colours; codes of 3 bits: clear, 2, 1, end.
  const unsigned char bytes[] = {'G', 'I', 'F', '8', '9', 'a', 2,  0,  1,  0,    0x81, 0,    0,   0,
                                 0,   0,   10,  11,  12,  20,  21, 22, 30, 31,   32,   0x2C, 0,   0,
                                 0,   0,   2,   0,   1,   0,   0,  2,  2,  0x54, 0x0A, 0,    0x3B};
  std::FILE* file = std::fopen((folder / "a.gif").c_str(), "wb");
  std::fwrite(bytes, 1, sizeof bytes, file);
  std::fclose(file);
  const PictureRead read = image::read(folder / "a.gif");
  CAPTURE(read.error);
  REQUIRE(read.picture);
  CHECK(read.picture->palette[2][1] == 21);
  CHECK(read.picture->codes == std::vector<std::uint16_t>{2, 1});
}

TEST_CASE("read: portable maps of every kind", "[image][read]") {
  const Folder folder;
  const auto read_text = [&](const std::string& bytes) {
    const std::string path = folder / "a.pnm";
    std::FILE* file = std::fopen(path.c_str(), "wb");
    REQUIRE(file != nullptr);
    std::fwrite(bytes.data(), 1, bytes.size(), file);
    std::fclose(file);
    return read(path);
  };
  using Codes = std::vector<std::uint16_t>;
  const auto codes = [&](const std::string& bytes) {
    const PictureRead found = read_text(bytes);
    CAPTURE(bytes, found.error);
    REQUIRE(found.picture);
    return found.picture->codes;
  };
  using namespace std::string_literals;
  CHECK(codes("P1 3 2 1 0 1 010") == Codes{0, 255, 0, 255, 0, 255});
  CHECK(codes("P4 # rows begin with a new byte\n3 2\n\xA0\x40") == Codes{0, 255, 0, 255, 0, 255});
  CHECK(codes("P2 2 1 255 7 255") == Codes{7, 255});
  CHECK(codes("P5\n#one\n#two\n2 1\n255\n\x07\xFF") == Codes{7, 255});
  CHECK(codes("P3 1 1 65535 1 2 65535") == Codes{1, 2, 65535});
  CHECK(codes("P6 1 1 65535\n\0\x01\x02\x03\xFF\xFF"s) == Codes{1, 0x203, 0xFFFF});
  const PictureRead fifths = read_text("P5 2 1 5\n\x01\x05");
  REQUIRE(fifths.picture);
  CHECK(fifths.picture->is_real());
  CHECK(fifths.picture->samples == std::vector<float>{0.2F, 1.0F});
  for (const char* broken : {"P5 2 2 255\nabc", "P2 2 1 255 7", "P3 1 1 255 1 x 2", "P1 2 1 1"}) {
    CAPTURE(broken);
    CHECK(read_text(broken).error == "it ends too early");
  }
  for (const char* senseless : {"P5 0 2 255\nabc", "P5 2", "P2 1 1 0 0", "P2 1 1 70000 0",
                                "P5 4000000 4000000 255\n", "P6 -1 1 255\nabc"}) {
    CAPTURE(senseless);
    CHECK(read_text(senseless).error == "its header makes no sense");
  }
}

TEST_CASE("read: files that are none say so", "[image][read]") {
  const Folder folder;
  CHECK_FALSE(image::read(folder / "absent.png").picture);
  std::FILE* file = std::fopen((folder / "short.png").c_str(), "wb");
  const unsigned char start[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n', 0, 0};
  std::fwrite(start, 1, sizeof start, file);
  std::fclose(file);
  const PictureRead broken = image::read(folder / "short.png");
  CHECK_FALSE(broken.picture);
  CHECK_FALSE(broken.error.empty());
}

}  // namespace durer::image::test
