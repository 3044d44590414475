#include "base/suggest.h"

#include <array>

#include "tests/support/catch.h"

using durer::closest;

TEST_CASE("suggest: finds the nearest word within two edits", "[base][suggest]") {
  constexpr std::array<std::string_view, 4> words = {"diffuse", "ambient", "declare", "phong"};
  CHECK(closest("difuse", words) == "diffuse");
  CHECK(closest("delcare", words) == "declare");  // swapped neighbours are one edit
  CHECK(closest("ambeint", words) == "ambient");
  CHECK(closest("Phong", words) == "phong");
  CHECK(closest("diffuse", words) == "diffuse");
}

TEST_CASE("suggest: stays silent when nothing is near", "[base][suggest]") {
  constexpr std::array<std::string_view, 3> words = {"diffuse", "ior", "up"};
  CHECK_FALSE(closest("reflection", words).has_value());
  CHECK_FALSE(closest("x", words).has_value());
  CHECK_FALSE(closest("abc", words).has_value());
  CHECK_FALSE(closest("difuse", {}).has_value());
}
