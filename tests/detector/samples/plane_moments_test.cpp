#include "samples/plane_moments.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "base/random.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using Eigen::Vector3d, Eigen::Vector3f;

namespace {

/// Points spread by so much along three axes that are turned anyhow, about a mean.
std::vector<Vector3f> cloud_of(RandomStream* random, const Vector3d& spread, const Vector3f& mean) {
  const auto uniform = [&] { return 2 * random->uniform() - 1; };
  const Eigen::Quaterniond turn =
      Eigen::Quaterniond(uniform(), uniform(), uniform(), uniform()).normalized();
  std::vector<Vector3f> points;
  for (int k = 0; k < 25; ++k) {
    const Vector3d x = spread.cwiseProduct(Vector3d(uniform(), uniform(), uniform()));
    points.push_back((turn * x).cast<float>() + mean);
  }
  return points;
}

PlaneMoments moments_of(const std::vector<Vector3f>& points) {
  PlaneMoments moments;
  for (const Vector3f& p : points) moments.add(p);
  return moments;
}

Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver_of(const std::vector<Vector3f>& points) {
  Vector3d mean = Vector3d::Zero();
  for (const Vector3f& p : points) mean += p.cast<double>() / static_cast<double>(points.size());
  Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
  for (const Vector3f& p : points) {
    const Vector3d d = p.cast<double>() - mean;
    S += d * d.transpose();
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(S);
}

}  // namespace

TEST_CASE("the normal is the direction of the least spread", "[plane_moments]") {
  RandomStream random(5, 0);
  for (const double thin : {0.0, 1e-3, 0.05, 0.3, 0.7}) {
    for (int k = 0; k < 200; ++k) {
      const std::vector<Vector3f> points =
          cloud_of(&random, 0.01 * Vector3d(1, 0.6, thin), Vector3f(0.002f, -0.001f, 0.003f));
      const auto truth = solver_of(points);
      const auto plane = moments_of(points).solve();
      REQUIRE(plane);
      CHECK(plane->normal.norm() == Approx(1.0f));
      // Compared by the spread, which two directions may share.
      const Vector3d v = truth.eigenvalues();
      const double c = std::abs(truth.eigenvectors().col(0).dot(plane->normal.cast<double>()));
      CHECK((1 - c * c) * (v[1] - v[0]) < 1e-5 * v[2]);
    }
  }
}

TEST_CASE("few points, a line and a ball have no normal", "[plane_moments][degenerate]") {
  RandomStream random(6, 0);
  CHECK_FALSE(PlaneMoments().solve());
  CHECK_FALSE(moments_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).solve());
  CHECK_FALSE(moments_of(std::vector<Vector3f>(9, {0.1f, 0.2f, 0.3f})).solve());
  CHECK_FALSE(
      moments_of({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}).solve());
  for (const double width : {0.0, 0.1, 0.2}) {
    const auto points = cloud_of(&random, 0.01 * Vector3d(1, width, 0), Vector3f::Zero());
    const Vector3d v = solver_of(points).eigenvalues();
    CHECK(moments_of(points).solve().has_value() == (v[1] > 0.05 * v[2]));
  }
}
