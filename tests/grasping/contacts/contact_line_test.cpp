#include "contacts/contact_line.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "contacts/quality.hpp"
#include "grasping/scenes.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("a sphere is grasped across its diameter without friction", "[contacts]") {
  const Body body = make_body(sphere_detection({{0.1, 0.0, 0.9}, 0.03})).value();
  const auto lines = contact_lines(body, franka_hand(), Eigen::Vector3d::Zero());
  REQUIRE(lines.size() > 50);
  for (const ContactLine& line : lines) {
    CHECK(line.width == Approx(0.06));
    CHECK(friction_needed(line) == Approx(0.0).margin(1e-9));
    CHECK((line.centre_C - Eigen::Vector3d(0.1, 0, 0.9)).norm() < 1e-12);
  }
}

TEST_CASE("contacts lie on the body's surface with its normals", "[contacts][law]") {
  std::mt19937 random(3);
  for (Detection d : solid_detections()) {
    d.X_CQ = random_pose(random);
    const Body body = make_body(d).value();
    CAPTURE(to_string(d.type));
    const auto lines = contact_lines(body, franka_hand(), Eigen::Vector3d::Zero());
    REQUIRE_FALSE(lines.empty());
    for (const ContactLine& line : lines) {
      for (int i = 0; i < 2; ++i) {
        const Eigen::Vector3d p = line.contacts_C[i], n = line.normals_C[i];
        CHECK(n.norm() == Approx(1.0));
        CHECK(body.contains(p, 1e-7));
        CHECK_FALSE(body.contains(p + 1e-4 * n));
        CHECK(body.contains(p - 1e-4 * n));
      }
      CHECK((line.contacts_C[0] - line.contacts_C[1]).dot(line.closing_C) == Approx(line.width));
      CHECK(line.opening >= line.width);
    }
  }
}

TEST_CASE("contact lines move with the body and the sensor", "[contacts][law]") {
  std::mt19937 random(4);
  for (const Detection& d : solid_detections()) {
    const Eigen::Isometry3d X = random_pose(random);
    const Eigen::Vector3d viewpoint(0.2, -0.5, 0.6);
    Detection moved = d;
    moved.X_CQ = X * d.X_CQ;
    const auto a = contact_lines(make_body(d).value(), franka_hand(), viewpoint);
    const auto b = contact_lines(make_body(moved).value(), franka_hand(), X * viewpoint);
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      CHECK((X * a[i].contacts_C[0] - b[i].contacts_C[0]).norm() < 1e-9);
      CHECK((X.linear() * a[i].closing_C - b[i].closing_C).norm() < 1e-9);
      CHECK(a[i].width == Approx(b[i].width));
    }
  }
}

TEST_CASE("a cone needs the friction of its half angle, a waist none", "[contacts]") {
  for (const Detection& d : solid_detections()) {
    const Body body = make_body(d).value();
    for (const ContactLine& line : contact_lines(body, franka_hand(), {0, 0, -1})) {
      if (d.type == QuadricType::kCone) CHECK(friction_needed(line) == Approx(std::tan(0.3)));
      if (d.type == QuadricType::kHyperboloidOneSheet && std::abs(line.centre_C.z()) < 1e-9 &&
          std::abs(line.closing_C.x()) > 1 - 1e-9) {
        CHECK(friction_needed(line) == Approx(0.0).margin(1e-9));
        CHECK(line.width == Approx(0.05));
      }
    }
  }
}

