#include "image/codes.h"

#include <limits>

#include "tests/unit/image/read_back.h"

namespace durer::image {
namespace {

using test::plain;

Encoding encoding_for(const GammaCurve& working, const GammaCurve& file, int bits = 8) {
  Encoding e;
  e.working = working;
  e.file = file;
  e.bits = bits;
  return e;
}

std::vector<double> first_pixel(const Image& image, const char* format, const Encoding& e) {
  const test::Folder folder;
  const Format* f = format_named(format);
  REQUIRE(f != nullptr);
  const std::string path = folder / ("x" + std::string(f->extension));
  REQUIRE_FALSE(write(image, path, *f, e));
  auto stored = test::read_back(path);
  stored.values.resize(stored.channels);
  return stored.values;
}

/// Checks a 16-bit PNG against fractions known to within the rounding of their last digit.
void check_fractions(const std::vector<double>& codes, std::array<double, 3> wanted) {
  REQUIRE(codes.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(codes[i] / 65535 == Approx(wanted[i]).margin(0.5 / 65535 + 5e-7));
  }
}

}  // namespace

// The numbers are the oracle's, shading §10.6.
TEST_CASE("codes: file numbers follow assumed_gamma with File_Gamma=sRGB", "[image][codes]") {
  const Image image = plain(1, 1, 0.2F, 0.5F, 0.8F);
  const auto srgb = GammaCurve::srgb();
  check_fractions(first_pixel(image, "png", encoding_for({}, srgb, 16)),
                  {.484535, .735363, .906325});
  check_fractions(first_pixel(image, "png", encoding_for(GammaCurve::power(2.2F), srgb, 16)),
                  {.186282, .503868, .804837});
  check_fractions(first_pixel(image, "png", encoding_for(srgb, srgb, 16)), {.2, .500008, .8});
}

TEST_CASE("codes: without gamma handling numbers go out unchanged, whatever File_Gamma says",
          "[image][codes]") {
  Encoding e = encoding_for({}, {}, 16);
  e.encode = false;
  check_fractions(first_pixel(plain(1, 1, 0.2F, 0.5F, 0.8F), "png", e), {.2, .500008, .8});
}

TEST_CASE("codes: a linear file keeps the working numbers of assumed_gamma 1", "[image][codes]") {
  const Image image = plain(1, 1, .033112F, .214038F, .60383F);
  check_fractions(first_pixel(image, "png", encoding_for({}, {}, 16)), {.033112, .214038, .60383});
}

TEST_CASE("codes: 8 and 6 bits round as the oracle does", "[image][codes]") {
  const Encoding eight = encoding_for({}, GammaCurve::srgb());
  CHECK(first_pixel(plain(1, 1, 0.2F, 0.5F, 0.8F), "png", eight) ==
        std::vector<double>{124, 188, 231});
  const Encoding six = encoding_for({}, GammaCurve::srgb(), 6);
  CHECK(first_pixel(plain(1, 1, 0.2003F, 0.5F, 0.81F), "png", six) ==
        std::vector<double>{125, 186, 231});
}

TEST_CASE("codes: few bits are widened by repeating them", "[image][codes]") {
  const auto identity = GammaCurve::srgb();
  for (const int bits : {5, 6, 7, 8, 9, 10, 12, 15, 16}) {
    CAPTURE(bits);
    const int width = bits <= 8 ? 8 : 16;
    const auto white = to_codes(plain(1, 1, 1, 2, 0), encoding_for(identity, identity, bits),
                                depth_for(bits), false);
    CHECK(white.sample_bits == width);
    CHECK(white.values == std::vector<std::uint16_t>{static_cast<std::uint16_t>((1 << width) - 1),
                                                     static_cast<std::uint16_t>((1 << width) - 1),
                                                     0});
  }
  // 10 bits: ½ → floor(0.5·1023 + 0.5) = 512 = 0b1000000000, repeated: 0b1000000000100000.
  const auto half = to_codes(plain(1, 1, .5F, .5F, .5F), encoding_for(identity, identity, 10),
                             depth_for(10), false);
  CHECK(half.values[0] == 0b1000000000100000);
}

TEST_CASE("codes: negative, huge and undefined numbers stay in range", "[image][codes]") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  const Encoding e = encoding_for({}, GammaCurve::srgb());
  CHECK(to_codes(plain(1, 1, -1, inf, nan), e, {}, false).values ==
        std::vector<std::uint16_t>{0, 255, 0});
  CHECK(display_rgb(plain(1, 1, -1, inf, nan), 0, 0, e) == 0x00FF00);
}

