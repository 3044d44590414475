// Numbers from the oracle (language §9.6).
#include "cli/animation.h"

#include "cli/output_name.h"
#include "tests/unit/cli/read.h"

namespace durer::cli {
namespace {

std::optional<Animation> animation(const std::vector<std::string>& words) {
  return animation_of(test::accepted(words));
}

std::vector<int> frames(const std::vector<std::string>& words) {
  const auto a = animation(words);
  std::vector<int> numbers;
  for (int i = 0; a && i < a->count(); ++i) numbers.push_back(a->from + i * a->step);
  return numbers;
}

}  // namespace

TEST_CASE("animation: (0, 0) and (1, 1) are still pictures", "[cli][animation]") {
  CHECK_FALSE(animation({}));
  CHECK_FALSE(animation({"+KFI0"}));
  CHECK_FALSE(animation({"+KFI1", "+KFF1", "+KC"}));
  CHECK_FALSE(animation({"+KI.5", "+KF2", "+SF2", "+KC"}));
  CHECK(animation({"+KFI0", "+KFF1"}));
  CHECK(animation({"+KFI1"}));
  CHECK(animation({"+KFF1"}));
}

TEST_CASE("animation: the frames that POV-Ray renders", "[cli][animation]") {
  using List = std::vector<int>;
  CHECK(frames({"+KFF3"}) == List{1, 2, 3});
  CHECK(frames({"+KFI0", "+KFF2"}) == List{0, 1, 2});
  CHECK(frames({"+KFI2", "+KFF2"}) == List{2});
  CHECK(frames({"+KFI5", "+KFF3"}) == List{5});
  CHECK(frames({"+KFI3"}) == List{3});
  CHECK(frames({"+KFI-2", "+KFF2"}) == List{0, 1, 2});
  CHECK(frames({"+KFI-3"}) == List{0, 1});
  CHECK(frames({"+KFF-3"}) == List{1});
  CHECK(frames({"+KFF0", "+KFI2"}) == List{2});
  CHECK(frames({"+KFF12", "+SF0.5", "+EF0.6"}) == List{6, 7});
  CHECK(frames({"+KFI3", "+KFF12", "+SF0.5", "+EF0.6"}) == List{5, 6});
  CHECK(frames({"+KFF10", "+STP3"}) == List{1, 4, 7, 10});
  CHECK(frames({"+KFF3", "+STP0"}) == List{1, 2, 3});
  CHECK(frames({"+KFF3", "+STP-1"}) == List{1, 2, 3});
  CHECK(frames({"+KFF3", "+SF5"}) == List{5});
  CHECK(frames({"+KFF3", "+EF7"}) == List{1, 2, 3, 4, 5, 6, 7});
  CHECK(frames({"+KFF3", "+SF3", "+EF2"}) == List{3});
  CHECK(frames({"+KFF3", "+SF0.99", "+EF0.99"}) == List{2});
  CHECK(frames({"+KFF3", "+SF1", "+EF1.0"}) == List{1});
  CHECK(frames({"+KFF3", "+SF0", "+EF0"}) == List{1});
  CHECK(frames({"+KFF3", "+KC", "+EF4"}) == List{1, 2, 3, 4});
  CHECK(frames({"+KFF10", "+SF0.25", "+EF0.75", "+KC"}) == List{2, 3, 4, 5, 6, 7, 8});
}

TEST_CASE("animation: the clock is single precision, the rest has six digits", "[cli][animation]") {
  const auto thirds = animation({"+KFF4"});
  REQUIRE(thirds);
  CHECK(thirds->clock(1) == 0);
  CHECK(thirds->clock(2) == Approx(0.3333333433).epsilon(1e-9));
  CHECK(thirds->clock(4) == 1);
  CHECK(thirds->values(2).clock_delta == 0.333333);
  const auto cyclic = animation({"+KFF3", "+KC", "+KI1", "+KF2.123456789"});
  REQUIRE(cyclic);
  CHECK(cyclic->values(2).last == 4);
  CHECK(cyclic->values(2).clock_delta == 0.374486);
  CHECK(cyclic->values(2).last_clock == 2.12346);
  CHECK(cyclic->clock(2) == Approx(1.3744856119).epsilon(1e-9));
  const auto long_one = animation({"+KFI1234567", "+KFF1234568"});
  REQUIRE(long_one);
  CHECK(long_one->values(1234567).number == 1234570);
}

TEST_CASE("animation: a single frame has the first clock", "[cli][animation]") {
  const auto one = animation({"+KFI5", "+KFF3", "+KI2", "+KF4"});
  REQUIRE(one);
  CHECK(one->clock(5) == 2);  // POV-Ray divides by zero
  CHECK(one->values(5).clock_delta == 0);
}

TEST_CASE("animation: file names carry the number", "[cli][animation][output]") {
  const auto name = [](std::vector<std::string> words, FrameNumber frame) {
    words.emplace_back("+Ia.pov");
    return output_of(test::accepted(words), frame).path;
  };
  CHECK(name({}, {1, 2}) == "a01.png");
  CHECK(name({"+Oanim"}, {7, 3}) == "anim007.png");
  CHECK(name({"+Oout.jpg"}, {7, 1}) == "out7.jpg");
  CHECK(name({"+Oout.jpg", "+FN"}, {7, 1}) == "out.jpg7.png");
  CHECK(name({"+Od/"}, {12, 1}) == "d/a12.png");
  CHECK(name({"+O-"}, {12, 1}) == "-");
  CHECK(animation({"+KFI9", "+KFF9", "+KC"})->digits == 2);
  CHECK(animation({"+KFF9", "+EF12"})->digits == 1);
}

}  // namespace durer::cli
