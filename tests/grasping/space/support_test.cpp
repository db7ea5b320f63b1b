#include "space/support.hpp"

#include "body/body.hpp"
#include "grasping/scenes.hpp"
#include "space/collision.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("a support holds off what is below it only as far as it reaches",
          "[collision][support]") {
  std::mt19937 random(41);
  SupportPlane plane{random_pose(random), {Eigen::Vector2d(-0.2, -0.1), Eigen::Vector2d(0.2, 0.1)}};
  int inside = 0;
  for (int n = 0; n < 2000; ++n) {
    const OrientedBox box{random_rotation(random),
                          plane.X_CP * random_point(random, {Eigen::Vector3d(-0.4, -0.3, -0.1),
                                                             Eigen::Vector3d(0.4, 0.3, 0.1)}),
                          Eigen::Vector3d(0.02, 0.03, 0.04)};
    const Eigen::Vector3d p = plane.X_CP.inverse() * box.p_CB;
    const double far = box.half.norm();
    const bool over = std::abs(p.x()) < 0.2 && std::abs(p.y()) < 0.1;
    if (over && p.z() < 0.002) {
      CHECK(plane.meets(box, 0.002));
      ++inside;
    }
    if (std::abs(p.x()) > 0.2 + far || std::abs(p.y()) > 0.1 + far || p.z() > 0.002 + far) {
      CHECK_FALSE(plane.meets(box, 0.002));
    }
    // All eight corners in the open: only the box's bounds may say otherwise.
    CHECK(plane.meets(box, 0.002) == plane.meets(box.inflated(1e-9), 0.002));
  }
  CHECK(inside > 100);
}

TEST_CASE("a plane whose pose is none supports nothing", "[support][hostile]") {
  const Body body = *make_body(sphere_detection(ball_on_table(0.0, 0.0, 0.03)));
  CHECK(supports_of(body, {table_detection()}).size() == 1);
  for (int entry = 0; entry < 12; ++entry) {
    for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
      Detection table = table_detection();
      table.X_CQ.matrix()(entry / 4, entry % 4) = value;
      CHECK(supports_of(body, {table}).empty());
    }
  }
}

TEST_CASE("a thing that lies flat stands on what it lies on, however long it is", "[support]") {
  Body plate;
  plate.profile = Body::Profile::kBox;
  plate.a = 0.08, plate.b = 0.03, plate.z_min = -0.005, plate.z_max = 0.005;
  const Detection table = table_detection();
  const auto stands = [&](double height) {
    plate.X_CQ = table.X_CQ;
    plate.X_CQ.translation() = table.X_CQ * Eigen::Vector3d(0.0, 0.0, height);
    return !supports_of(plate, {table}).empty();
  };
  CHECK(stands(0.005));
  // Fits may put the foot into the table, but not most of the body.
  CHECK(stands(-0.002));
  CHECK_FALSE(stands(-0.003));
}
