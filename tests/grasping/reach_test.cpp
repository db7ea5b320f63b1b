#include "quadrille/grasping/reach.hpp"

#include "support/catch.hpp"

using namespace quadrille;

TEST_CASE("an arm reaches the shell between two spheres about its base", "[reach]") {
  const Reach reach{{1.0, 2.0, 3.0}, 0.5, 2.0};
  CHECK(reach.contains({1.0, 2.0, 3.5}));
  CHECK(reach.contains({3.0, 2.0, 3.0}));
  CHECK(reach.contains({1.0, 3.0, 4.0}));
  CHECK_FALSE(reach.contains({1.0, 2.0, 3.0}));
  CHECK_FALSE(reach.contains({1.0, 2.49, 3.0}));
  CHECK_FALSE(reach.contains({1.0, 2.0, 5.01}));
  CHECK(Reach().contains({1e6, 0.0, 0.0}));
}
