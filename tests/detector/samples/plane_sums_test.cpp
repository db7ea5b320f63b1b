#include "samples/plane_sums.hpp"

#include "base/random.hpp"
#include "support/catch.hpp"

using namespace quadrille;

TEST_CASE("the plane of points on a plane is that plane, wherever it lies", "[plane_sums]") {
  const Eigen::Vector3d n = Eigen::Vector3d(1, 2, -2) / 3.0, e1 = n.unitOrthogonal(),
                        e2 = n.cross(e1);
  RandomStream random(1, 0);
  for (const double d : {-0.5, 0.0, 3.0}) {
    PlaneSums sums;
    for (int k = 0; k < 50; ++k) sums.add(random.uniform() * e1 + random.uniform() * e2 - d * n);
    Eigen::Vector4d plane = sums.plane();
    if (plane.head<3>().dot(n) < 0) plane = -plane;
    CHECK((plane.head<3>() - n).norm() < 1e-7);
    CHECK(plane[3] == Approx(d).margin(1e-7));
    CHECK(sums.squares().isApprox(sums.squares().transpose()));
  }
}
