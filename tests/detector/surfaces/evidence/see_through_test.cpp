#include "surfaces/evidence/see_through.hpp"

#include <cmath>
#include <limits>

#include "support/catch.hpp"
#include "support/surface_grid.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kRadius = 0.04;
// The eye lies this far along x from the origin, and the wall this far behind it.
constexpr double kDistance = 1.0, kWallBehind = 0.3;

/// What an eye on the x axis sees that looks at the origin, per ray from it.
/// @param depth  depth along the view for the tangents (u, v): along y and z
template <class Depth>
SceneContext seen_from_x(Depth&& depth) {
  SceneContext s;
  s.sights.resize(1);
  Eigen::Matrix3d R_CV;  // columns: u along y, v along z, into the scene along -x
  R_CV << 0, 0, -1, 1, 0, 0, 0, -1, 0;
  Eigen::Isometry3d X_CV = Eigen::Isometry3d::Identity();
  X_CV.linear() = R_CV;
  X_CV.translation() = Eigen::Vector3d(kDistance, 0, 0);
  s.sights[0].X_VC = X_CV.inverse().cast<float>();
  s.sights[0].step = 0.002f;
  s.sights[0].width = s.sights[0].height = 120;
  s.sights[0].corner = {-0.12f, -0.12f};
  for (int j = 0; j < s.sights[0].height; ++j) {
    for (int i = 0; i < s.sights[0].width; ++i) {
      const double u = -0.12 + (i + 0.5) * 0.002, v = -0.12 + (j + 0.5) * 0.002;
      s.sights[0].w.push_back(static_cast<float>(1.0 / depth(u, v)));
    }
  }
  return s;
}

/// Depth of the near side of the ball along a ray, infinite where it misses.
double depth_of_ball(double u, double v) {
  const double n = 1 + u * u + v * v;
  const double root = kDistance * kDistance - n * (kDistance * kDistance - kRadius * kRadius);
  return root < 0 ? std::numeric_limits<double>::infinity() : (kDistance - std::sqrt(root)) / n;
}

double share_of_ball(const SceneContext& s) {
  // Nearly all of the half that faces the eye.
  const SurfaceSamples samples = sphere_grid(31, 31, kRadius, 0.004, 0.0, 1);
  const Quadric Q(diagonal(1, 1, 1, -kRadius * kRadius));
  return see_through(s, samples, all_of(samples), Q, canonical_form(Q));
}

/// What the eye sees when it looks past the origin, turned about z.
/// @param turn   angle between its axis and the origin [rad]
/// @param range  distance from the eye for the angle between a ray and the origin's direction
template <class Range>
SceneContext seen_past(double turn, Range&& range) {
  SceneContext s = seen_from_x([](double, double) { return 1.0; });
  const Eigen::AngleAxisd R_VC(turn, Eigen::Vector3d::UnitY());
  s.sights[0].X_VC = (R_VC * s.sights[0].X_VC.cast<double>()).cast<float>();
  s.sights[0].corner.x() += static_cast<float>(std::tan(turn));
  s.sights[0].w.clear();
  const Eigen::Vector3d to_origin = R_VC * Eigen::Vector3d::UnitZ();
  for (int j = 0; j < s.sights[0].height; ++j) {
    for (int i = 0; i < s.sights[0].width; ++i) {
      const Eigen::Vector3d ray(s.sights[0].corner.x() + (i + 0.5) * 0.002,
                                s.sights[0].corner.y() + (j + 0.5) * 0.002, 1.0);
      const double angle = std::acos(ray.dot(to_origin) / ray.norm());
      s.sights[0].w.push_back(static_cast<float>(ray.norm() / range(angle)));
    }
  }
  return s;
}

}  // namespace

TEST_CASE("through a ball that is there nothing is seen", "[evidence][see_through]") {
  const auto ball = [](double u, double v) {
    return std::min(depth_of_ball(u, v), kDistance + kWallBehind);
  };
  CHECK(share_of_ball(seen_from_x(ball)) == 0.0);
}

