#include "fits/contenders.hpp"

#include <algorithm>
#include <limits>

#include "detector/fits/examples.hpp"
#include "fits/simple_type_fits.hpp"
#include "fits/two_planes_fit.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using quadrille::test::curved_forms;
using quadrille::test::sample;
using quadrille::test::Sampled;

namespace {

using T = QuadricType;

/// Every fit with a kind of surface that it can fit.
struct Case {
  Contender contender;
  CanonicalForm form;
};

CanonicalForm form_of(T type) {
  for (const CanonicalForm& form : curved_forms()) {
    if (form.type == type) return form;
  }
  return {T::kPlane, Eigen::Isometry3d::Identity(), {}};
}

std::vector<Case> type_specific_fits() {
  const auto row = [](std::string_view name, T type, int least, auto fit) {
    return Case{{name, "", least, false, false, fit}, form_of(type)};
  };
  using P = const OrientedPointsd&;
  return {
      row("plane", T::kPlane, 3, [](P p) { return fit_plane(p); }),
      row("two_planes", T::kIntersectingPlanes, 6, [](P p) { return fit_two_planes(p); }),
      row("sphere", T::kSphere, 2, [](P p) { return fit_sphere(p); }),
      row("spheroid", T::kSphere, 4, [](P p) { return fit_spheroid(p); }),
      row("cylinder", T::kCylinder, 2, [](P p) { return fit_cylinder(p); }),
      row("cone", T::kCone, 3, [](P p) { return fit_cone(p); }),
  };
}

/// All fits, the general ones on an ellipsoid.
std::vector<Case> all_fits() {
  std::vector<Case> cases = type_specific_fits();
  for (const Contender& contender : contenders(T::kEllipsoid)) {
    cases.push_back({contender, form_of(T::kEllipsoid)});
  }
  return cases;
}

/// Those that find the exact quadric from exact data: not those with a prior, a ridge or levels.
bool is_exact(std::string_view name) {
  return name != "bayesian" && name != "gradient_one" && name != "three_level";
}

/// Largest first-order distance of the points from the fit.
double worst_distance(const Quadric& Q, const OrientedPointsd& points) {
  double worst = 0.0;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    worst = std::max(worst, std::abs(Q.distance(points.points.col(i))));
  }
  return worst;
}

double gap(const Quadric& a, const Quadric& b) {
  return (a.coefficients() - b.coefficients()).norm();
}

OrientedPointsd moved(const OrientedPointsd& points, const Eigen::Isometry3d& X, double scale) {
  OrientedPointsd result = points;
  result.points = scale * (X * points.points);
  result.normals = X.linear() * points.normals;
  return result;
}

Quadric moved(const Quadric& Q, const Eigen::Isometry3d& X, double scale) {
  Eigen::Projective3d S = Eigen::Projective3d::Identity();
  S.matrix().topLeftCorner<3, 3>() *= scale;
  return Q.transformed(X).transformed(S).normalized();
}

}  // namespace

TEST_CASE("every fit finds quadrics of every type from exact points with full gradients",
          "[fits][law]") {
  RandomStream random(41, 0);
  for (const CanonicalForm& form : curved_forms()) {
    for (const Contender& contender : contenders(form.type)) {
      CAPTURE(to_string(form.type), contender.name);
      // Too few points on one plane of two leave the other free.
      if (contender.minimal && is_flat(form.type)) continue;
      // Full gradients: the common scale of the compact system holds for them.
      const Sampled s = sample(form, contender.minimal ? contender.min_points : 60, random, false);
      const auto Q = contender.fit(s.points);
      REQUIRE(Q);
      CHECK(Q->coefficients().norm() == Approx(1.0));
      if (is_exact(contender.name)) {
        CHECK(gap(*Q, s.Q) < 2e-4);
        CHECK(worst_distance(*Q, s.points) < 1e-4);
      }
    }
  }
}

TEST_CASE("the fits with a prior, a ridge or levels come close on exact points", "[fits]") {
  RandomStream random(42, 0);
  for (const Contender& contender : contenders(T::kEllipsoid)) {
    if (is_exact(contender.name)) continue;
    CAPTURE(contender.name);
    const Sampled s = sample(form_of(T::kEllipsoid), 200, random, true);
    const auto Q = contender.fit(s.points);
    REQUIRE(Q);
    CHECK(worst_distance(*Q, s.points) < 0.15);
    CHECK(worst_distance(*Q, s.points) > 1e-6);
  }
}

TEST_CASE("every type-specific fit finds its type with its dimensions", "[fits][types]") {
  RandomStream random(43, 0);
  for (const Case& c : type_specific_fits()) {
    CAPTURE(c.contender.name);
    for (const int count : {std::max<int>(8, c.contender.min_points), 40}) {
      const Sampled s = sample(c.form, count, random, true);
      const auto Q = c.contender.fit(s.points);
      REQUIRE(Q);
      CHECK(gap(*Q, s.Q) < 1e-5);
      CHECK(canonical_form(*Q, 1e-6).type == c.form.type);
    }
  }
}