TEST_CASE("codes: alpha divides the colour and is lifted to its brightness", "[image][codes]") {
  Encoding e = encoding_for({}, {});
  e.alpha = true;
  // Half-covered red: grey is below alpha, so alpha stays.
  CHECK(first_pixel(plain(1, 1, 0.5F, 0, 0, 0.5F), "png", e) ==
        std::vector<double>{255, 0, 0, 128});
  // A highlight over glass: grey(0.59, 0.59, 0.59) = 0.59 > 0.1 becomes the alpha.
  CHECK(first_pixel(plain(1, 1, 0.59F, 0.59F, 0.59F, 0.1F), "png", e) ==
        std::vector<double>{255, 255, 255, 150});
  CHECK(first_pixel(plain(1, 1, 0, 0, 0, 0), "png", e) == std::vector<double>{0, 0, 0, 0});
  // Without alpha the premultiplied colour is what stands over black.
  e.alpha = false;
  CHECK(first_pixel(plain(1, 1, 0.5F, 0, 0, 0.5F), "png", e) == std::vector<double>{128, 0, 0});
}

TEST_CASE("codes: greyscale weighs before it encodes, in 16 bits", "[image][codes]") {
  Encoding e = encoding_for({}, GammaCurve::srgb());
  e.greyscale = true;
  const auto stored = first_pixel(plain(1, 1, 0.2F, 0.5F, 0.8F), "png", e);
  REQUIRE(stored.size() == 1);
  const double y = 0.297 * 0.2 + 0.589 * 0.5 + 0.114 * 0.8;
  CHECK(stored[0] == Approx((1.055 * std::pow(y, 1 / 2.4) - 0.055) * 65535).margin(0.6));
}

TEST_CASE("codes: EXR and HDR hold linear light, in every gamma mode", "[image][codes]") {
  const Image image = plain(8, 1, 0.2F, 0.5F, 4.0F, 0.5F);
  Encoding e = encoding_for(GammaCurve::power(2.0F), GammaCurve::srgb());
  auto exr = first_pixel(image, "exr", e);
  REQUIRE(exr.size() == 3);
  CHECK(exr[0] == Approx(0.04).epsilon(1e-3));
  CHECK(exr[1] == Approx(0.25).epsilon(1e-3));
  CHECK(exr[2] == Approx(16.0).epsilon(1e-3));
  const auto hdr = first_pixel(image, "hdr", e);
  CHECK(hdr[1] == Approx(0.25).margin(16.0 / 256));
  CHECK(hdr[2] == Approx(16.0).epsilon(0.01));
  e.encode = false;  // the numbers count as sRGB-encoded
  exr = first_pixel(image, "exr", e);
  CHECK(exr[1] == Approx(0.214041).epsilon(1e-3));
  e.alpha = true;  // stays premultiplied
  exr = first_pixel(image, "exr", e);
  REQUIRE(exr.size() == 4);
  CHECK(exr[1] == Approx(0.214041).epsilon(1e-3));
  CHECK(exr[3] == Approx(0.5));
}

TEST_CASE("codes: the preview is sRGB whatever the file's curve is", "[image][codes]") {
  const Image image = plain(1, 1, 0.2F, 0.5F, 0.8F);
  CHECK(display_rgb(image, 0, 0, encoding_for({}, {})) == 0x7CBCE7);  // 124 188 231
  Encoding off;
  off.encode = false;
  CHECK(display_rgb(image, 0, 0, off) == 0x3380CC);
}

TEST_CASE("codes: looking up gives what computing does, for every curve", "[image][codes]") {
  const GammaCurve curves[] = {{}, GammaCurve::srgb(), GammaCurve::power(2.2F),
                               GammaCurve::power(0.45F)};
  const Encoding e = encoding_for(curves[GENERATE(0, 1, 2, 3)], curves[GENERATE(0, 1, 2, 3)]);
  constexpr int width = 20'000;
  Image large(width, 1);
  Image small(1, 1);
  for (int x = 0; x < width; ++x) {
    const float v = static_cast<float>(x - 50) / (width - 100.0F);
    large.at(x, 0)[0] = v;
    large.at(x, 0)[1] = v * v * v;
    large.at(x, 0)[2] = x == 9 ? std::numeric_limits<float>::quiet_NaN() : 1 / v;
  }
  const Codes looked_up = to_codes(large, e, {}, false);
  int wrong = 0;
  for (int x = 0; x < width; ++x) {
    std::copy_n(large.at(x, 0).begin(), 4, small.at(0, 0).begin());
    const Codes computed = to_codes(small, e, {}, false);
    if (!std::equal(computed.values.begin(), computed.values.end(), &looked_up.values[3 * x])) ++wrong;
  }
  CHECK(wrong == 0);
}

}  // namespace durer::image
