#include <Eigen/SVD>

#include "detector/fits/examples.hpp"
#include "fits/linear_system.hpp"
#include "fits/solution_space.hpp"
#include "fits/type_design.hpp"
#include "search/basis.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using quadrille::test::curved_forms;
using quadrille::test::difference;
using quadrille::test::sample;
using quadrille::test::Sampled;

namespace {

int rank(const Eigen::MatrixXd& A) {
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(A);
  svd.setThreshold(1e-8);
  return static_cast<int>(svd.rank());
}

OrientedPointsd part(const OrientedPointsd& points, Eigen::Index from, Eigen::Index count) {
  OrientedPointsd result(count);
  result.points = points.points.middleCols(from, count);
  result.normals = points.normals.middleCols(from, count);
  return result;
}

/// Three points as far from degenerate as a random choice allows, and more behind them.
Sampled sample_basis(const CanonicalForm& form, int count, RandomStream& random) {
  while (true) {
    Sampled s = sample(form, count, random, false);
    const auto pencil = make_pencil({s.points.at(0), s.points.at(1), s.points.at(2)});
    bool good = pencil.has_value();
    for (Eigen::Index i = 3; good && i < count; ++i) {
      good = std::abs(pencil->plane.dot(s.points.points.col(i).homogeneous())) > 0.1;
    }
    if (good) return s;
  }
}

/// A surface whose tangent planes at any two points do not hold the other point.
CanonicalForm ellipsoid() { return curved_forms()[1]; }

}  // namespace

TEST_CASE("the compact system has the rank 4, 7, 9, 10 for 1, 2, 3, 4 points",
          "[theorem][paper:eq5]") {
  RandomStream random(21, 0);
  const int expected[] = {4, 7, 9, 10, 10};
  for (const CanonicalForm& form : curved_forms()) {
    CAPTURE(to_string(form.type));
    const Sampled s = sample_basis(form, 5, random);
    for (int count = 1; count <= 5; ++count) {
      CHECK(rank(compact_system(s.points.first(count)).A) == expected[count - 1]);
    }
  }
}

TEST_CASE("the full system leaves 7, 4, 2, 1 solutions for 1, 2, 3, 4 points of a quadric",
          "[theorem][paper:eq4]") {
  // Its rank is 4, 8, 11, 13 of N + 10 columns: the printed 4, 7, 9, 10 are the compact system's,
  // whose homogeneous solutions are one fewer as its scale is fixed.
  RandomStream random(22, 0);
  const int expected[] = {4, 8, 11, 13, 14};
  for (int trial = 0; trial < 20; ++trial) {
    const Sampled s = sample_basis(ellipsoid(), 5, random);
    for (int count = 1; count <= 5; ++count) {
      const Eigen::MatrixXd A = full_system(s.points.first(count));
      REQUIRE(A.rows() == 4 * count);
      REQUIRE(A.cols() == count + 10);
      CHECK(rank(A) == expected[count - 1]);
      if (count <= 3)
        CHECK(A.cols() - rank(A) == 11 - rank(compact_system(s.points.first(count)).A));
    }
  }
}

TEST_CASE("theorem 1: the data plane squared solves the full system of three points with α = 0",
          "[theorem][paper:theorem1]") {
  RandomStream random(23, 0);
  for (const CanonicalForm& form : curved_forms()) {
    const Sampled s = sample_basis(form, 3, random);
    const auto pencil = make_pencil({s.points.at(0), s.points.at(1), s.points.at(2)});
    const Quadric squared(Eigen::Matrix4d(pencil->plane * pencil->plane.transpose()));
    Eigen::VectorXd trivial = Eigen::VectorXd::Zero(13), truth = trivial;
    trivial.head<10>() = squared.coefficients();
    truth << s.Q.coefficients(), 1.0, 1.0, 1.0;
    const Eigen::MatrixXd A = full_system(s.points);
    CHECK((A * trivial).norm() < 1e-12);
    CHECK((A * truth).norm() < 1e-12);
    CHECK(rank(squared.matrix()) == 1);
  }
}

TEST_CASE("theorem 1: normals that no quadric shares leave the data plane alone",
          "[theorem][paper:theorem1]") {
  RandomStream random(24, 0);
  Sampled s = sample_basis(ellipsoid(), 3, random);
  s.points = test::with_noise(s.points, 0.0, 0.2, random);
  const Eigen::MatrixXd A = full_system(s.points);
  REQUIRE(rank(A) == 12);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeFullV);
  const Eigen::VectorXd only = svd.matrixV().col(12);
  const auto pencil = make_pencil({s.points.at(0), s.points.at(1), s.points.at(2)});
  CHECK(only.tail<3>().norm() < 1e-9);
  CHECK(difference(Quadric(Vector10d(only.head<10>())).matrix(),
                   pencil->plane * pencil->plane.transpose()) < 1e-7);
}

TEST_CASE("theorem 2: λ of further points recovers the quadric from any basis",
          "[theorem][paper:theorem2]") {
  RandomStream random(25, 0);
  for (const CanonicalForm& form : curved_forms()) {
    CAPTURE(to_string(form.type));
    const Sampled s = sample_basis(form, 7, random);
    for (int basis = 1; basis <= 3; ++basis) {
      const SolutionSpace space = solution_space(compact_system(s.points.first(basis)));
      CHECK(space.null_space.cols() == 10 - space.rank);
      const Eigen::VectorXd lambda =
          solve_lambda(space, compact_system(part(s.points, basis, 7 - basis)));
      CHECK((space.at(lambda) - s.Q.coefficients()).norm() < 1e-6);
    }
  }
}

