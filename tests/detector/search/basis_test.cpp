#include "search/basis.hpp"

#include <vector>

#include "detector/fits/examples.hpp"
#include "quadrille/detector/quadric.hpp"
#include "support/catch.hpp"
#include "support/quadric_points.hpp"

using quadrille::CanonicalForm;
using quadrille::from_canonical;
using quadrille::inconsistency;
using quadrille::make_pencil;
using quadrille::OrientedPoint;
using quadrille::Pencil;
using quadrille::Quadric;
using quadrille::RandomStream;
using quadrille::test::curved_forms;
using quadrille::test::difference;
using quadrille::test::points_on;
using quadrille::test::random_pose;

namespace {

struct Trial {
  Quadric Q;
  std::array<OrientedPoint, 3> basis;
  Pencil pencil;
  /// One more point of the quadric, off the data plane.
  Eigen::Vector3d fourth;
};

/// Three points of a quadric in a random pose, with its full gradients as normals: data of one
/// common gradient scale.
Trial make_trial(const CanonicalForm& form, RandomStream& random) {
  Trial trial;
  const Eigen::Isometry3d X = random_pose(random, 0.5);
  const Quadric Q_B = from_canonical(form);
  trial.Q = Q_B.transformed(X);
  while (true) {
    const auto points = points_on(Q_B.matrix(), 4, -1e3, random);
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3d x = X * points[i].x;
      trial.basis[i] = {x, trial.Q.gradient(x)};
    }
    trial.fourth = X * points[3].x;
    const auto pencil = make_pencil(trial.basis);
    if (!pencil || std::abs(pencil->plane.dot(trial.fourth.homogeneous())) < 0.05) continue;
    trial.pencil = *pencil;
    return trial;
  }
}

}  // namespace

TEST_CASE("a quadric of any type is recovered from three oriented points and one position",
          "[basis][law][paper:theorem3]") {
  RandomStream random(11, 0);
  for (const CanonicalForm& form : curved_forms()) {
    CAPTURE(to_string(form.type));
    for (int k = 0; k < 20; ++k) {
      const Trial trial = make_trial(form, random);
      const Eigen::Vector4d x = trial.fourth.homogeneous();
      const double z = trial.pencil.plane.dot(x);
      const double lambda = -x.dot(trial.pencil.Q0 * x) / (z * z);
      CHECK(difference(trial.pencil.at(lambda), trial.Q.matrix()) < 1e-6);
    }
  }
}

TEST_CASE("each quadric of the pencil passes through the three points with their gradients",
          "[basis][paper:theorem1]") {
  RandomStream random(12, 0);
  for (const CanonicalForm& form : curved_forms()) {
    const Trial trial = make_trial(form, random);
    for (const double lambda : {-75.0, -3.0, 0.0, 0.7, 75.0}) {
      const Quadric Q(trial.pencil.at(lambda));
      for (const OrientedPoint& point : trial.basis) {
        CHECK(std::abs(Q.value(point.x)) < 1e-10);
        CHECK((Q.gradient(point.x) - point.n).norm() < 1e-9);
      }
    }
  }
}

TEST_CASE("the data plane squared is the free direction of the pencil and vanishes there",
          "[basis][paper:theorem1]") {
  RandomStream random(13, 0);
  const Trial trial = make_trial(curved_forms()[1], random);
  const Eigen::Matrix4d direction = trial.pencil.at(2.5) - trial.pencil.at(1.5);
  CHECK(direction.isApprox(trial.pencil.plane * trial.pencil.plane.transpose(), 1e-12));
  CHECK(trial.pencil.plane.head<3>().norm() == Approx(1.0));
  const Quadric squared(direction);
  for (const OrientedPoint& point : trial.basis) {
    CHECK(std::abs(squared.value(point.x)) < 1e-12);
    CHECK(squared.gradient(point.x).norm() < 1e-12);
  }
}

TEST_CASE("three unit normals of one quadric of any type are consistent", "[basis]") {
  RandomStream random(14, 0);
  for (const CanonicalForm& form : curved_forms()) {
    CAPTURE(to_string(form.type));
    for (int k = 0; k < 20; ++k) {
      Trial trial = make_trial(form, random);
      bool same_plane = false;
      for (int i = 0; i < 3; ++i) {
        const OrientedPoint &a = trial.basis[i], &b = trial.basis[(i + 1) % 3];
        same_plane |= std::abs(a.n.normalized().dot(b.x - a.x)) < 1e-3;
      }
      if (same_plane) continue;  // rulings: both products vanish and only rounding is left
      for (OrientedPoint& point : trial.basis) point.n.normalize();
      CHECK(inconsistency(trial.basis) < 1e-6);
    }
  }
}

TEST_CASE("a tilted normal makes three points inconsistent by the closed form", "[basis]") {
  // On the unit sphere b_ij = b_ji = cos − 1; the first normal is tilted towards the second point.
  std::array<OrientedPoint, 3> basis;
  for (int i = 0; i < 3; ++i) basis[i] = {Eigen::Vector3d::Unit(i), Eigen::Vector3d::Unit(i)};
  CHECK(inconsistency(basis) < 1e-12);
  const double tilt = 0.3;
  basis[0].n = {std::cos(tilt), std::sin(tilt), 0.0};
  // b₁₂ = sin − cos, b₁₃ = −cos, all others −1.
  const double one = std::sin(tilt) - std::cos(tilt), other = -std::cos(tilt);
  const double expected = std::abs(one - other) / (std::abs(one) + std::abs(other));
  CHECK(inconsistency(basis) == Approx(expected));
}

TEST_CASE("collinear and coincident points span no pencil", "[basis][degenerate]") {
  const Eigen::Vector3d n = Eigen::Vector3d::UnitZ();
  const auto basis = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                         const Eigen::Vector3d& c) {
    return std::array<OrientedPoint, 3>{{{a, n}, {b, n}, {c, n}}};
  };
  CHECK_FALSE(make_pencil(basis({0, 0, 0}, {1, 1, 1}, {2, 2, 2})));
  CHECK_FALSE(make_pencil(basis({0, 0, 0}, {1, 0, 0}, {2, 0.01, 0})));
  CHECK_FALSE(make_pencil(basis({1, 2, 3}, {1, 2, 3}, {1, 2, 3})));
  CHECK_FALSE(make_pencil(basis({1, 2, 3}, {1, 2, 3}, {4, 2, 3})));
  CHECK_FALSE(make_pencil(basis({NAN, 2, 3}, {1, 2, 3}, {4, 2, 3})));
  CHECK(make_pencil(basis({0, 0, 0}, {1, 0, 0}, {0, 1, 0})));
}