TEST_CASE("what should hide a wall and does not is seen through", "[evidence][see_through]") {
  const auto wall = [](double, double) { return kDistance + kWallBehind; };
  CHECK(share_of_ball(seen_from_x(wall)) == 1.0);
  // A cap of 30° is there. Of the disc, rays count that meet the ball at a cosine of .35 and more:
  // 1 - .35² of its area, of which the cap hides sin² 30°; they are some ninety.
  const auto cap = [](double u, double v) {
    const double z = depth_of_ball(u, v);
    const bool within = std::hypot(z * u, z * v) < 0.5 * kRadius;
    return within ? z : kDistance + kWallBehind;
  };
  const double disc = 1.0 - 0.35 * 0.35;
  CHECK(share_of_ball(seen_from_x(cap)) == Approx((disc - 0.25) / disc).margin(0.06));
}

TEST_CASE("beside the eye's axis as much is seen through as on it", "[evidence][see_through]") {
  // A smaller ball, of which some lies within the tolerance.
  const auto smaller = [](double angle) {
    const double root = std::pow(0.91 * kRadius, 2) - std::pow(kDistance * std::sin(angle), 2);
    return root < 0 ? kDistance + kWallBehind : kDistance * std::cos(angle) - std::sqrt(root);
  };
  const double ahead = share_of_ball(seen_past(0.0, smaller));
  CHECK(ahead > 0.2);
  CHECK(ahead < 0.8);
  for (const double turn : {0.3, 0.6, 0.75}) {
    CAPTURE(turn);
    CHECK(share_of_ball(seen_past(turn, smaller)) == Approx(ahead).margin(0.05));
  }
}

TEST_CASE("without up, turning everything changes nothing", "[evidence][see_through]") {
  // A cap of a ball of which the rest is not there.
  const SurfaceSamples samples = sphere_grid(15, 15, kRadius, 0.002, 0.0, 1);
  const Quadric Q(diagonal(1, 1, 1, -kRadius * kRadius));
  const SceneContext s = seen_from_x([](double, double) { return kDistance + kWallBehind; });
  const double share = see_through(s, samples, all_of(samples), Q, canonical_form(Q));
  for (const double angle : {0.4, 0.8, 1.2}) {
    const Eigen::AngleAxisd R(angle, Eigen::Vector3d(1, 2, 3).normalized());
    SceneContext turned = s;
    turned.sights[0].X_VC = (s.sights[0].X_VC.cast<double>() * R.inverse()).cast<float>();
    SurfaceSamples there = samples;
    for (Eigen::Vector3f& p : there.raw) p = (R * p.cast<double>()).cast<float>();
    for (Eigen::Vector3f& n : there.n) n = (R * n.cast<double>()).cast<float>();
    CAPTURE(angle);
    CHECK(see_through(turned, there, all_of(there), Q, canonical_form(Q)) ==
          Approx(share).margin(1e-6));
  }
}

TEST_CASE("what stands before a surface does not speak against it", "[evidence][see_through]") {
  const auto curtain = [](double, double) { return 0.5 * kDistance; };
  CHECK(share_of_ball(seen_from_x(curtain)) == 0.0);
}

TEST_CASE("a pipe reaches no farther along its axis than its region", "[evidence][see_through]") {
  // Of a pipe along z, five centimetres up and down; a wall above and below.
  const SurfaceSamples samples = cylinder_grid(25, 26, kRadius, 0.004, 0.0, 1);
  const auto pipe = [](double u, double v) {
    const double n = 1 + u * u;
    const double root = kDistance * kDistance - n * (kDistance * kDistance - kRadius * kRadius);
    const double z = root < 0 ? 10.0 : (kDistance - std::sqrt(root)) / n;
    return std::abs(z * v) < 0.05 ? z : kDistance + kWallBehind;
  };
  const Quadric Q(diagonal(1, 1, 0, -kRadius * kRadius));
  const auto share = [&](const SceneContext& s) {
    return see_through(s, samples, all_of(samples), Q, canonical_form(Q));
  };
  CHECK(share(seen_from_x(pipe)) == Approx(0.0).margin(0.02));
  const auto wall = [](double, double) { return kDistance + kWallBehind; };
  CHECK(share(seen_from_x(wall)) == 1.0);
}

TEST_CASE("without rays it is unknown whether something is seen through",
          "[evidence][see_through]") {
  SceneContext blind;
  CHECK(share_of_ball(blind) == kUnknownShare);
  blind.sights.resize(2);
  CHECK(share_of_ball(blind) == kUnknownShare);
  // One view with rays knows enough, even if all of them pass beside the ball.
  SceneContext elsewhere = seen_from_x([](double, double) { return kDistance; });
  elsewhere.sights[0].corner = {1.0f, 1.0f};
  CHECK(share_of_ball(elsewhere) == 0.0);
}
