#include "lab/scene/bin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "lab/scene/bodies.hpp"
#include "lab/scene/segment.hpp"

namespace quadrille::scene {
namespace {

using Eigen::Vector3d;

constexpr int kPoses = 80;
/// Sine of the steepest inclination of an axis.
constexpr double kSteepest = 0.6;
/// Two cylinders touch if they are nearer than this [m].
constexpr double kTouch = 5e-4;

/// Returns a random axis about the origin.
Vector3d random_axis(Random* random) {
  const Eigen::Vector2d heading = random->direction();
  const double sine = random->uniform(-kSteepest, kSteepest);
  Vector3d axis;
  axis << std::sqrt(1.0 - sine * sine) * heading, sine;
  return axis;
}

/// Lets an axis fall from above until it touches the floor or another one.
Segment fallen(Segment axis, const std::vector<Segment>& others, const BinOptions& options) {
  const Vector3d along = (axis.b - axis.a).normalized();
  // The rim of the lower end is the first part to touch the floor.
  const double rim = options.radius * along.head<2>().norm();
  double top = 0.0;
  for (const Segment& other : others) top = std::max({top, other.a.z(), other.b.z()});
  const auto lower = [&](double by) { axis.a.z() -= by, axis.b.z() -= by; };
  lower(std::min(axis.a.z(), axis.b.z()) - (top + 2.0 * options.radius + options.length));
  while (true) {
    const double floor = std::min(axis.a.z(), axis.b.z()) - rim;
    double gap = floor;
    for (const Segment& other : others) {
      gap = std::min(gap, distance(axis, other) - 2.0 * options.radius);
    }
    if (gap < kTouch) return axis;
    // No distance shrinks by more than the length of the fall.
    lower(gap - 0.5 * kTouch);
  }
}

/// Returns the lowest of several random poses that lie within the walls.
std::optional<Segment> lowest(const std::vector<Segment>& others, const BinOptions& options,
                              Random* random) {
  std::optional<Segment> best;
  for (int pose = 0; pose < kPoses; ++pose) {
    const Vector3d half = 0.5 * options.length * random_axis(random);
    const Eigen::Vector2d room = Eigen::Vector2d(options.half_x, options.half_y).array() -
                                 options.radius - half.head<2>().cwiseAbs().array();
    const double x = random->uniform(-1.0, 1.0), y = random->uniform(-1.0, 1.0);
    if (room.minCoeff() < 0.0) continue;
    const Vector3d centre(x * room.x(), y * room.y(), 0.0);
    const Segment axis = fallen({centre - half, centre + half}, others, options);
    if (!best || (axis.a + axis.b).z() < (best->a + best->b).z()) best = axis;
  }
  return best;
}

/// Returns the pose of a standing cylinder's frame B that places its axis along the segment.
Eigen::Isometry3d pose_on(const Segment& axis) {
  const Vector3d z = (axis.b - axis.a).normalized();
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  // The axis is never vertical.
  X.linear().col(0) = Vector3d(-z.y(), z.x(), 0.0).normalized();
  X.linear().col(1) = z.cross(X.linear().col(0));
  X.linear().col(2) = z;
  X.translation() = axis.a;
  return X;
}

Eigen::Isometry3d camera_pose(const BinOptions& options, Random* random) {
  const Vector3d forward =
      -Vector3d(0.0, random->uniform(-0.25, 0.25) * options.height, options.height).normalized();
  const Vector3d right(1, 0, 0);
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  X_WC.linear() << right, forward.cross(right), forward;
  X_WC.translation() = -options.height / -forward.z() * forward;
  return X_WC.inverse();
}

}  // namespace

Layout fill_bin(const BinOptions& options, Random* random) {
  if (std::min(options.half_x, options.half_y) <
      options.radius + 0.5 * options.length * std::sqrt(1.0 - kSteepest * kSteepest)) {
    throw std::invalid_argument("the tray has no room for a cylinder in each direction");
  }
  Layout layout;
  layout.bodies = {make_table(0.6, 0.5), make_tray(options.half_x, options.half_y, options.wall)};
  layout.X_CW = camera_pose(options, random);
  std::vector<Segment> axes;
  for (int i = 0; i < options.cylinders; ++i) {
    const std::optional<Segment> axis = lowest(axes, options, random);
    if (!axis) continue;
    axes.push_back(*axis);
    layout.bodies.push_back(make_cylinder(options.radius, options.length));
    layout.bodies.back().X_WB = pose_on(*axis);
  }
  return layout;
}

}  // namespace quadrille::scene
