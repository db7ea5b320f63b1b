#include "poses/timed_values.hpp"

#include "support/catch.hpp"

namespace quadrille {

TEST_CASE("the value nearest in time is kept, unless there are too many or they are too large",
          "[pose]") {
  TimedValues<int> values(3, 100);
  CHECK(values.nearest(0) == nullptr);
  for (int n = 1; n <= 4; ++n) values.add(10 * n, 30, n);
  CHECK(*values.nearest(1) == 2);
  CHECK(*values.nearest(29) == 3);
  CHECK(*values.nearest(0) == 4);
  values.add(50, 50, 5);
  CHECK(*values.nearest(1) == 4);
  values.add(60, 1000, 6);
  CHECK(*values.nearest(1) == 6);
  // It gave its memory back.
  values.add(70, 40, 7);
  values.add(80, 40, 8);
  CHECK(*values.nearest(1) == 7);
}

TEST_CASE("a clock that is set back, and a value that always holds, end what was before",
          "[pose]") {
  TimedValues<int> values(8, 100);
  values.add(10, 60, 1);
  values.add(5, 60, 2);
  CHECK(*values.nearest(10) == 2);
  values.add(6, 30, 3);
  CHECK(*values.nearest(5) == 2);
  values.add(0, 60, 4);
  CHECK(*values.nearest(6) == 4);
  values.add(7, 60, 5);
  CHECK(*values.nearest(0) == 5);
  CHECK(*values.nearest(1) == 5);
}

}  // namespace quadrille
