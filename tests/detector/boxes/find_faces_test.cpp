#include "boxes/find_faces.hpp"

#include <vector>

#include "support/catch.hpp"
#include "support/depth_camera.hpp"

namespace quadrille {
namespace {

TEST_CASE("a face does not grow over a step onto its neighbour", "[boxes][faces]") {
  constexpr double kSigma = 0.0005, kStep = 0.0035;
  RandomStream random(3, 0);
  PointCloud cloud;
  for (int j = -60; j < 60; ++j) {
    for (int i = -60; i < 60; ++i) {
      const double z = 0.6 + (i < 0 ? 0.0 : kStep) + kSigma * test::gaussian(random);
      cloud.points.emplace_back(Eigen::Vector3f(0.002f * i, 0.002f * j, 1.0f) *
                                static_cast<float>(z));
    }
  }
  const DirectionIndex sight(cloud);
  Eigen::Matrix3d R_CL;
  R_CL << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  FacePatch patch;
  patch.X_CP.linear() = R_CL;
  patch.X_CP.translation() = Eigen::Vector3d(-0.03, 0.0, 0.6);
  patch.half = {0.02, 0.03};
  const auto draft = draft_face({patch, kSigma}, sight);
  REQUIRE(draft);
  const auto face = finished_face(*draft, sight);
  REQUIRE(face);
  CHECK(face->reach(-Eigen::Vector3d::UnitX()).second > 0.065);
  CHECK(face->reach(Eigen::Vector3d::UnitX()).second < 0.004);
}

}  // namespace
}  // namespace quadrille
