#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;

TEST_CASE("without Bullet quadrille try says which package is missing", "[command][hostile]") {
  test::check_failure(test::run_quadrille("try --gripper franka a.ply"), "libbullet-dev");
}
