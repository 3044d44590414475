// Places in a picture and what is there (textures §12).
#include "tracer/patterns/image_sampler.h"

#include <cmath>
#include <random>

#include "tests/support/catch.h"
#include "tracer/patterns/remainder.h"

using namespace durer;
using namespace durer::tracer;

namespace {

// Four columns, two rows; red tells the column, green the row, blue counts pixels.
std::shared_ptr<Picture> small_picture() {
  auto picture = std::make_shared<Picture>();
  picture->width = 4;
  picture->height = 2;
  picture->channels = 3;
  for (std::uint16_t y = 0; y < 2; ++y) {
    for (std::uint16_t x = 0; x < 4; ++x) {
      picture->codes.insert(picture->codes.end(),
                            {static_cast<std::uint16_t>(51 * x), static_cast<std::uint16_t>(255 * y),
                             static_cast<std::uint16_t>(10 * (4 * y + x))});
    }
  }
  return picture;
}

scene::Image image_of(std::shared_ptr<const Picture> picture) {
  scene::Image image;
  image.picture = std::move(picture);
  return image;
}

std::shared_ptr<Picture> with_palette() {
  auto picture = std::make_shared<Picture>();
  picture->width = picture->height = 2;
  picture->codes = {0, 1, 2, 9};  // the last one is too large
  picture->palette = {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 51}};
  return picture;
}

}  // namespace

TEST_CASE("image sampler: rows go down, y goes up, copies follow each other",
          "[tracer][image_sampler]") {
  const ImageSampler sampler(image_of(small_picture()));
  const auto red_and_green = [&](double x, double y) {
    const auto at = sampler.locate({x, y, 0});
    REQUIRE(at);
    const Colour c = sampler.colour(*at);
    return dvec2(std::round(c.rgb.x * 5), c.rgb.y);
  };
  CHECK(red_and_green(0.1, 0.9) == dvec2(0, 0));
  CHECK(red_and_green(0.1, 0.1) == dvec2(0, 1));
  CHECK(red_and_green(0.9, 0.9) == dvec2(3, 0));
  CHECK(red_and_green(-0.1, 0.9) == dvec2(3, 0));
  CHECK(red_and_green(7.3, -4.4) == dvec2(1, 1 - 1));
  CHECK(sampler.opaque());
}

TEST_CASE("image sampler: nothing is beyond a picture that is shown once",
          "[tracer][image_sampler]") {
  scene::Image image = image_of(small_picture());
  image.once = true;
  const ImageSampler sampler(image);
  CHECK(sampler.locate({0.5, 0.5, 3}));
  CHECK_FALSE(sampler.locate({1.01, 0.5, 0}));
  CHECK_FALSE(sampler.locate({0.5, -0.01, 0}));
  CHECK_FALSE(sampler.opaque());
}

TEST_CASE("image sampler: interpolation keeps pixel centres and runs evenly between them",
          "[tracer][image_sampler]") {
  using Interpolation = scene::Image::Interpolation;
  scene::Image image = image_of(small_picture());
  image.interpolation = GENERATE(Interpolation::bilinear, Interpolation::bicubic);
  const ImageSampler sampler(image);
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 2; ++y) {
      const Colour c = sampler.colour({x + 0.5, y + 0.5});
      CHECK(c.rgb.x * 5 == Approx(x).margin(1e-6));
      CHECK(c.rgb.y == Approx(y).margin(1e-6));
      CHECK(c.rgb.z * 25.5 == Approx(4 * y + x).margin(1e-5));
    }
  }
  CHECK(sampler.colour({2.0, 0.5}).rgb.x * 5 == Approx(1.5));
  CHECK(sampler.colour({1.5, 1.0}).rgb.y == Approx(0.5));
  if (image.interpolation == Interpolation::bilinear) {
    CHECK(sampler.colour({1.75, 0.5}).rgb.x * 5 == Approx(1.25));
    // Across the edge the other side is next.
    CHECK(sampler.colour({0.0, 0.5}).rgb.x * 5 == Approx(1.5));
  }
}

TEST_CASE("image sampler: weights by distance favour the nearest pixel",
          "[tracer][image_sampler]") {
  scene::Image image = image_of(small_picture());
  image.interpolation = scene::Image::Interpolation::distance;
  const ImageSampler sampler(image);
  CHECK(sampler.colour({2.0, 1.0}).rgb.x * 5 == Approx(1.5));
  const double near = sampler.colour({1.6, 0.5001}).rgb.x * 5;
  CHECK(near > 1);
  CHECK(near < 1.1);
}

TEST_CASE("image sampler: palettes keep their transparency, changes replace it",
          "[tracer][image_sampler]") {
  scene::Image image = image_of(with_palette());
  const ImageSampler plain(image);
  CHECK(plain.colour({0.5, 0.5}).rgb == vec3(1, 0, 0));
  CHECK(plain.colour({0.5, 1.5}).transmit == Approx(0.8));
  CHECK(plain.colour({1.5, 1.5}).rgb == vec3(0, 0, 1));  // the last colour stands in
  CHECK_FALSE(plain.opaque());
  image.filter = {{1, 0.25F}, {77, 1.0F}};
  image.transmit_all = 0.5F;
  const ImageSampler changed(image);
  CHECK(changed.colour({1.5, 0.5}).filter == 0.25F);
  CHECK(changed.colour({0.5, 0.5}).filter == 0);
  CHECK(changed.colour({0.5, 1.5}).transmit == 0.5F);
  image.use_index = true;
  CHECK(ImageSampler(image).height({0.5, 1.5}) == 2);
  CHECK(changed.material({1.5, 0.5}) == 1);
}

TEST_CASE("image sampler: real samples and alpha", "[tracer][image_sampler]") {
  auto picture = std::make_shared<Picture>();
  picture->width = picture->height = 1;
  picture->bits = 32;
  picture->channels = 4;
  picture->samples = {2.0F, 0.5F, 0.0F, 0.25F};
  scene::Image image = image_of(picture);
  Colour c = ImageSampler(image).colour({0.3, 0.3});
  CHECK(c.rgb == vec3(2, 0.5, 0));
  CHECK(c.transmit == 0.75F);
  image.premultiplied = true;
  image.interpolation = scene::Image::Interpolation::bicubic;  // of a single pixel
  c = ImageSampler(image).colour({0.3, 0.3});
  CHECK(c.rgb.x == Approx(8));
  image.use_alpha = true;
  CHECK(ImageSampler(image).value({0.3, 0.3}) == Approx(0.75));
}

TEST_CASE("remainder: as std::fmod, to the last bit", "[tracer][image_sampler]") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> size(-30, 45);
  const auto same = [](double a, double b) {
    return (a == b && std::signbit(a) == std::signbit(b)) || (std::isnan(a) && std::isnan(b));
  };
  int wrong = 0;
  for (int i = 0; i < 200'000; ++i) {
    const double x = std::ldexp(std::uniform_real_distribution<double>(-1, 1)(random),
                                static_cast<int>(size(random)));
    const double m = i % 3 == 0 ? 1024 : static_cast<float>(std::exp2(size(random) / 4));
    const double whole = m * std::round(x / m);
    for (const double at : {x, whole, std::nextafter(whole, x)}) {
      wrong += same(remainder_of_single(at, m), std::fmod(at, m)) ? 0 : 1;
      wrong += same(tracer::remainder(at, 1.00001), std::fmod(at, 1.00001)) ? 0 : 1;
    }
  }
  CHECK(wrong == 0);
  CHECK(same(remainder_of_single(-0.0, 3), -0.0));
  CHECK(std::isnan(remainder_of_single(std::nan(""), 3)));
}
