#include "lab/physics/wall.hpp"

#include "lab/physics/bodies.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using Eigen::Vector3d;
using physics::TrueBody;
using physics::wall_distance;
using physics::WallDistance;

namespace {

TrueBody hollow(TrueBody body, bool floor) {
  body.wall = 0.003;
  body.open_low = !floor;
  body.open_high = true;
  return body;
}

}  // namespace

TEST_CASE("a wall's faces lie half its thickness on either side of the surface", "[physics]") {
  for (const TrueBody& body :
       {hollow(test::cylinder(0.03, 0.03, 0.04), false), hollow(test::cone(0.4, 0.05, 0.1), false),
        hollow(test::vase(0.02, 0.04, 0.04), false), hollow(test::dome(0.01, 0.05), false),
        hollow(test::cylinder(0.03, 0.02, 0.04), false)}) {
    CAPTURE(body.type);
    for (int i = 0; i < 24; ++i) {
      const double z = body.z_min() + (0.3 + 0.02 * i) * (body.z_max() - body.z_min());
      const Vector3d p = body.point_S(0.5 * i, z), n = body.normal_S(0.5 * i, z);
      for (const double side : {-1.0, 1.0}) {
        const WallDistance face = wall_distance(body, p + side * 0.0015 * n);
        CHECK(face.distance == Approx(0.0).margin(5e-5));
        // Straight out of the wall, but for what the surface bends within half a wall.
        CHECK(face.normal_S.dot(side * n) > 0.99);
        CHECK(wall_distance(body, p + side * 0.004 * n).distance == Approx(0.0025).margin(5e-4));
      }
      CHECK(wall_distance(body, p).distance == Approx(-0.0015).margin(1e-6));
    }
  }
}

TEST_CASE("a wall behind one side of the surface has its face there", "[physics]") {
  TrueBody cup = hollow(test::cone(0.4, 0.05, 0.1), true);
  const Vector3d p = cup.point_S(1.0, 0.08), n = cup.normal_S(1.0, 0.08);
  cup.wall_at = -0.0015;
  CHECK(wall_distance(cup, p).distance == Approx(0.0).margin(1e-9));
  CHECK(wall_distance(cup, p).normal_S.dot(n) > 0.99);
  CHECK(wall_distance(cup, p - 0.002 * n).distance < -0.0009);
  cup.wall_at = 0.0015;
  CHECK(wall_distance(cup, p).normal_S.dot(n) < -0.99);
  CHECK(wall_distance(cup, p + 0.002 * n).distance < -0.0009);
}

TEST_CASE("a hollow body is open at its mouth and closed by its floor", "[physics]") {
  const TrueBody cup = hollow(test::cylinder(0.03, 0.03, 0.04), true);
  CHECK(wall_distance(cup, {0.0, 0.0, 0.02}).distance > 0.02);
  CHECK(wall_distance(cup, {0.0, 0.0, 0.05}).distance > 0.01);
  CHECK(wall_distance(cup, {0.0, 0.0, -0.0385}).distance == Approx(-0.0015));
  const WallDistance below = wall_distance(cup, {0.0, 0.0, -0.045});
  CHECK(below.distance == Approx(0.005));
  CHECK(below.normal_S.isApprox(-Vector3d::UnitZ()));
  // Above the rim.
  const WallDistance above = wall_distance(cup, {0.03, 0.0, 0.042});
  CHECK(above.distance == Approx(0.002));
  CHECK(above.normal_S.isApprox(Vector3d::UnitZ()));
  const TrueBody tube = hollow(test::cylinder(0.03, 0.03, 0.04), false);
  CHECK(wall_distance(tube, {0.0, 0.0, -0.0385}).distance > 0.02);
}
