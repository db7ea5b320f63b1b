#include "lab/physics/bodies.hpp"
#include "lab/physics/trial.hpp"
#include "support/catch.hpp"

using namespace quadrille;

TEST_CASE("without Bullet a trial says which option and package are missing", "[physics][trial]") {
  const std::string missing = physics::missing_physics();
  CHECK(missing.find("libbullet-dev") != std::string::npos);
  CHECK(missing.find("QUADRILLE_WITH_BULLET") != std::string::npos);
  CHECK_THROWS_AS(
      physics::try_grasp(test::ball(0.02), Gripper{}, Grasp{}, Eigen::Isometry3d::Identity(), {}),
      std::runtime_error);
}
