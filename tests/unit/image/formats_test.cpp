#include <set>

#include "image/codes.h"
#include "tests/unit/image/read_back.h"

namespace durer::image {
namespace {

/// Every pixel another colour, all codes of 8 bits exactly representable.
Image ramp(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto p = image.at(x, y);
      p[0] = static_cast<float>((x * 7 + y * 31) % 256) / 255.0F;
      p[1] = static_cast<float>((x * 13 + y * 3) % 256) / 255.0F;
      p[2] = static_cast<float>((x + y * 11) % 256) / 255.0F;
      p[3] = 1.0F;
    }
  }
  return image;
}

Encoding identity(int bits) {
  Encoding e;
  e.working = e.file = GammaCurve::srgb();
  e.bits = bits;
  return e;
}

}  // namespace

TEST_CASE("formats: every format of the list can be found by name, letter and extension",
          "[image][formats]") {
  std::set<char> letters;
  for (const Format* f : formats()) {
    CAPTURE(f->name);
    CHECK(format_named(f->name) == f);
    CHECK(format_of("some.folder/a.b" + std::string(f->extension)) == f);
    CHECK_FALSE(f->doc.empty());
    if (f->letter == 0) continue;
    CHECK(letters.insert(f->letter).second);
    CHECK(format_named({&f->letter, 1}) == f);
  }
  CHECK(letters == std::set<char>{'B', 'E', 'H', 'J', 'N', 'P', 'T'});
}

TEST_CASE("formats: extensions count in any case and spelling", "[image][formats]") {
  CHECK(format_of("a.PNG")->name == "png");
  CHECK(format_of("a.jpeg")->name == "jpeg");
  CHECK(format_of("a.Tiff")->name == "tiff");
  CHECK(format_named("jpg")->name == "jpeg");
  CHECK(format_of("png") == nullptr);
  CHECK(format_of("a.png/b") == nullptr);
  CHECK(format_of("a.pov") == nullptr);
  CHECK(format_of("") == nullptr);
}

