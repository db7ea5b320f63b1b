#include "fit/geometric_fit.hpp"

#include <cmath>
#include <limits>

#include "fit/distance_sums.hpp"
#include "fit/family_spec.hpp"
#include "fit/model_selection.hpp"
#include "support/catch.hpp"
#include "support/quadric_points.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// The truth, disturbed within its family.
PosedQuadric disturbed(Family family, const PosedQuadric& truth, double size,
                       RandomStream& random) {
  const FamilySpec& spec = family_spec(family);
  Eigen::VectorXd step(static_cast<Eigen::Index>(spec.shapes.size() + spec.motions.size()));
  for (double& s : step) s = size * (2.0 * random.uniform() - 1.0);
  return moved(family, truth, step);
}

double sum_of_squares(const OrientedPointsf& points, const Eigen::Matrix4d& Q) {
  return DistanceSums(points).evaluate(Q).squares();
}

}  // namespace

TEST_CASE("each family is recovered from noisy samples and a rough start", "[fit][law]") {
  RandomStream random(31, 0);
  constexpr double kNoise = 0.01;
  for (const FamilyExample& example : family_examples()) {
    CAPTURE(example.name);
    for (int k = 0; k < 5; ++k) {
      const ExamplePoints data = make_points(example, 600, kNoise, random);
      const PosedQuadric start = disturbed(example.family, data.truth, 0.08, random);
      const auto fit = refine(data.points, example.family, start, 30);
      REQUIRE(fit);
      CHECK(fit->family == example.family);
      CHECK(fit->points == 600);
      CHECK(difference(fit->posed.matrix(), data.truth.matrix()) < 0.01);
      // The noise is left over, but for the degrees of freedom.
      const double expected = kNoise * kNoise * (600 - family_spec(example.family).dof);
      CHECK(fit->rss == Approx(expected).epsilon(0.2));
      CHECK(fit->rss == Approx(sum_of_squares(data.points, fit->posed.matrix())).epsilon(1e-3));
    }
  }
}

TEST_CASE("the information is JᵀJ by finite differences of the first-order distance",
          "[fit][law]") {
  RandomStream random(32, 0);
  for (const FamilyExample& example : family_examples()) {
    CAPTURE(example.name);
    const ExamplePoints data = make_points(example, 100, 0.03, random);
    const auto fit = refine(data.points, example.family, data.truth, 0);
    REQUIRE(fit);
    const FamilySpec& spec = family_spec(example.family);
    const auto size = static_cast<Eigen::Index>(spec.shapes.size() + spec.motions.size());
    // A step of the general family rescales D, which no distance feels.
    Eigen::MatrixXd J(data.points.size(), size);
    for (Eigen::Index k = 0; k < size; ++k) {
      const double h = 1e-5;
      const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(size, k);
      const Quadric plus(moved(example.family, data.truth, step).matrix());
      const Quadric minus(moved(example.family, data.truth, -step).matrix());
      for (Eigen::Index i = 0; i < data.points.size(); ++i) {
        const Eigen::Vector3d x = data.points.at(i).x;
        J(i, k) = (plus.distance(x) - minus.distance(x)) / (2 * h);
      }
    }
    const Eigen::MatrixXd expected = J.transpose() * J;
    const FitInformation found = information(data.points, *fit);
    CHECK((found.JtJ - expected).norm() < 1e-3 * expected.norm());
    const Eigen::VectorXd sums = J.transpose() * Eigen::VectorXd::Ones(J.rows());
    CHECK((found.Jt1 - sums).norm() < 1e-3 * std::sqrt(expected.trace() * double(J.rows())));
  }
}

TEST_CASE("points that all move along their normals make a ball and a cylinder larger by as much",
          "[fit][law]") {
  RandomStream random(35, 0);
  for (const FamilyExample& example : family_examples()) {
    if (example.family != Family::kSphere && example.family != Family::kCylinder) continue;
    CAPTURE(example.name);
    const ExamplePoints data = make_points(example, 200, 0.0, random);
    const auto fit = refine(data.points, example.family, data.truth, 5);
    REQUIRE(fit);
    const FitInformation found = information(data.points, *fit);
    const auto radius_after = [&](double offset) {
      const Eigen::VectorXd step = -offset * found.JtJ.ldlt().solve(found.Jt1);
      return canonical_form(moved(example.family, fit->posed, step)).dimensions[0].second;
    };
    CHECK(radius_after(1e-3) - radius_after(0.0) == Approx(1e-3).epsilon(0.02));
  }
}

TEST_CASE("the sum of squares is that of the first-order distances", "[fit]") {
  RandomStream random(33, 0);
  for (const FamilyExample& example : family_examples()) {
    const ExamplePoints data = make_points(example, 200, 0.03, random);
    const Quadric Q(data.truth.matrix());
    double sum = 0;
    for (Eigen::Index i = 0; i < data.points.size(); ++i) {
      sum += std::pow(Q.distance(data.points.at(i).x), 2);
    }
    CAPTURE(example.name);
    CHECK(sum_of_squares(data.points, data.truth.matrix()) == Approx(sum).epsilon(1e-3));
    CHECK(sum_of_squares(data.points, -5.0 * data.truth.matrix()) == Approx(sum).epsilon(1e-3));
  }
}

TEST_CASE("a fit never leaves more than its start and a general one no more than a restricted",
          "[fit][law]") {
  RandomStream random(34, 0);
  for (const FamilyExample& example : family_examples()) {
    const ExamplePoints data = make_points(example, 400, 0.02, random);
    const auto restricted = refine(data.points, example.family, data.truth, 20);
    const auto general = fit_family(data.points, Family::kGeneral, 30);
    CAPTURE(example.name);
    REQUIRE(restricted);
    REQUIRE(general);
    CHECK(restricted->rss <= sum_of_squares(data.points, data.truth.matrix()));
    CHECK(general->rss <= 1.001 * restricted->rss);
  }
}

TEST_CASE("a motion of the pose moves the quadric by that motion", "[fit]") {
  RandomStream random(35, 0);
  PosedQuadric start;
  start.X = random_pose(random, 0.3);
  start.D = diagonal(1, 1, -0.36, 0);
  // Motions of cones: after the one shape, x y z, then the rotations about x and y.
  Eigen::VectorXd step = Eigen::VectorXd::Zero(6);
  step[1] = 0.2;
  CHECK((moved(Family::kCone, start, step).X.translation() -
         (start.X.translation() + 0.2 * start.X.linear().col(0)))
            .norm() < 1e-12);
  step.setZero();
  step[4] = 0.3;
  const Eigen::Isometry3d turned =
      start.X * Eigen::Isometry3d(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()));
  CHECK(moved(Family::kCone, start, step).X.isApprox(turned, 1e-12));
  step.setZero();
  step[0] = -0.1;
  CHECK(moved(Family::kCone, start, step).D(2, 2) == Approx(-0.46));
}

TEST_CASE("too few points, NaN and a zero quadric have no fit", "[fit][degenerate]") {
  RandomStream random(36, 0);
  for (const FamilyExample& example : family_examples()) {
    CAPTURE(example.name);
    const ExamplePoints few = make_points(example, family_spec(example.family).dof - 1, 0, random);
    CHECK_FALSE(refine(few.points, example.family, few.truth, 5));
    ExamplePoints data = make_points(example, 50, 0, random);
    PosedQuadric zero = data.truth;
    zero.D.setZero();
    CHECK_FALSE(refine(data.points, example.family, zero, 5));
    data.points.points(0, 7) = std::numeric_limits<float>::quiet_NaN();
    CHECK_FALSE(refine(data.points, example.family, data.truth, 5));
  }
}
