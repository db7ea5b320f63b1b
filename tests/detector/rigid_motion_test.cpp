#include <cmath>

#include "base/random.hpp"
#include "quadrille/detector/detection.hpp"
#include "support/catch.hpp"
#include "support/quadric_points.hpp"

using namespace quadrille;

TEST_CASE("a moved cloud has its points and its viewpoint moved", "[frames]") {
  RandomStream random(3, 0);
  const Eigen::Isometry3d X_FC = test::random_pose(random, 2.0);
  PointCloud cloud;
  cloud.frame = "base";
  cloud.points = {{0.5f, 0.25f, 1.0f}, Eigen::Vector3f::Constant(std::nanf(""))};
  cloud.viewpoint = {0.1, 0.2, 0.3};
  const PointCloud there = moved(cloud, X_FC);
  CHECK((there.points[0].cast<double>() - X_FC * Eigen::Vector3d(0.5, 0.25, 1.0)).norm() < 1e-6);
  CHECK_FALSE(there.points[1].allFinite());
  CHECK((there.viewpoint - X_FC * cloud.viewpoint).norm() < 1e-15);
  CHECK(there.frame == "base");
  CHECK(moved(cloud, Eigen::Isometry3d::Identity()).points[0] == cloud.points[0]);
}

TEST_CASE("a moved detection holds the moved points, and its pose moves with it", "[frames]") {
  RandomStream random(4, 0);
  Detection d;
  d.X_CQ = test::random_pose(random, 0.5);
  // x² + y² = 0.04² in frame Q.
  Vector10d q = Vector10d::Zero();
  q << 1, 1, 0, 0, 0, 0, 0, 0, 0, -0.0016;
  d.Q_C = Quadric(q).transformed(d.X_CQ).normalized();
  const Eigen::Isometry3d X_FC = test::random_pose(random, 2.0);
  const Detection there = moved(d, X_FC);
  const Eigen::Vector3d p_C = d.X_CQ * Eigen::Vector3d(0.024, 0.032, 0.3);
  CHECK(std::abs(d.Q_C.distance(p_C)) < 1e-12);
  CHECK(std::abs(there.Q_C.distance(X_FC * p_C)) < 1e-12);
  CHECK(there.Q_C.coefficients().norm() == Approx(1.0));
  CHECK((there.X_CQ.matrix() - (X_FC * d.X_CQ).matrix()).norm() < 1e-12);
  CHECK(moved(d, Eigen::Isometry3d::Identity()).Q_C.coefficients() == d.Q_C.coefficients());
}

TEST_CASE("a covariance moves as the quadrics do that it is made of", "[frames]") {
  RandomStream random(5, 0);
  const Eigen::Isometry3d X_FC = test::random_pose(random, 2.0);
  const auto unit = [&] {
    Vector10d v;
    for (int k = 0; k < 10; ++k) v[k] = 2.0 * random.uniform() - 1.0;
    return Vector10d(v.normalized());
  };
  Detection d;
  const Vector10d q = unit();
  d.Q_C = Quadric(q);
  const auto across = [&] {
    const Vector10d v = unit();
    return Vector10d((v - v.dot(q) * q).normalized());
  };
  const Vector10d known = across(), open = across();
  d.covariance.known = known * known.transpose();
  d.covariance.open = open;
  const Detection there = moved(d, X_FC);
  // How far the moved unit vector goes when q does, to first order.
  const auto moved_step = [&](const Vector10d& step) {
    constexpr double kStep = 1e-6;
    const auto at = [&](double h) {
      return Quadric(Vector10d(q + h * step)).transformed(X_FC).normalized().coefficients();
    };
    return Vector10d((at(kStep) - at(-kStep)) / (2.0 * kStep));
  };
  const Vector10d step = moved_step(known);
  CHECK((there.covariance.known - step * step.transpose()).norm() < 1e-6 * step.squaredNorm());
  REQUIRE(there.covariance.open.cols() == 1);
  CHECK(std::abs(there.covariance.open.col(0).dot(moved_step(open).normalized())) ==
        Approx(1.0).epsilon(1e-6));
}
