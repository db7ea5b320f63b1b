#include "lab/scene/camera_path.hpp"

#include <cmath>
#include <numbers>

#include "lab/scene/scene.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::scene;
using Eigen::Vector3d;

namespace {

constexpr double kLong = 10.0;

Layout layout_of(std::uint64_t seed) { return make_layout({scene::Family::kTabletop, seed}); }

/// The camera's place as seen from the target.
Vector3d offset(const CameraPath& path, double time) {
  return path.pose_at(time).translation() - path.target();
}

/// Signed angle about the vertical from one offset to another [degrees].
double turn_between(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y()) * 180.0 /
         std::numbers::pi;
}

double elevation(const Vector3d& v) {
  return std::atan2(v.z(), v.head<2>().norm()) * 180.0 / std::numbers::pi;
}

double speed(const CameraPath& path, double time) {
  constexpr double kStep = 1e-4;
  return (offset(path, time + kStep) - offset(path, time - kStep)).norm() / (2.0 * kStep);
}

}  // namespace

TEST_CASE("the camera looks at the middle of the bodies from one distance, with level rows",
          "[scene][path]") {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Layout layout = layout_of(seed);
    const CameraPath path(layout, kLong);
    const Vector3d still = layout.X_CW.inverse().translation();
    for (double time = -1.0; time < kLong + 1.0; time += 0.3) {
      const Eigen::Isometry3d X_WC = path.pose_at(time);
      CHECK((X_WC.linear().transpose() * X_WC.linear()).isIdentity(1e-12));
      CHECK(X_WC.linear().determinant() == Approx(1.0));
      const Vector3d target_C = X_WC.inverse() * path.target();
      CHECK(target_C.head<2>().norm() < 1e-12);
      CHECK(target_C.z() == Approx((still - path.target()).norm()));
      CHECK(X_WC.linear()(2, 0) == 0.0);
      // Down in the image is down in the scene.
      CHECK(X_WC.linear()(2, 1) < 0.0);
    }
  }
}

TEST_CASE("in enough time the camera turns by 60 degrees to each side of the still one, and rises",
          "[scene][path]") {
  const Layout layout = layout_of(4);
  const CameraPath path(layout, kLong);
  const Vector3d still = layout.X_CW.inverse().translation() - path.target();
  const Vector3d first = offset(path, 0.0), last = offset(path, kLong);
  CHECK(offset(path, 0.5 * kLong).isApprox(still, 1e-9));
  CHECK(turn_between(still, first) == Approx(-60.0));
  CHECK(turn_between(still, last) == Approx(60.0));
  CHECK(elevation(last) - elevation(first) > 5.0);
  CHECK(elevation(last) - elevation(first) < 10.0);
}

TEST_CASE("the camera moves with the least jerk from rest to rest", "[scene][path]") {
  const CameraPath path(layout_of(4), kLong);
  const Vector3d middle = offset(path, 0.5 * kLong);
  const auto half_tangent = [&](double time) {
    return std::tan(turn_between(middle, offset(path, time)) * std::numbers::pi / 360.0);
  };
  // 10 s³ - 15 s⁴ + 6 s⁵ is 53/512 at a quarter of the time.
  const double side = std::tan(std::numbers::pi / 6.0);
  CHECK(half_tangent(0.25 * kLong) == Approx(side * (2.0 * 53.0 / 512.0 - 1.0)));
  CHECK(half_tangent(0.75 * kLong) == Approx(side * (1.0 - 2.0 * 53.0 / 512.0)));
  CHECK(speed(path, 0.0) < 1e-6);
  CHECK(speed(path, kLong) < 1e-6);
  CHECK(path.pose_at(-1.0).isApprox(path.pose_at(0.0)));
  CHECK(path.pose_at(kLong + 1.0).isApprox(path.pose_at(kLong)));
}

TEST_CASE("in little time the camera goes less far, and is never fast", "[scene][path]") {
  for (const double duration : {0.05, 1.0, 4.0, kLong}) {
    const CameraPath path(layout_of(5), duration);
    double fastest = 0.0;
    for (int i = 0; i <= 100; ++i) fastest = std::max(fastest, speed(path, 0.01 * i * duration));
    CAPTURE(duration);
    CHECK(fastest < 0.6);
    CHECK(fastest > 0.2);
  }
  const CameraPath path(layout_of(5), 1.0);
  // The tangent of half the angle grows by 0.2 in a second.
  CHECK(turn_between(offset(path, 0.0), offset(path, 1.0)) ==
        Approx(4.0 * std::atan(0.1) * 180.0 / std::numbers::pi));
}
