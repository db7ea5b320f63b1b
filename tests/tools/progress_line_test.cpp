#include "cli/progress_line.hpp"

#include "support/catch.hpp"

using namespace quadrille;

TEST_CASE("the time left is told in the unit that suits it", "[command]") {
  CHECK(describe_duration(0.2) == "1 s");
  CHECK(describe_duration(99) == "99 s");
  CHECK(describe_duration(100) == "2 min");
  CHECK(describe_duration(45 * 60) == "45 min");
  CHECK(describe_duration(100 * 60) == "1 h 40 min");
  CHECK(describe_duration(11 * 3600 + 4 * 60 + 10) == "11 h 04 min");
}
