#include "track/seen_patch.hpp"

#include "support/catch.hpp"
#include "support/depth_camera.hpp"
#include "support/exact_detection.hpp"

namespace quadrille {
namespace {

const Eigen::Isometry3d kRest = Eigen::Isometry3d::Identity();

PatchMatch match_of(const Detection& from, const Detection& to) {
  return match_patches(seen_patch(from, kRest), seen_patch(to, kRest));
}

TEST_CASE("a patch lies on its quadric, within its extent, and faces as its gradient does",
          "[patch]") {
  const Eigen::Isometry3d X_WC =
      test::translation(1, 2, 3) * Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 1, 0).normalized());
  for (const Detection& d :
       {test::exact_ball({0.1, 0.2, 1.0}, 0.1), test::exact_cylinder({0, 0, 1}, 0.05, 0.2),
        test::exact_plane({0, 0, 1}, 1.0, 0.5), test::exact_ellipsoid({0, 0.1, 1}, 0.1, 0.2)}) {
    const SeenPatch patch = seen_patch(d, X_WC);
    CHECK(patch.points_W.size() >= 30);
    for (std::size_t i = 0; i < patch.points_W.size(); ++i) {
      const Eigen::Vector3d x_C = X_WC.inverse() * patch.points_W[i];
      CHECK(std::abs(d.Q_C.distance(x_C)) < 1e-9);
      CHECK(d.extent_Q.exteriorDistance(d.X_CQ.inverse() * x_C) < 1e-9);
      const Eigen::Vector3d n_C = X_WC.linear().transpose() * patch.normals_W[i];
      CHECK(n_C.dot(d.Q_C.gradient(x_C).normalized()) == Approx(1.0));
    }
  }
}

TEST_CASE("a detection without extent is a patch of one point", "[patch]") {
  Detection d = test::exact_ball({0, 0, 1}, 0.1);
  d.extent_Q.setEmpty();
  CHECK(seen_patch(d, kRest).points_W.size() == 1);
}

TEST_CASE("a ball's shift is that of its centre, however little of it is seen", "[patch]") {
  const Detection from = test::exact_ball({0, 0, 1}, 0.1);
  Detection to = test::exact_ball({0.03, -0.02, 1.01}, 0.1);
  const Eigen::Vector3d moved(0.03, -0.02, 0.01);
  CHECK((match_of(from, to).shift_W - moved).norm() < 1e-3);
  to.extent_Q.max().x() = -0.02;
  const PatchMatch half = match_of(from, to);
  CHECK((half.shift_W - moved).norm() < 2e-3);
  CHECK(half.residual < 1e-3);
  CHECK(half.gap == 0.0);
}

TEST_CASE("what slides is not moved: a plane in itself, a cylinder along its axis", "[patch]") {
  const PatchMatch plane = match_of(test::exact_plane({0, 0, 1}, 1.0, 0.5),
                                    test::exact_plane({0.2, 0.1, 1.03}, 0.6, 0.3));
  CHECK((plane.shift_W - Eigen::Vector3d(0, 0, 0.03)).norm() < 1e-3);
  CHECK(plane.gap == 0.0);
  const PatchMatch cylinder = match_of(test::exact_cylinder({0, 0, 1}, 0.05, 0.3),
                                       test::exact_cylinder({0.02, 0.05, 1}, 0.05, 0.15));
  CHECK((cylinder.shift_W - Eigen::Vector3d(0.02, 0, 0)).norm() < 1e-3);
  CHECK(cylinder.residual < 1e-3);
}

TEST_CASE("a ball and the ellipsoid that it may be taken for are one surface", "[patch]") {
  const PatchMatch match =
      match_of(test::exact_ball({0.2, 0, 1}, 0.1), test::exact_ellipsoid({0.2, 0, 1}, 0.1, 0.13));
  CHECK(match.shift_W.norm() < 0.012);
  CHECK(match.residual < 0.005);
  CHECK(match.turn < 0.2);
}

TEST_CASE("surfaces of other shapes, apart on one quadric, or seen from both sides differ",
          "[patch]") {
  CHECK(match_of(test::exact_ball({0, 0, 1}, 0.1), test::exact_ball({0, 0, 1}, 0.2)).residual >
        0.01);
  CHECK(match_of(test::exact_cylinder({0, -0.2, 1}, 0.05, 0.2),
                 test::exact_cylinder({0, 0.3, 1}, 0.05, 0.2))
            .gap > 0.2);
  Detection inside = test::exact_ball({0, 0, 1}, 0.1);
  inside.Q_C = inside.Q_C.flipped();
  CHECK(match_of(test::exact_ball({0, 0, 1}, 0.1), inside).turn > 0.9);
}

}  // namespace
}  // namespace quadrille