TEST_CASE("theorem 3: in one dimension λ is a quotient, and the position alone suffices",
          "[theorem][paper:theorem3]") {
  RandomStream random(26, 0);
  for (const CanonicalForm& form : curved_forms()) {
    CAPTURE(to_string(form.type));
    const Sampled s = sample_basis(form, 4, random);
    const SolutionSpace space = solution_space(compact_system(s.points.first(3)));
    REQUIRE(space.null_space.cols() == 1);
    const LinearSystem further = compact_system(part(s.points, 3, 1));
    const double lambda = solve_single_lambda(space, further);
    CHECK(lambda == Approx(solve_lambda(space, further)[0]).margin(1e-9));
    CHECK((space.at(Eigen::VectorXd::Constant(1, lambda)) - s.Q.coefficients()).norm() < 1e-6);
    const LinearSystem position{further.A.topRows(1), further.n.head(1)};
    CHECK(solve_single_lambda(space, position) == Approx(lambda).margin(1e-7));
  }
  const SolutionSpace wide =
      solution_space(compact_system(sample(ellipsoid(), 2, random, false).points));
  CHECK_THROWS_AS(
      solve_single_lambda(wide, LinearSystem{Eigen::MatrixXd(1, 10), Eigen::VectorXd(1)}),
      std::invalid_argument);
}

TEST_CASE("points of another surface vote for another λ", "[theorem][paper:theorem2]") {
  RandomStream random(27, 0);
  const Sampled s = sample_basis(ellipsoid(), 4, random);
  const SolutionSpace space = solution_space(compact_system(s.points.first(3)));
  OrientedPointsd outlier = part(s.points, 3, 1);
  const double inside = solve_single_lambda(space, compact_system(outlier));
  outlier.points *= 1.3;
  CHECK(std::abs(solve_single_lambda(space, compact_system(outlier)) - inside) > 1e-3);
}

TEST_CASE("the closed form spans the same line of solutions as the paper's null space",
          "[theorem][basis]") {
  RandomStream random(28, 0);
  for (const CanonicalForm& form : curved_forms()) {
    CAPTURE(to_string(form.type));
    const Sampled s = sample_basis(form, 3, random);
    const SolutionSpace space = solution_space(compact_system(s.points));
    const auto pencil = make_pencil({s.points.at(0), s.points.at(1), s.points.at(2)});
    const Vector10d mu = Quadric(Eigen::Matrix4d(pencil->plane * pencil->plane.transpose()))
                             .normalized()
                             .coefficients();
    CHECK(std::abs(mu.dot(space.null_space.col(0))) == Approx(1.0));
    // The particular solutions differ by a multiple of μ.
    const Vector10d gap = Quadric(pencil->Q0).coefficients() - space.p;
    CHECK((gap - mu * mu.dot(gap)).norm() < 1e-7 * (1.0 + gap.norm()));
  }
}

TEST_CASE("degenerate surfaces lose rank: coplanar, collinear and coincident points",
          "[theorem][degenerate]") {
  RandomStream random(29, 0);
  OrientedPointsd points(8);
  for (int i = 0; i < 8; ++i) {
    points.points.col(i) << random.uniform(), random.uniform(), 0.3;
    points.normals.col(i) << 0, 0, 1;
  }
  // The plane squared stays, whatever the number of points.
  CHECK(rank(compact_system(points).A) == 9);
  points.points.row(1).setConstant(0.5);
  // On a line, the three products of the two planes through it.
  CHECK(rank(compact_system(points).A) == 7);
  points.points.row(0).setConstant(0.1);
  CHECK(rank(compact_system(points).A) == 4);
}

TEST_CASE("type-specific designs leave the paper's dimensions for the vote",
          "[theorem][paper:fig2b]") {
  RandomStream random(30, 0);
  const auto dimensions = [](const Sampled& s, const Design& B, int basis) {
    const LinearSystem system = restricted(compact_system(s.points.first(basis)), B);
    return static_cast<int>(B.cols()) - rank(system.A);
  };
  const auto table = [](std::string_view type) {
    for (const VotingSpace& row : kVotingSpaces) {
      if (row.type == type) return row;
    }
    throw std::logic_error("no such row");
  };
  const Sampled sphere = sample(curved_forms()[0], 2, random, true);
  CHECK(dimensions(sphere, plane_design(), table("plane").basis) == table("plane").dimensions);
  CHECK(dimensions(sphere, sphere_design(), table("sphere").basis) == table("sphere").dimensions);
  CHECK(dimensions(sphere, Design::Identity(10, 10), table("spheroid").basis) ==
        table("spheroid").dimensions);
  const Sampled cylinder = sample(curved_forms()[2], 2, random, true);
  const Eigen::Vector3d u =
      cylinder.points.normals.col(0).cross(cylinder.points.normals.col(1)).normalized();
  CHECK(dimensions(cylinder, cylinder_design(u), table("cylinder").basis) ==
        table("cylinder").dimensions);
  const Sampled cone = sample(curved_forms()[4], 3, random, false);
  const CanonicalForm form = canonical_form(cone.Q, 1e-8);
  const Design B = cone_design(form.X.translation(), form.X.linear().col(2));
  CHECK(dimensions(cone, B, table("cone").basis) == table("cone").dimensions);
}
