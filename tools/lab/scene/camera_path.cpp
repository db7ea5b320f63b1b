#include "lab/scene/camera_path.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille::scene {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Tangent of 30 degrees, half of the angle to each side.
constexpr double kWidest = 0.57735026918962576;
/// Mean growth of the tangent of half the angle in a second. The least-jerk motion is 15/8 times as
/// fast at its middle: 43 degrees a second, at a distance of 0.7 m about 0.5 m/s.
constexpr double kSpeed = 0.2;
/// Growth of the tangent of half the elevation with that of half the angle; the camera rises by
/// some 8 degrees.
constexpr double kRise = 0.07;
/// Height of the target over the table [m].
constexpr double kTargetHeight = 0.04;

/// Returns cosine and sine of an angle from the tangent of its half.
Vector2d direction_of(double tangent) {
  const double square = tangent * tangent;
  return Vector2d(1.0 - square, 2.0 * tangent) / (1.0 + square);
}

/// Returns the place at which a motion from 0 to 1 with the least jerk, from rest to rest, is after
/// this share of its time (Flash and Hogan, J. Neuroscience 1985).
double least_jerk(double share) {
  const double s = std::clamp(share, 0.0, 1.0);
  return s * s * s * (10.0 + s * (6.0 * s - 15.0));
}

/// Returns the middle of the bodies that stand on the table.
Vector3d middle_of(const std::vector<Body>& bodies) {
  Vector3d sum = Vector3d::Zero();
  int count = 0;
  for (const Body& body : bodies) {
    // Table and wall have no footprint.
    if (body.reach <= 0.0) continue;
    sum += body.X_WB.translation();
    ++count;
  }
  return sum / std::max(count, 1) + kTargetHeight * Vector3d::UnitZ();
}

}  // namespace

CameraPath::CameraPath(const Layout& layout, double duration)
    : duration_(duration), target_(middle_of(layout.bodies)) {
  const Vector3d still = layout.X_CW.inverse().translation() - target_;
  const double level = still.head<2>().norm();
  distance_ = still.norm();
  heading_ = still.head<2>() / level;
  elevation_ = still.z() / (distance_ + level);
  side_ = std::min(kWidest, 0.5 * kSpeed * duration);
}

Eigen::Isometry3d CameraPath::pose_at(double time) const {
  const double tangent = side_ * (2.0 * least_jerk(time / duration_) - 1.0);
  const Vector2d turn = direction_of(tangent);
  const Vector2d elevation = direction_of(elevation_ + kRise * tangent);
  const Vector2d heading(turn.x() * heading_.x() - turn.y() * heading_.y(),
                         turn.y() * heading_.x() + turn.x() * heading_.y());
  Vector3d forward;
  forward << -elevation.x() * heading, -elevation.y();
  const Vector3d right(-heading.y(), heading.x(), 0.0);
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  X_WC.linear() << right, forward.cross(right), forward;
  X_WC.translation() = target_ - distance_ * forward;
  return X_WC;
}

}  // namespace quadrille::scene
