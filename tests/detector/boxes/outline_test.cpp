#include "boxes/outline.hpp"

#include <algorithm>
#include <cmath>

#include "support/catch.hpp"
#include "support/depth_camera.hpp"

namespace quadrille {
namespace {

/// How far a rounded edge seems to reach beyond the beginning of its rounding, by walking along its
/// arc: as long as it is within the face's tolerance and its normal is turned to the eye.
double shown_by_walking(const Outline& outline, double radius) {
  const Face& face = *outline.face;
  const Eigen::Vector3d to_eye_C = -face.middle_C.normalized();
  double shown = 0.0;
  for (double angle = 0.0; angle < 0.5 * M_PI; angle += 1e-4) {
    const Eigen::Vector3d n_C = std::cos(angle) * face.n_C + std::sin(angle) * outline.out_C;
    const double depth = radius * (1.0 - std::cos(angle));
    if (depth > face.tolerance() || n_C.dot(to_eye_C) < 0.0) break;
    shown = radius * std::sin(angle);
  }
  return shown;
}

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
                Approx(radius - shown_by_walking(outline, radius)).margin(1e-5));
        }
      }
    }
  }
}

}  // namespace
}  // namespace quadrille
