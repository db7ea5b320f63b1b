#include "boxes/rounded_box.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/random.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

/// The nearest distance from a point to the small box, by trying the points of a fine grid.
double distance_to_grid(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& p) {
  double least = std::numeric_limits<double>::infinity();
  constexpr int kSteps = 60;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      for (int k = 0; k <= kSteps; ++k) {
        const Eigen::Vector3d share = Eigen::Vector3d(i, j, k) / kSteps;
        const Eigen::Vector3d at = box.min() + share.cwiseProduct(box.sizes());
        least = std::min(least, (at - p).norm());
      }
    }
  }
  return least;
}

TEST_CASE("the distance from a rounded box is that from the smaller box within, less the radius",
          "[boxes]") {
  const RoundedBox box{{Eigen::Vector3d(-0.02, 0.01, 0.1), Eigen::Vector3d(0.06, 0.05, 0.16)},
                       0.008};
  const Eigen::Vector3d inset = Eigen::Vector3d::Constant(box.radius);
  const Eigen::AlignedBox3d small(box.box_A.min() + inset, box.box_A.max() - inset);
  RandomStream random(1, 0);
  for (int n = 0; n < 40; ++n) {
    Eigen::Vector3d p;
    for (int k = 0; k < 3; ++k) {
      const double share = 1.6 * random.uniform() - 0.3;
      p[k] = box.box_A.min()[k] + share * box.box_A.sizes()[k];
    }
    if (small.contains(p)) continue;
    CHECK(box.distance(p) == Approx(distance_to_grid(small, p) - box.radius).margin(4e-4));
  }
}

TEST_CASE("deep inside a rounded box the distance is that to the nearest side", "[boxes]") {
  const RoundedBox box{{Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.1, 0.2, 0.3)}, 0.01};
  CHECK(box.distance({0.05, 0.03, 0.15}) == Approx(-0.03));
  CHECK(box.distance({0.05, 0.1, 0.15}) == Approx(-0.05));
  CHECK(box.distance({0.05, 0.1, 0.3}) == Approx(0.0).margin(1e-12));
}

}  // namespace
}  // namespace quadrille
