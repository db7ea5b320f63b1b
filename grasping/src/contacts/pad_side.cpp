#include "contacts/pad_side.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille {
namespace {

// The strip along the borders of a pad in which a slope would show, and how far the points in it
// may lie outside of the others [m]: on a slope of 14° they lie as far.
constexpr double kBorder = 0.004, kWidening = 0.001;

}  // namespace

PadSide pad_side(std::span<const BetweenPads> points, double sign, double x, double tip,
                 const Gripper& gripper) {
  const double y = sign > 0.0 ? points.back().p_G.y() : points.front().p_G.y();
  Eigen::Vector3d near = Eigen::Vector3d::Zero(), normals = near;
  double within = std::numeric_limits<double>::infinity(), at_border = within;
  double top = tip, bottom = std::numeric_limits<double>::lowest();
  FacingCount facing;
  PadSide side;
  for (const BetweenPads& point : points) {
    const double inward = std::abs(point.p_G.y() - y);
    if (inward > kPadBand) continue;
    const bool border = tip - point.p_G.z() < kBorder ||
                        std::abs(point.p_G.x() - x) > 0.5 * gripper.finger.x() - kBorder;
    (border ? at_border : within) = std::min(border ? at_border : within, inward);
    near += point.p_G;
    top = std::min(top, point.p_G.z());
    bottom = std::max(bottom, point.p_G.z());
    const double cosine = sign * point.n_G.y();
    side.facing += std::max(0.0, cosine);
    facing.add(cosine);
    if (FacingCount::faces_pad(cosine)) normals += point.n_G;
  }
  near /= facing.count(), side.facing /= facing.count();
  side.height = bottom - top;
  side.p_G = {near.x(), y, near.z()};
  side.seen = facing.seen();
  side.behind = facing.behind();
  side.inner = within - at_border < kWidening;
  const bool leans = side.seen && !side.inner;
  side.n_G = leans ? Eigen::Vector3d(normals.normalized())
                   : Eigen::Vector3d(sign * Eigen::Vector3d::UnitY());
  return side;
}

}  // namespace quadrille
