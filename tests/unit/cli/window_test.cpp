#include "cli/window.h"

#include "tests/unit/cli/read.h"

namespace durer::cli {
namespace {

std::optional<Window> window(std::vector<std::string> words) {
  words.insert(words.begin(), {"+W80", "+H40"});
  std::string problem;
  const auto w = window_of(test::accepted(words), problem);
  CHECK(w.has_value() == problem.empty());
  return w;
}

}  // namespace

TEST_CASE("window: the whole picture unless told otherwise", "[cli][window]") {
  const auto w = window({});
  REQUIRE(w);
  CHECK(w->first_column == 0);
  CHECK(w->end_column == 80);
  CHECK(w->first_row == 0);
  CHECK(w->end_row == 40);
}

TEST_CASE("window: pixel numbers count from 1 and include the last", "[cli][window]") {
  const auto w = window({"+SC2", "+EC3", "+SR1", "+ER40"});
  REQUIRE(w);
  CHECK(w->first_column == 1);
  CHECK(w->end_column == 3);
  CHECK(w->first_row == 0);
  CHECK(w->end_row == 40);
}

TEST_CASE("window: fractions of the size; an end of 1 is all of it", "[cli][window]") {
  const auto w = window({"+SR0.25", "+ER0.5", "+EC1"});
  REQUIRE(w);
  CHECK(w->first_row == 10);
  CHECK(w->end_row == 20);
  CHECK(w->end_column == 80);
  const auto odd = window({"+SC0.13", "+EC0.99"});  // 10.4 and 79.2
  REQUIRE(odd);
  CHECK(odd->first_column == 10);
  CHECK(odd->end_column == 79);
}

TEST_CASE("window: the columns that POV-Ray renders of 100", "[cli][window]") {
  struct Case {
    std::vector<std::string> words;
    int first, last;  // counted from 1
  };
  for (const Case& c : {Case{{"+SC0.29"}, 29, 100},
                        {{"+EC0.29"}, 1, 28},
                        {{"+EC0.57"}, 1, 56},
                        {{"+SC0.58"}, 58, 100},
                        {{"+EC1.5"}, 1, 1},
                        {{"+SC2.7"}, 2, 100},
                        {{"+SC0.999"}, 100, 100},
                        {{"+SC3.2", "+EC3.9"}, 3, 3},
                        {{"+SC1"}, 1, 100}}) {
    CAPTURE(c.words);
    std::vector<std::string> words = c.words;
    words.emplace_back("+W100");
    const auto w = window(words);
    REQUIRE(w);
    CHECK(w->first_column + 1 == c.first);
    CHECK(w->end_column == c.last);
  }
}

TEST_CASE("window: what was not rendered is opaque black", "[cli][window]") {
  image::Image image(3, 3);
  std::fill(image.pixels.begin(), image.pixels.end(), 0.5F);
  blacken_outside(image, {1, 2, 1, 3});
  CHECK(image.at(1, 1)[3] == 0.5F);
  CHECK(image.at(1, 2)[0] == 0.5F);
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {0, 1}, {2, 1}, {2, 2}}) {
    CHECK(image.at(x, y)[0] == 0);
    CHECK(image.at(x, y)[3] == 1);
  }
}

TEST_CASE("window: outside the picture or empty is an error", "[cli][window]") {
  CHECK_FALSE(window({"+SC81"}));
  CHECK_FALSE(window({"+EC81"}));
  CHECK_FALSE(window({"+SR5", "+ER4"}));
  CHECK_FALSE(window({"+ER0"}));
  test::refused({"+SC-1"});
}

}  // namespace durer::cli
