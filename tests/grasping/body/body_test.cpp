#include "body/body.hpp"

#include "grasping/clipped_surface.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("a body holds the surface that it was made of, and its box holds the body", "[body]") {
  std::mt19937 random(51);
  for (const QuadricType type : all_quadric_types()) {
    for (int n = 0; n < 5 && !is_imaginary(type); ++n) {
      ClippedSurface surface(type, random);
      const std::optional<Body> body = make_body(surface.detection());
      if (!body) continue;
      CAPTURE(to_string(type), n);
      for (const Eigen::Vector3d& p : surface.sample(100)) {
        REQUIRE(body->contains(p, 1e-9));
        Eigen::AlignedBox3d box = body->bounds_C();
        box.min().array() -= 1e-9;
        box.max().array() += 1e-9;
        REQUIRE(box.contains(p));
      }
      CHECK(body->contains(body->centre_C()));
    }
  }
}

TEST_CASE("the slope of a profile is the derivative of its scale", "[body]") {
  for (const Detection& d : solid_detections()) {
    const Body body = make_body(d).value();
    for (const double u : {0.2, 0.5, 0.8}) {
      const double z = body.z_min + u * (body.z_max - body.z_min), h = 1e-7;
      const double slope = (body.scale(z + h) - body.scale(z - h)) / (2.0 * h);
      CAPTURE(to_string(d.type), u);
      CHECK(body.slope(z) == Approx(slope).epsilon(1e-5).margin(1e-6));
    }
  }
}

TEST_CASE("a surface leans as uncertainly as its semi-axes are known", "[body]") {
  const auto lean = [](const Body& body, double z) { return std::atan(body.a * body.slope(z)); };
  for (const Detection& d : solid_detections()) {
    Body body = make_body(d).value();
    body.std = Eigen::Vector3d::Zero();
    for (const double u : {0.2, 0.5, 0.8}) {
      const double z = body.z_min + u * (body.z_max - body.z_min), h = 1e-6;
      CAPTURE(to_string(d.type), u);
      CHECK(body.lean_std(z) == 0.0);
      const bool rounded = body.profile == Body::Profile::kEllipse;
      if (rounded || body.a != body.b || body.profile == Body::Profile::kBox) continue;
      // Each deviation alone moves the angle as much as the difference of two bodies.
      Body other = body, doubted = body;
      other.a += h * body.a;
      doubted.std = {h * body.a, h * body.b, 0.0};
      CHECK(doubted.lean_std(z) ==
            Approx(std::abs(lean(other, z) - lean(body, z))).epsilon(1e-3).margin(1e-12));
      if (body.c == 0.0) continue;
      other = doubted = body;
      other.c += h * body.c;
      doubted.std = {0.0, 0.0, h * body.c};
      CHECK(doubted.lean_std(z) ==
            Approx(std::abs(lean(other, z) - lean(body, z))).epsilon(1e-3).margin(1e-12));
    }
  }
}

TEST_CASE("only types that enclose something become bodies", "[body]") {
  std::mt19937 random(52);
  for (const QuadricType type :
       {QuadricType::kHyperbolicParaboloid, QuadricType::kPlane, QuadricType::kHyperbolicCylinder,
        QuadricType::kParabolicCylinder, QuadricType::kIntersectingPlanes,
        QuadricType::kCoincidentPlanes}) {
    CHECK_FALSE(make_body(ClippedSurface(type, random).detection()));
  }
}

TEST_CASE("a width is as uncertain as the semi-axes that its direction goes along", "[body]") {
  Detection d = solid_detections()[1];
  REQUIRE(d.type == QuadricType::kEllipsoid);
  d.dimensions[2].std = 0.004;
  const Body body = make_body(d).value();
  CHECK(body.width_std(Eigen::Vector3d::UnitX(), 0.0) == Approx(0.0).margin(1e-12));
  CHECK(body.width_std(Eigen::Vector3d::UnitZ(), 0.0) == Approx(0.004));
  // Against the difference of two bodies, oblique.
  const Eigen::Vector3d dir = Eigen::Vector3d(1, 2, 3).normalized();
  const auto half = [&](double c) {
    return Eigen::Vector3d(body.a, body.b, c).cwiseProduct(dir).norm();
  };
  const double slope = (half(body.c + 1e-6) - half(body.c - 1e-6)) / 2e-6;
  CHECK(body.width_std(dir, 0.0) == Approx(0.004 * slope).epsilon(1e-4));
  d.dimensions[2].std = std::numeric_limits<double>::infinity();
  CHECK(make_body(d).value().width_std(Eigen::Vector3d::UnitZ(), 0.0) == Approx(0.01));
}

TEST_CASE("a cone that was seen almost to its apex ends in it, a blunt one does not", "[body]") {
  Detection d;
  d.type = QuadricType::kCone;
  d.dimensions = {{"half_angle", 0.25, 0.0}};
  for (const double side : {1.0, -1.0}) {
    for (const double top : {0.012, 0.04}) {
      const Eigen::Vector3d a(-0.02, -0.02, side * top), b(0.02, 0.02, side * 0.1);
      d.extent_Q = {a.cwiseMin(b), a.cwiseMax(b)};
      const Body body = make_body(d).value();
      const double narrow = side > 0.0 ? body.z_min : body.z_max;
      CHECK(narrow == (top < 0.02 ? 0.0 : side * top));
      CHECK((side > 0.0 ? body.z_max : body.z_min) == side * 0.1);
    }
  }
}

TEST_CASE("a slender cone that was seen far from its apex does not grow to it", "[body]") {
  Detection d;
  d.type = QuadricType::kCone;
  d.dimensions = {{"half_angle", 0.05, 0.0}};
  // Its end is 5 mm wide, but the apex is farther off than it was seen long.
  d.extent_Q = {Eigen::Vector3d(-0.01, -0.01, 0.1), Eigen::Vector3d(0.01, 0.01, 0.18)};
  CHECK(make_body(d).value().z_min == 0.1);
}