TEST_CASE("pads beside a waist meet it at their wide ends", "[contacts]") {
  const auto all = solid_detections();
  const auto d = std::find_if(all.begin(), all.end(), [](const Detection& one) {
    return one.type == QuadricType::kHyperboloidOneSheet;
  });
  Body body = make_body(*d).value();
  body.z_max = std::max(body.z_max, 0.06);
  const double reach = 0.5 * franka_hand().pad.maxCoeff();
  int beside = 0;
  for (const ContactLine& line : contact_lines(body, franka_hand(), {0, 0, -1})) {
    const Eigen::Vector3d p_Q = body.X_CQ.inverse() * line.centre_C;
    const double z = p_Q.z();
    const Eigen::Vector3d closing_Q = body.X_CQ.linear().transpose() * line.closing_C;
    if (z <= reach || std::abs(closing_Q.x()) < 1 - 1e-9) continue;
    ++beside;
    const double end = std::min(z + reach, body.z_max);
    // r² = a²(1 + z²/c²), so that r' = a²z/(c²r).
    const double r = body.a * std::sqrt(1.0 + end * end / (body.c * body.c));
    CHECK(friction_needed(line) ==
          Approx(body.a * body.a * end / (body.c * body.c * r)).epsilon(1e-6));
  }
  CHECK(beside > 0);
}

TEST_CASE("pads at a waist near the body's end meet the wide end alone, at two alike ends both",
          "[contacts]") {
  Body body;
  body.profile = Body::Profile::kHyperbola;
  body.a = body.b = 0.02;
  body.c = 0.05;
  const double reach = 0.5 * franka_hand().pad.maxCoeff();
  // The lean of the radius r = a√(1 + z²/c²) is r' = az/(c²√(1 + z²/c²)).
  const auto lean = [](double z) {
    return 0.02 * z / (0.05 * 0.05 * std::sqrt(1.0 + z * z / (0.05 * 0.05)));
  };
  const auto friction_near = [&](double z) {
    const std::vector<ContactLine> lines = contact_lines(body, franka_hand(), {0, 0, -1});
    const auto off = [&](const ContactLine& line) { return std::abs(line.centre_C.z() - z); };
    const auto nearest = std::min_element(
        lines.begin(), lines.end(),
        [&](const ContactLine& one, const ContactLine& other) { return off(one) < off(other); });
    REQUIRE(off(*nearest) < 1e-9);
    return friction_needed(*nearest);
  };
  // The body ends 1 mm below its waist. The lowest of the heights is a quarter of the length above
  // that end, at 5 mm.
  body.z_min = -0.001;
  body.z_max = -0.001 + 4.0 * 0.006;
  CHECK(friction_near(0.005) == Approx(lean(0.005 + reach)));
  CHECK(lean(0.005 + reach) > 0.1);
  // With the waist in the middle, nothing slides.
  body.z_min = -0.02;
  body.z_max = 0.02;
  CHECK(friction_near(0.0) == Approx(0.0).margin(1e-12));
}

TEST_CASE("a chord beside the widest part is narrower and needs friction", "[contacts]") {
  const Body body = make_body(sphere_detection({{0, 0, 1}, 0.05})).value();
  const auto line = chord(body, {0, -0.03, 1}, Eigen::Vector3d::UnitX());
  REQUIRE(line);
  CHECK(line->width == Approx(0.08));
  CHECK(friction_needed(*line) == Approx(0.75));
  CHECK_FALSE(chord(body, {0, -0.06, 1}, Eigen::Vector3d::UnitX()));
}

TEST_CASE("a chord ends on the surface of every body", "[contacts][law]") {
  std::mt19937 random(5);
  for (Detection d : solid_detections()) {
    d.X_CQ = random_pose(random);
    const Body body = make_body(d).value();
    int found = 0;
    for (int n = 0; n < 200; ++n) {
      const Eigen::Vector3d p = random_point(random, body.bounds_C());
      const auto line = chord(body, p, random_rotation(random).col(0));
      if (!line) continue;
      ++found;
      for (int i = 0; i < 2; ++i) {
        CHECK(body.contains(line->contacts_C[i], 1e-7));
        CHECK_FALSE(body.contains(line->contacts_C[i] + 1e-5 * line->normals_C[i]));
      }
    }
    CAPTURE(to_string(d.type));
    CHECK((found > 0) == (d.type != QuadricType::kParallelPlanes));
  }
}
