#include "quadrille/detector/printable.hpp"

#include "support/catch.hpp"

namespace quadrille {
namespace {

TEST_CASE("text is printed as it is", "[printable]") {
  for (const char* text : {"", "plain", "with space ~", "Grüße, 点群, 🤖", "C:\\x00"}) {
    CHECK(printable(text) == text);
  }
}

TEST_CASE("control characters and bytes that are no UTF-8 are printed as their numbers",
          "[printable][hostile]") {
  CHECK(printable(std::string("a\0b", 3)) == "a\\x00b");
  CHECK(printable("a\nb\r\t\x1b[31m\x7f") == "a\\x0ab\\x0d\\x09\\x1b[31m\\x7f");
  CHECK(printable("\xff\xfe") == "\\xff\\xfe");
  // Control characters of the second set, an overlong '/', a surrogate, and one past the last.
  CHECK(printable("\xc2\x85") == "\\xc2\\x85");
  CHECK(printable("\xc2\xa0") == "\xc2\xa0");
  CHECK(printable("\xc0\xaf \xe0\x80\xaf \xf0\x80\x80\xaf") ==
        "\\xc0\\xaf \\xe0\\x80\\xaf \\xf0\\x80\\x80\\xaf");
  CHECK(printable("\xed\xa0\x80") == "\\xed\\xa0\\x80");
  CHECK(printable("\xed\x9f\xbf") == "\xed\x9f\xbf");
  CHECK(printable("\xf4\x8f\xbf\xbf") == "\xf4\x8f\xbf\xbf");
  CHECK(printable("\xf4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");
  // Cut short, at the end and before another character.
  CHECK(printable("\xe7\x82") == "\\xe7\\x82");
  CHECK(printable("\xe7\x82z") == "\\xe7\\x82z");
}

TEST_CASE("long text is cut between characters and ends in an ellipsis", "[printable]") {
  CHECK(printable(std::string(80, 'a')) == std::string(80, 'a'));
  CHECK(printable(std::string(81, 'a')) == std::string(77, 'a').append("..."));
  CHECK(printable(std::string(3'000'000, 'a')) == std::string(77, 'a').append("..."));
  CHECK(printable("aaaaaaa\xff", 10) == "aaaaaaa...");
  CHECK(printable("aaa\xff\xff", 10) == "aaa\\xff...");
  CHECK(printable("äöüäöü", 10) == "äöü...");
  CHECK(printable("abcd", 3) == "...");
}

TEST_CASE("what was made printable stays as it is", "[printable]") {
  std::string bytes;
  for (int seed = 1; seed < 2000; ++seed) {
    bytes += static_cast<char>(seed * 2654435761u >> 13);
    const std::string once = printable(bytes);
    REQUIRE(once.size() <= 80);
    REQUIRE(printable(once) == once);
    if (bytes.size() == 60) bytes.clear();
  }
}

}  // namespace
}  // namespace quadrille
