#include "body/shell.hpp"

#include <algorithm>

#include "grasping/scenes.hpp"
#include "space/collision.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("the signed distance of a shell vanishes on its surface and grows along normals",
          "[rim]") {
  for (const Detection& d : solid_detections()) {
    if (d.type == QuadricType::kParallelPlanes) continue;
    const Shell shell{make_body(d).value(), false, {}};
    CAPTURE(to_string(d.type));
    for (int k = 0; k < 12; ++k) {
      const double z = shell.body.z_min + (0.3 + 0.04 * k) * (shell.body.z_max - shell.body.z_min);
      const Eigen::Vector3d p = shell.point_Q(0.5 * k, z), n = shell.normal_Q(0.5 * k, z);
      const auto at = [&](double off) { return shell.offset(shell.body.X_CQ * (p + off * n)); };
      CHECK(at(0.0) == Approx(0.0).margin(1e-9));
      CHECK(at(0.002) == Approx(0.002).epsilon(0.15));
      CHECK(at(-0.002) == Approx(-0.002).epsilon(0.15));
    }
  }
}

TEST_CASE("the wall's shapes hold all of the wall and leave the hollow open", "[rim][shape]") {
  std::mt19937 random(21);
  for (const Detection& d : solid_detections()) {
    if (d.type == QuadricType::kParallelPlanes) continue;
    for (const bool inside : {false, true}) {
      const Shell shell{make_body(d).value(), inside, {0.002, 0.004}};
      const auto pieces = make_wall(shell);
      const auto covered = [&](const Eigen::Vector3d& p_Q) {
        const OrientedBox dot{Eigen::Matrix3d::Identity(), shell.body.X_CQ * p_Q,
                              Eigen::Vector3d::Constant(0.0003)};
        return std::any_of(pieces.begin(), pieces.end(),
                           [&](const CollisionShape& piece) { return overlaps(dot, piece); });
      };
      CAPTURE(to_string(d.type), inside);
      const double height = shell.body.z_max - shell.body.z_min;
      for (int n = 0; n < 60; ++n) {
        const double z = shell.body.z_max - uniform(random, 0.05, 0.45) * height;
        const double angle = uniform(random, 0.0, 6.28);
        const double off = uniform(random, shell.inner(), shell.outer());
        CHECK(covered(shell.point_Q(angle, z) + off * shell.normal_Q(angle, z)));
      }
      CHECK_FALSE(covered({0.0, 0.0, shell.body.z_max - 0.3 * height}));
    }
  }
}
