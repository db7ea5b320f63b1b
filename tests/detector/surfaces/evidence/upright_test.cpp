#include "surfaces/evidence/upright.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/depth_camera.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("what stands is upright, what lies is not, and a ball is either",
          "[evidence][uprightness]") {
  const CanonicalForm pipe = canonical_form(Quadric(diagonal(1, 1, 0, -1)));
  CHECK(uprightness(pipe, Eigen::Vector3d::UnitZ()) == Approx(1.0));
  CHECK(uprightness(pipe, -Eigen::Vector3d::UnitZ()) == Approx(1.0));
  CHECK(uprightness(pipe, Eigen::Vector3d::UnitY()) == Approx(0.0).margin(1e-12));
  CHECK(uprightness(pipe, Eigen::Vector3d(0, std::sin(1.0), std::cos(1.0))) ==
        Approx(std::cos(1.0)));
  CHECK(uprightness(pipe, std::nullopt) == 1.0);
  const CanonicalForm ball = canonical_form(Quadric(diagonal(1, 1, 1, -1)));
  CHECK(uprightness(ball, Eigen::Vector3d::UnitY()) == 1.0);
}