TEST_CASE("the basis of a type and one more point suffice for its fit", "[fits][types]") {
  RandomStream random(44, 0);
  const Sampled sphere = sample(form_of(T::kSphere), 2, random, true);
  REQUIRE(fit_sphere(sphere.points));
  CHECK(gap(*fit_sphere(sphere.points), sphere.Q) < 1e-6);
  const Sampled cylinder = sample(form_of(T::kCylinder), 2, random, true);
  REQUIRE(fit_cylinder(cylinder.points));
  CHECK(gap(*fit_cylinder(cylinder.points), cylinder.Q) < 1e-6);
  const Sampled cone = sample(form_of(T::kCone), 3, random, true);
  const auto found = fit_cone(cone.points);
  REQUIRE(found);
  CHECK(worst_distance(*found, cone.points) < 1e-6);
}

TEST_CASE("a spheroid of either kind is found with its axis", "[fits][types]") {
  RandomStream random(45, 0);
  const Eigen::Isometry3d I = Eigen::Isometry3d::Identity();
  for (const double c : {0.4, 1.2}) {
    const CanonicalForm form{T::kEllipsoid, I, {{"a", 0.8}, {"b", 0.8}, {"c", c}}};
    const Sampled s = sample(form, 30, random, true);
    const auto Q = fit_spheroid(s.points);
    REQUIRE(Q);
    CHECK(gap(*Q, s.Q) < 1e-6);
  }
  const Sampled saddle = sample(form_of(T::kHyperboloidOneSheet), 30, random, true);
  CHECK_FALSE(fit_spheroid(saddle.points));
}

TEST_CASE("every fit moves, scales and flips with its data", "[fits][law]") {
  RandomStream random(46, 0);
  for (const Case& c : all_fits()) {
    CAPTURE(c.contender.name);
    // Constraints on |q| depend on the axes.
    const bool exact_only = c.contender.name == "full" || c.contender.name == "pd_3";
    const Eigen::Index count = c.contender.minimal ? c.contender.min_points : 80;
    OrientedPointsd points = sample(c.form, count, random, true).points;
    if (!exact_only) points = test::with_noise(points, 0.01, 0.02, random);
    const auto Q = c.contender.fit(points);
    REQUIRE(Q);
    Eigen::Isometry3d X = test::random_pose(random, 2.0);
    for (const double scale : {1.0, 0.01, 250.0}) {
      CAPTURE(scale);
      const auto there = c.contender.fit(moved(points, X, scale));
      REQUIRE(there);
      CHECK(gap(*there, moved(*Q, X, scale)) < 1e-4);
    }
    OrientedPointsd flipped = points;
    flipped.normals *= -1.0;
    const auto other = c.contender.fit(flipped);
    REQUIRE(other);
    CHECK(gap(*other, Q->flipped()) < 1e-6);
  }
}

TEST_CASE("every fit answers degenerate input with no solution", "[fits][degenerate]") {
  RandomStream random(47, 0);
  for (const Case& c : all_fits()) {
    CAPTURE(c.contender.name);
    const Eigen::Index count = std::max<Eigen::Index>(c.contender.min_points, 12);
    const OrientedPointsd good = sample(c.form, count, random, true).points;
    REQUIRE(c.contender.fit(good));
    const auto spoilt = [&](const auto& spoil) {
      OrientedPointsd points = good;
      spoil(points);
      return c.contender.fit(points);
    };
    CHECK_FALSE(c.contender.fit(OrientedPointsd(0)));
    CHECK_FALSE(c.contender.fit(good.first(c.contender.min_points - 1)));
    CHECK_FALSE(spoilt([](auto& p) { p.points.colwise() = Eigen::Vector3d(1, 2, 3); }));
    CHECK_FALSE(spoilt([](auto& p) {
      p.points.colwise() = Eigen::Vector3d(1, 2, 3);
      p.normals.colwise() = Eigen::Vector3d(0, 0, 1);
    }));
    CHECK_FALSE(spoilt([](auto& p) {
      const Eigen::RowVectorXd along = p.points.row(0);
      p.points = Eigen::Vector3d(0.2, -0.5, 1.0) * along;
      p.normals.colwise() = Eigen::Vector3d(5, 2, 0).normalized();
    }));
    if (c.contender.name != "plane") {
      CHECK_FALSE(spoilt([](auto& p) {
        p.points.row(2).setConstant(0.4);
        p.normals.colwise() = Eigen::Vector3d::UnitZ();
      }));
    }
    CHECK_FALSE(spoilt([](auto& p) { p.normals.col(0).setZero(); }));
    CHECK_FALSE(spoilt([](auto& p) { p.normals.setZero(); }));
    CHECK_FALSE(spoilt([](auto& p) { p.points(1, 1) = std::nan(""); }));
    CHECK_FALSE(spoilt([](auto& p) { p.points(0, 0) = INFINITY; }));
    CHECK_FALSE(spoilt([](auto& p) { p.normals(2, 0) = std::nan(""); }));
    OrientedPointsd uneven = good;
    uneven.normals.conservativeResize(3, count - 1);
    CHECK_THROWS_AS(c.contender.fit(uneven), std::invalid_argument);
  }
}

TEST_CASE("contenders have distinct names and are found by them", "[fits]") {
  const auto all = contenders(T::kSphere);
  for (const Contender& contender : all) {
    REQUIRE(find_contender(all, contender.name) == &contender);
  }
  CHECK(find_contender(all, "no such fit") == nullptr);
}
