#include "cli/values.h"

#include "tests/support/catch.h"

namespace durer::cli {

TEST_CASE("values: switches of all spellings are read", "[cli][values]") {
  for (const char* yes : {"on", "ON", "true", "Yes", "1"}) CHECK(parse_bool(yes) == true);
  for (const char* no : {"off", "False", "NO", "0"}) CHECK(parse_bool(no) == false);
  for (const char* neither : {"", "maybe", "2", "on "}) CHECK_FALSE(parse_bool(neither));
}

TEST_CASE("values: numbers must be whole words", "[cli][values]") {
  CHECK(parse_int("800") == 800);
  CHECK(parse_int("-3") == -3);
  CHECK(parse_int("+3") == 3);
  for (const char* bad : {"", "x", "3x", "3.5", "1e2", " 3", "99999999999"}) {
    CAPTURE(bad);
    CHECK_FALSE(parse_int(bad));
  }
  CHECK(parse_number(".5") == 0.5);
  CHECK(parse_number("1e3") == 1000);
  CHECK(parse_number("0x10") == 16);
  CHECK(parse_number("-2") == -2);
  for (const char* bad : {"", "x", "0.3x", " 3", "inf", "nan", "1+1"}) {
    CAPTURE(bad);
    CHECK_FALSE(parse_number(bad));
  }
}

TEST_CASE("values: sizes and curves", "[cli][values]") {
  CHECK(parse_size("800x600")->width == 800);
  CHECK(parse_size("800X600")->height == 600);
  CHECK_FALSE(parse_size("800"));
  CHECK_FALSE(parse_size("800x"));
  CHECK(parse_gamma("sRGB") == GammaCurve::srgb());
  CHECK(parse_gamma("1.0") == GammaCurve());
  CHECK(parse_gamma("1.8") == GammaCurve::power(1.8F));
  CHECK_FALSE(parse_gamma("0"));
  CHECK_FALSE(parse_gamma("linear"));
}

TEST_CASE("values: quotes and blanks around a value go", "[cli][values]") {
  CHECK(unquote("\"a b\"") == "a b");
  CHECK(unquote("'a'") == "a");
  CHECK(unquote("\"a'") == "\"a'");
  CHECK(unquote("\"") == "\"");
  CHECK(trim(" \ta b\r ") == "a b");
  CHECK(trim("  ").empty());
}

}  // namespace durer::cli
