#include "lab/bench/instructions.hpp"

#include <stdexcept>

#include "support/catch.hpp"

namespace quadrille::bench {
namespace {

TEST_CASE("each part has the total of its profile, and equal parts add up", "[bench][speed]") {
  const std::string profiles =
      "part: 1\nsummary: 9\nfn=(1) totals: 8\ntotals: 100\n\ntotals: 20\ntotals: 3\n"
      "totals: 4000000000\ntotals: 7";
  const Instructions counts = parse_counts("reading\nsearch\naggregate\nsearch\n", profiles);
  REQUIRE(counts.size() == 3);
  CHECK(counts[1].first == "search");
  CHECK(instructions_of(counts, "reading") == 100);
  CHECK(instructions_of(counts, "search") == 4000000020);
  CHECK(instructions_of(counts, "aggregate") == 3);
  CHECK(instructions_of(counts, "boxes") == 0);
}

TEST_CASE("profiles that do not fit the parts are refused", "[bench][speed]") {
  for (const char* profiles : {"", "totals: 1\n", "totals: 1\ntotals: 2\ntotals: 3\n"}) {
    CHECK_THROWS_AS(parse_counts("cells\n", profiles), std::runtime_error);
  }
  CHECK_THROWS_AS(parse_counts("", "totals: 1\n"), std::runtime_error);
}

TEST_CASE("without its program nothing is counted", "[bench][speed]") {
  CHECK(why_not_counted("/nowhere").find("/nowhere/quadrille-counted is not built") !=
        std::string::npos);
}

}  // namespace
}  // namespace quadrille::bench
