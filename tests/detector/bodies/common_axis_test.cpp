#include "bodies/common_axis.hpp"

#include <cmath>
#include <vector>

#include "support/catch.hpp"
#include "support/surface_grid.hpp"
#include "surfaces/measure.hpp"
#include "surfaces/surface_fit.hpp"

namespace quadrille {
namespace {

constexpr double kWallCell = 0.004, kWallNoise = 0.0008;
const Eigen::Vector3d kWallEye(1.0, 0.0, 0.0);

/// A wall about z, placed by X_CW, with its last fit and as it is measured.
struct RoundWall {
  SurfaceSamples samples;
  LastFit fit;
  Detection detection;
};

RoundWall wall(const Eigen::Isometry3d& X_CW, double radius, int columns, int rows,
               std::uint64_t seed, double noise = kWallNoise) {
  RoundWall result;
  result.samples = test::cylinder_grid(columns, rows, radius, kWallCell, noise, seed);
  const Eigen::Isometry3f X = X_CW.cast<float>();
  for (int i = 0; i < result.samples.size(); ++i) {
    result.samples.p[i] = X * result.samples.p[i];
    result.samples.raw[i] = X * result.samples.raw[i];
    result.samples.n[i] = X.linear() * result.samples.n[i];
  }
  AggregateOptions only_round;
  only_round.families = {Family::kCylinder};
  const auto surface = fit_surface(result.samples, test::all_of(result.samples), only_round);
  REQUIRE(surface);
  const std::vector<Eigen::Matrix3f> scatter(result.samples.p.size(), Eigen::Matrix3f::Zero());
  result.fit = last_fit(*surface, result.samples, scatter, {});
  REQUIRE(result.fit.surface.fit.family == Family::kCylinder);
  result.fit.surface.evidence.sigma = kWallNoise;
  result.detection = measure(result.fit.surface, result.samples, kWallEye);
  return result;
}

/// Refits walls about common axes where they have any, and measures them again.
/// @return the number of walls that were refitted
std::size_t refit(std::vector<RoundWall>* walls) {
  std::vector<Detection> detections;
  std::vector<LastFit> fits;
  for (const RoundWall& w : *walls) {
    detections.push_back(w.detection);
    fits.push_back(w.fit);
  }
  std::size_t changed = 0;
  for (const CommonAxis& axis : fit_common_axes(detections, &fits)) {
    for (const int k : axis.members) {
      RoundWall& w = (*walls)[k];
      w.fit = fits[k];
      w.detection = measure(w.fit.surface, w.samples, kWallEye);
    }
    changed += axis.members.size();
  }
  return changed;
}

/// Sine of the angle between a wall's axis and a direction.
double skew(const RoundWall& wall, const Eigen::Vector3d& z_C) {
  return wall.detection.X_CQ.linear().col(2).cross(z_C).norm();
}

Eigen::Isometry3d at(double height, double tilt = 0.0) {
  return test::translation(0.0, 0.0, height) *
         Eigen::Isometry3d(Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitY()));
}

TEST_CASE("body and neck of a bottle get one axis, of which the neck alone says little",
          "[bodies]") {
  double alone = 0.0, joint = 0.0, std_alone = 0.0, std_joint = 0.0;
  constexpr int kRounds = 20;
  int joined = 0;
  for (int k = 0; k < kRounds; ++k) {
    std::vector<RoundWall> bottle = {wall(at(0.0), 0.035, 20, 25, 2 * k + 1),
                                     wall(at(0.075), 0.015, 9, 7, 2 * k + 2)};
    const double before = skew(bottle[1], Eigen::Vector3d::UnitZ());
    const double std_before = bottle[1].detection.dimensions[0].std;
    if (refit(&bottle) != 2) continue;
    ++joined;
    alone += before / kRounds;
    joint += skew(bottle[1], Eigen::Vector3d::UnitZ()) / kRounds;
    std_alone += std_before / kRounds;
    std_joint += bottle[1].detection.dimensions[0].std / kRounds;
    CHECK(skew(bottle[0], bottle[1].detection.X_CQ.linear().col(2)) < 1e-6);
    CHECK(bottle[0].detection.dimensions[0].value == Approx(0.035).margin(0.002));
    CHECK(bottle[1].detection.dimensions[0].value == Approx(0.015).margin(0.002));
  }
  CHECK(joined >= 18);
  CHECK(alone > 0.0);
  CHECK(joint < 0.3 * alone);
  CHECK(std_joint < std_alone);
}

TEST_CASE("a part that leans keeps its own fit, and the others share an axis", "[bodies]") {
  // 6° are less than share_axis() allows, but more than chance explains.
  std::vector<RoundWall> walls = {wall(at(0.0), 0.04, 22, 25, 1),
                                  wall(at(0.0, 0.1), 0.036, 20, 25, 2)};
  const Quadric before = walls[1].fit.surface.Q;
  CHECK(refit(&walls) == 0);
  CHECK(walls[1].fit.surface.Q.coefficients() == before.coefficients());

  walls.push_back(wall(at(0.11), 0.04, 22, 25, 3));
  CHECK(refit(&walls) == 2);
  CHECK(walls[1].fit.surface.Q.coefficients() == before.coefficients());
  CHECK(skew(walls[0], walls[2].detection.X_CQ.linear().col(2)) < 1e-6);
}

TEST_CASE("exact walls about one axis keep their radii", "[bodies]") {
  std::vector<RoundWall> walls = {wall(at(0.0), 0.04, 22, 25, 1, 0.0),
                                  wall(at(0.09), 0.02, 12, 15, 2, 0.0)};
  refit(&walls);
  CHECK(walls[0].detection.dimensions[0].value == Approx(0.04).epsilon(1e-4));
  CHECK(walls[1].detection.dimensions[0].value == Approx(0.02).epsilon(1e-4));
}

TEST_CASE("a wall alone and walls side by side keep their fits", "[bodies]") {
  std::vector<RoundWall> walls = {wall(at(0.0), 0.04, 22, 25, 1)};
  CHECK(refit(&walls) == 0);
  walls.push_back(wall(test::translation(0.0, 0.09, 0.0), 0.04, 22, 25, 2));
  CHECK(refit(&walls) == 0);
}

}  // namespace
}  // namespace quadrille
