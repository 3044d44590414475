#include "cli/terminal.h"

#include "tests/support/catch.h"

namespace durer::cli {
namespace {

image::Image picture(int width, int height, const std::vector<std::array<float, 3>>& colours) {
  image::Image image(width, height);
  for (std::size_t i = 0; i < colours.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) image.pixels[i * 4 + k] = colours[i][k];
    image.pixels[i * 4 + 3] = 1;
  }
  return image;
}

constexpr std::array<float, 3> red = {1, 0, 0};
constexpr std::array<float, 3> green = {0, 1, 0};
constexpr std::array<float, 3> blue = {0, 0, 1};
constexpr std::array<float, 3> white = {1, 1, 1};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("terminal: two rows of pixels make one row of half blocks", "[cli][terminal]") {
  const auto image = picture(2, 2, {red, green, blue, white});
  CHECK(half_blocks(image, {}, 80) ==
        "\x1b[38;2;255;0;0m\x1b[48;2;0;0;255m▀"
        "\x1b[38;2;0;255;0m\x1b[48;2;255;255;255m▀\x1b[0m\n");
}

TEST_CASE("terminal: an odd last row leaves the lower half to the terminal", "[cli][terminal]") {
  CHECK(half_blocks(picture(1, 1, {red}), {}, 80) == "\x1b[38;2;255;0;0m▀\x1b[0m\n");
}

TEST_CASE("terminal: equal neighbours share their colours", "[cli][terminal]") {
  const auto text = half_blocks(picture(3, 1, {red, red, green}), {}, 80);
  CHECK(count(text, "\x1b[38") == 2);
  CHECK(count(text, "▀") == 3);
}

TEST_CASE("terminal: pictures shrink to the columns by averaging, and never grow",
          "[cli][terminal]") {
  const auto small = shrunk(picture(4, 2, {red, red, blue, blue, white, white, blue, green}), 2);
  REQUIRE(small.width == 2);
  REQUIRE(small.height == 1);
  CHECK(small.at(0, 0)[0] == 1);
  CHECK(small.at(0, 0)[1] == 0.5F);
  CHECK(small.at(1, 0)[2] == 0.75F);
  CHECK(shrunk(picture(1, 1, {red}), 80).width == 1);
  const auto wide = shrunk(image::Image(1000, 1), 80);
  CHECK(wide.width == 80);
  CHECK(wide.height == 1);
}

TEST_CASE("terminal: without a terminal there are 80 columns of half blocks", "[cli][terminal]") {
  const Terminal none = terminal_of(-1);
  CHECK(none.columns == 80);
  CHECK(none.graphics == TerminalGraphics::half_blocks);
  CHECK(terminal_columns(-1) == 0);
  const auto text = draw(image::Image(400, 100), {}, none);
  CHECK(count(text, "▀") == 80 * 10);
}

TEST_CASE("terminal: sixel is listed in the device attributes", "[cli][terminal]") {
  CHECK(answers_sixel("\x1b[?62;4;22c"));
  CHECK(answers_sixel("\x1b[?4c"));
  CHECK_FALSE(answers_sixel("\x1b[?62;14;40c"));
  CHECK_FALSE(answers_sixel("\x1b[?62;22c"));
  CHECK_FALSE(answers_sixel("\x1b[?62;4"));
  CHECK_FALSE(answers_sixel(""));
}

TEST_CASE("terminal: kitty gets a PNG in chunks", "[cli][terminal]") {
  const auto small = kitty(picture(1, 1, {red}), {}, 80);
  CHECK(small.starts_with("\x1b_Gf=100,a=T,q=2,m=0;iVBORw0KGgo"));  // base64 of the PNG signature
  CHECK(small.ends_with("\x1b\\\n"));
  image::Image noise(200, 200);
  std::uint32_t state = 1;
  for (float& v : noise.pixels) {
    state = state * 1664525 + 1013904223;
    v = static_cast<float>(state >> 8) / 16777216.0F;
  }
  const auto large = kitty(noise, {}, 80);
  CHECK(large.starts_with("\x1b_Gf=100,a=T,q=2,m=1;"));
  CHECK(count(large, "\x1b_Gm=1;") > 3);
  CHECK(count(large, "m=0;") == 1);
}

TEST_CASE("terminal: sixels hold six rows, runs packed", "[cli][terminal]") {
  image::Image image(10, 7);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = 1;
  const auto text = sixel(image, {}, 80);
  CHECK(text.starts_with("\x1bP0;1q\"1;1;10;7#0;2;0;0;0"));
  CHECK(text.find("#215;2;100;100;100") != std::string::npos);
  CHECK(text.find("#215!10~$-#215!10@$-") != std::string::npos);  // six rows, then one
  CHECK(text.ends_with("\x1b\\\n"));
}

}  // namespace durer::cli
