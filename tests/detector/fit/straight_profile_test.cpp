#include "fit/straight_profile.hpp"

#include <cmath>
#include <numbers>

#include "support/catch.hpp"

using namespace quadrille;

namespace {

constexpr double kConeRadius = 0.03, kConeSlope = -0.4;

/// A pose of an axis that leans, away from the origin.
Eigen::Isometry3d leaning_axis() {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, 0.5).normalized()).matrix();
  X.translation() = Eigen::Vector3d(0.2, -0.1, 0.8);
  return X;
}

/// Points of a cone about that axis, whose radius is kConeRadius at height 0, in local coordinates.
OrientedPointsf cone_points(const Normalisation& local) {
  constexpr int kRows = 9, kColumns = 20;
  OrientedPointsf points(kRows * kColumns);
  for (int i = 0; i < points.size(); ++i) {
    const double z = 0.004 * (i / kColumns), r = kConeRadius + kConeSlope * z;
    const double angle = 2.0 * std::numbers::pi * (i % kColumns) / kColumns;
    const Eigen::Vector3d p_C =
        leaning_axis() * Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), z);
    points.points.col(i) = ((p_C - local.centre) / local.scale).cast<float>();
  }
  return points;
}

}  // namespace

TEST_CASE("the line of a cone's profile has its slope and its radius", "[fit][profile]") {
  const Normalisation local{Eigen::Vector3d(0.2, -0.1, 0.82), 0.035};
  const ProfileLine line = profile_line(cone_points(local), local, leaning_axis());
  CHECK(std::abs(line.slope - kConeSlope) < 1e-5);
  CHECK(std::abs(local.scale * line.z - 0.016) < 1e-6);
  CHECK(std::abs(local.scale * line.r - (kConeRadius + kConeSlope * 0.016)) < 1e-6);
}

TEST_CASE("the cone and the cylinder of a line pass through it", "[fit][profile]") {
  const Normalisation local{Eigen::Vector3d(0.2, -0.1, 0.82), 0.035};
  const OrientedPointsf points = cone_points(local);
  const ProfileLine line = profile_line(points, local, leaning_axis());
  const Quadric cone(straight_quadric(Family::kCone, line, line.slope).matrix());
  for (int i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d p = points.points.col(i).cast<double>();
    CHECK(std::abs(cone.value(p)) < 1e-5 * cone.gradient(p).norm());
  }
  const Quadric cylinder(straight_quadric(Family::kCylinder, line, 0.0).matrix());
  const Eigen::Vector3d on_it = line.X * Eigen::Vector3d(0.0, line.r, 1.7);
  CHECK(std::abs(cylinder.value(on_it)) < 1e-9 * cylinder.gradient(on_it).norm());
}

TEST_CASE("a cone has a slope even where its line has none", "[fit][profile]") {
  const ProfileLine level{Eigen::Isometry3d::Identity(), 0.5, 1.0, 0.0};
  const Quadric cone(straight_quadric(Family::kCone, level, 0.0).matrix());
  const Eigen::Vector3d middle(1.0, 0.0, 0.5);
  CHECK(std::abs(cone.value(middle)) < 1e-9 * cone.gradient(middle).norm());
  const Eigen::Vector3d n = cone.gradient(middle).normalized();
  CHECK(std::abs(std::abs(n.z()) - 0.01) < 1e-4);
}
