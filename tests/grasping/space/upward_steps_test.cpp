#include "space/upward_steps.hpp"

#include <algorithm>
#include <cmath>

#include "support/catch.hpp"

using namespace quadrille;
using Eigen::Vector3d;
using Eigen::Vector3i;

TEST_CASE("steps upwards follow the straight line within half a voxel", "[space]") {
  const Vector3i size(40, 50, 60);
  for (const Vector3d& direction :
       {Vector3d(0, 0, 1), Vector3d(0, -1, 0), Vector3d(0.3, 0.2, 1), Vector3d(-1, 0.45, 0.6),
        Vector3d(0.7, 0.71, -0.72), Vector3d(0.01, -3.0, 2.9)}) {
    const Vector3d up = direction.normalized();
    const UpwardSteps steps(up, size);
    CAPTURE(up.transpose());
    REQUIRE(steps.known());
    const int axis = steps.axis();
    CHECK(std::abs(up[axis]) == up.cwiseAbs().maxCoeff());
    REQUIRE(steps.layers() == size[axis]);
    Vector3i climbed = Vector3i::Zero();
    double worst = 0.0;
    for (int n = 1; n < steps.layers(); ++n) {
      const Vector3i step = steps.step(n);
      // Each step leads into the next layer.
      CHECK(step[axis] == steps.place(n) - steps.place(n - 1));
      CHECK(steps.number(steps.place(n)) == n);
      climbed += step;
      const Vector3d straight = up * (n / std::abs(up[axis]));
      worst = std::max(worst, (climbed.cast<double>() - straight).cwiseAbs().maxCoeff());
    }
    CHECK(worst <= 0.5 + 1e-9);
    // The layers are counted from below.
    CHECK((steps.place(1) > steps.place(0)) == (up[axis] > 0.0));
  }
}

TEST_CASE("without a direction nothing is above anything", "[space][degenerate]") {
  CHECK_FALSE(UpwardSteps(Vector3d::Zero(), Vector3i(3, 4, 5)).known());
}
