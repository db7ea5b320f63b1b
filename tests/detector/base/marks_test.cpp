#include "base/marks.hpp"

#include "support/catch.hpp"

using namespace quadrille;

TEST_CASE("a mark is new once until all are cleared, however often that is", "[base]") {
  Marks marks(3);
  for (int round = 0; round < 70000; ++round) {
    const int i = round % 3;
    if (!marks.add(i) || marks.add(i)) FAIL("round " << round);
    marks.clear();
  }
  CHECK(marks.add(0));
  CHECK(marks.add(1));
  CHECK_FALSE(marks.add(0));
}
