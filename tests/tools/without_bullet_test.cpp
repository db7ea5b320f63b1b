#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;

TEST_CASE("without Bullet quadrille try says which package is missing", "[command][hostile]") {
  test::check_failure(test::run_quadrille("try --gripper franka a.ply"), "libbullet-dev");
}

TEST_CASE("without Bullet a study says how to do without trials", "[study][command][hostile]") {
  const test::TempFolder folder;
  const std::string study =
      "study grasps --scenes 1 --gripper franka --csv '" + folder.path("a.csv") + "'";
  test::check_failure(test::run_quadrille(study), "or give --try none");
  CHECK(test::run_quadrille(study + " --try none").code == 0);
}
