#include "cli/progress.h"

#include "tests/support/catch.h"

namespace durer::cli {
namespace {

/// What a ProgressLine writes for a series of moments.
std::string written(int columns, const std::vector<tracer::Progress>& moments) {
  std::FILE* file = std::tmpfile();
  REQUIRE(file != nullptr);
  ProgressLine line(file, columns);
  for (const auto& p : moments) line.show(p);
  line.clear();
  std::string text(4096, '\0');
  std::rewind(file);
  text.resize(std::fread(text.data(), 1, text.size(), file));
  std::fclose(file);
  return text;
}

}  // namespace

TEST_CASE("progress: counts and times read well", "[cli][progress]") {
  CHECK(count_text(950) == "950");
  CHECK(count_text(12000) == "12.0 k");
  CHECK(count_text(2.414e6) == "2.41 M");
  CHECK(count_text(3.5e11) == "350 G");
  CHECK(time_text(0.0123) == "12 ms");
  CHECK(time_text(0.4567) == "457 ms");
  CHECK(time_text(7.26) == "7.3 s");
  CHECK(time_text(65) == "1:05");
  CHECK(time_text(7384) == "2:03:04");
}

TEST_CASE("progress: percent, speed and time left", "[cli][progress]") {
  CHECK(progress_text({25, 100, 5'000'000, 5}) == "25 %, 1.00 M rays/s, 0:15 left");
  CHECK(progress_text({100, 100, 5'000'000, 5}) == "100 %, 1.00 M rays/s");
  CHECK(progress_text({0, 100, 0, 0}) == "0 %");
  CHECK(progress_text({0, 0, 0, 0}) == "100 %");
}

TEST_CASE("progress: the bar fits the terminal", "[cli][progress]") {
  const tracer::Progress half{50, 100, 1'000'000, 1};
  CHECK(progress_bar(half, 45) == "[=====>    ] 50 %, 1.00 M rays/s, 1.0 s left");
  for (const int columns : {0, 1, 10, 20, 40, 80, 300}) {
    CHECK(static_cast<int>(progress_bar(half, columns).size()) <= std::max(columns - 1, 0));
  }
}

TEST_CASE("progress: one changing line on a terminal, few plain lines elsewhere",
          "[cli][progress]") {
  const std::vector<tracer::Progress> moments = {{1, 100, 100, 0.05},
                                                 {10, 100, 1000, 0.2},
                                                 {20, 100, 2000, 0.25},
                                                 {50, 100, 5000, 12},
                                                 {60, 100, 6000, 13}};
  const std::string terminal = written(60, moments);
  CHECK(terminal.find("10 %") != std::string::npos);
  CHECK(terminal.find("20 %") == std::string::npos);  // too soon after the last
  CHECK(terminal.find('\n') == std::string::npos);
  CHECK(terminal.ends_with("\r\x1b[K"));
  const std::string plain = written(0, moments);
  CHECK(plain == "50 %, 417 rays/s, 0:12 left\n");
}

}  // namespace durer::cli
