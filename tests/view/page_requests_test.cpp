#include "view/page_requests.hpp"

#include "support/catch.hpp"

using quadrille::view::query_value;

TEST_CASE("values in an address are found by name and decoded as browsers write them",
          "[view][requests]") {
  const char* const query = "gripper=my+hand%C3%A9%26&unknown=free&empty=&flag&gripper=other";
  CHECK(query_value(query, "gripper") == "my hand\xc3\xa9&");
  CHECK(query_value(query, "unknown") == "free");
  CHECK(query_value(query, "empty").empty());
  CHECK(query_value(query, "flag").empty());
  CHECK(query_value(query, "grip").empty());
  CHECK(query_value("", "gripper").empty());
}

TEST_CASE("a percent sign without two digits stays", "[view][requests][hostile]") {
  for (const char* text : {"%", "%4", "%4g", "%-1", "%%", "x%zz"}) {
    CAPTURE(text);
    CHECK(query_value(std::string("a=") + text, "a") == text);
  }
  CHECK(query_value("a=%00", "a") == std::string(1, '\0'));
  CHECK(query_value("&&=&a=1", "a") == "1");
}