TEST_CASE("formats: a picture comes back as it was written", "[image][formats]") {
  const test::Folder folder;
  for (const Format* f : formats()) {
    CAPTURE(f->name);
    const int width = GENERATE(1, 7, 64);
    const Image image = ramp(width, 5);
    const std::string path = folder / ("a" + std::string(f->extension));
    REQUIRE_FALSE(write(image, path, *f, identity(8)));
    const auto stored = test::read_back(path);
    REQUIRE(stored.width == width);
    REQUIRE(stored.height == 5);
    REQUIRE(stored.channels == 3);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < stored.values.size(); ++i) {
      const float wanted = image.pixels[i / 3 * 4 + i % 3];
      const auto linear = static_cast<double>(GammaCurve::srgb().decode(wanted));
      double difference = 0;
      if (f->linear) {
        difference = std::abs(stored.values[i] - linear) - (f->name == "hdr" ? 1.0 / 128 : 1e-3);
      } else {
        difference = std::abs(stored.values[i] - std::round(wanted * 255.0F));
        if (f->name == "jpeg")
          difference -= 100;  // noise is its worst case; the means count, below
      }
      if (difference > 0) ++wrong;
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("formats: a large PNG comes back, grainy, flat and striped, at every level",
          "[image][formats]") {
  const test::Folder folder;
  Image image(500, 600);
  std::uint32_t grain = 1;
  for (int y = 0; y < 600; ++y) {
    for (int x = 0; x < 500; ++x) {
      grain = grain * 1664525U + 1013904223U;
      const float stripes = static_cast<float>(x * x % 97) / 97.0F;  // alike in all rows
      const float v = y < 200 ? static_cast<float>(grain >> 24) / 255.0F : y < 400 ? 0.5F : stripes;
      const auto p = image.at(x, y);
      std::fill(p.begin(), p.end(), v);
      p[3] = 1;
    }
  }
  Encoding e = identity(GENERATE(8, 16));
  const Encoded plain = format_named("png")->encode(image, e);
  e.compression = GENERATE(-1, 0, 1, 9);
  CAPTURE(e.bits, e.compression);
  REQUIRE_FALSE(write(image, folder / "a.png", *format_named("png"), e));
  Encoding side_by_side = e;
  side_by_side.threads = 3;
  CHECK(format_named("png")->encode(image, side_by_side).bytes ==
        format_named("png")->encode(image, e).bytes);
  const auto stored = test::read_back(folder / "a.png");
  const Codes codes = to_codes(image, e, depth_for(e.bits), false);
  REQUIRE(stored.values.size() == codes.values.size());
  CHECK(std::equal(codes.values.begin(), codes.values.end(), stored.values.begin()));
  const std::size_t raw = codes.values.size() * static_cast<std::size_t>(e.bits) / 8;
  CHECK(plain.bytes.size() < raw / 2);
}

TEST_CASE("formats: JPEG keeps plain colours within two codes", "[image][formats]") {
  const test::Folder folder;
  REQUIRE_FALSE(write(test::plain(20, 20, .2F, .5F, .8F), folder / "a.jpg", *format_named("jpeg"),
                      identity(8)));
  const auto stored = test::read_back(folder / "a.jpg");
  CHECK(stored.values[0] == Approx(51).margin(2));
  CHECK(stored.values[1] == Approx(128).margin(2));
  CHECK(stored.values[2] == Approx(204).margin(2));
}

TEST_CASE("formats: JPEG quality makes files smaller", "[image][formats]") {
  Encoding low = identity(8);
  low.compression = 5;
  const Format& jpeg = *format_named("jpeg");
  const Image image = ramp(64, 64);
  CHECK(jpeg.encode(image, low).bytes.size() * 2 < jpeg.encode(image, identity(8)).bytes.size());
}

TEST_CASE("formats: 16 bits reach the formats that have them", "[image][formats]") {
  const test::Folder folder;
  const Image image = test::plain(3, 2, 12345.0F / 65535, 0.5F, 1);
  for (const char* name : {"png", "tiff"}) {  // PPM: below, OpenImageIO rounds what it reads
    CAPTURE(name);
    const Format& f = *format_named(name);
    CHECK(f.max_bits == 16);
    const std::string path = folder / ("a" + std::string(f.extension));
    REQUIRE_FALSE(write(image, path, f, identity(16)));
    const auto stored = test::read_back(path);
    CHECK(stored.bits == 16);
    CHECK(stored.values[0] == 12345);
    CHECK(stored.values[1] == 32768);
    CHECK(stored.values[2] == 65535);
  }
}

TEST_CASE("formats: alpha goes into the formats that have it", "[image][formats]") {
  const test::Folder folder;
  Encoding e = identity(8);
  e.alpha = true;
  for (const Format* f : formats()) {
    CAPTURE(f->name);
    const std::string path = folder / ("a" + std::string(f->extension));
    REQUIRE_FALSE(write(test::plain(9, 2, 0.25F, 0, 0, 0.5F), path, *f, e));
    const auto stored = test::read_back(path);
    CHECK(stored.channels == (f->has_alpha ? 4 : 3));
    if (!f->has_alpha || f->linear) continue;
    CHECK(stored.values[0] == 128);
    CHECK(stored.values[3] == 128);
  }
}

TEST_CASE("formats: greyscale files have one channel where the format allows", "[image][formats]") {
  const test::Folder folder;
  Encoding e = identity(8);
  e.greyscale = true;
  for (const Format* f : formats()) {
    CAPTURE(f->name);
    const std::string path = folder / ("a" + std::string(f->extension));
    REQUIRE_FALSE(write(test::plain(9, 2, 1, 1, 1), path, *f, e));
    const auto stored = test::read_back(path);
    if (f->name == "hdr" || f->name == "bmp") continue;  // colour always; bmp: a palette
    CHECK(stored.channels == 1);
  }
}

TEST_CASE("formats: PNG tells its curve", "[image][formats]") {
  const test::Folder folder;
  const Format& png = *format_named("png");
  Encoding e = identity(8);
  const Image image = test::plain(2, 2, 1, 1, 1);
  REQUIRE_FALSE(write(image, folder / "srgb.png", png, e));
  CHECK(test::bytes_of(folder / "srgb.png").find("sRGB") != std::string::npos);
  e.file = GammaCurve::power(1.8F);
  REQUIRE_FALSE(write(image, folder / "power.png", png, e));
  CHECK(test::bytes_of(folder / "power.png").find("gAMA") != std::string::npos);
  CHECK(test::read_back(folder / "power.png").gamma == Approx(1.8).epsilon(1e-4));
  e.file = {};
  REQUIRE_FALSE(write(image, folder / "linear.png", png, e));
  const std::string linear = test::bytes_of(folder / "linear.png");
  const std::size_t chunk = linear.find("gAMA");
  REQUIRE(chunk != std::string::npos);
  CHECK(linear.substr(chunk + 4, 4) == std::string("\x00\x01\x86\xA0", 4));  // 100000: gamma 1
}

TEST_CASE("formats: PPM is plain bytes, with any number of bits", "[image][formats]") {
  Encoding e = identity(8);
  const Format& ppm = *format_named("ppm");
  auto text = [&](const Image& image) {
    const auto file = ppm.encode(image, e);
    return std::string(file.bytes.begin(), file.bytes.end());
  };
  CHECK(text(test::plain(1, 1, 1, 0, 0.2F)) == std::string("P6\n1 1\n255\n\xFF\x00\x33", 14));
  e.bits = 10;
  CHECK(text(test::plain(1, 1, 1, 0, 0)) == std::string("P6\n1 1\n1023\n\x03\xFF\0\0\0\0", 18));
  e.bits = 16;
  CHECK(text(test::plain(1, 1, 1, 12345.0F / 65535, 0)) ==
        std::string("P6\n1 1\n65535\n\xFF\xFF\x30\x39\0\0", 19));
  e.bits = 8;
  e.greyscale = true;  // without gamma, though the file's curve is sRGB
  e.working = {};
  CHECK(text(test::plain(1, 1, 0.2F, 0.2F, 0.2F)) == std::string("P5\n1 1\n255\n\x33", 12));
}

}  // namespace durer::image
