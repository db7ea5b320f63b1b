#include "boxes/outline.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/depth_camera.hpp"
#include "walked_edge.hpp"

namespace quadrille {
namespace {

TEST_CASE("what a rounded edge hides is what a walk along its arc does not see", "[boxes]") {
  const PointCloud cloud = test::render({test::sphere(test::translation(0, 0, 1), 0.2)}, {});
  const DirectionIndex sight(cloud);
  REQUIRE(sight.single());
  for (const double tilt : {0.1, 0.5, 0.9, 1.3, 1.5}) {
    for (const double sigma : {0.0005, 0.001, 0.003}) {
      for (const double radius : {0.001, 0.004, 0.008, 0.015}) {
        Face face;
        face.n_C = Eigen::Vector3d(std::sin(tilt), 0.0, -std::cos(tilt));
        face.middle_C = Eigen::Vector3d(0.0, 0.0, 0.7);
        face.sigma = sigma;
        for (const double side : {-1.0, 1.0}) {
          const Eigen::Vector3d out_C = side * Eigen::Vector3d(std::cos(tilt), 0, std::sin(tilt));
          const Outline outline{&face, 1, 1, out_C, {}};
          INFO("tilt " << tilt << ", noise " << sigma << ", radius " << radius << ", side "
                       << side);
          CHECK(outline.hidden(radius, sight) ==
                Approx(radius - test::shown_by_walking(outline, radius)).margin(1e-5));
        }
      }
    }
  }
}

}  // namespace
}  // namespace quadrille
