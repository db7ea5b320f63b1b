#include "contacts/pad_side.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille {
namespace {

// Contacts are measured over the points within this distance of the outermost one [m]. It is more
// than the noise of a depth camera. The outermost place is the mean over the second distance.
constexpr double kBand = 0.004, kOutermost = 0.0015;
// A point faces the pad, or faces away from it, if its normal does with at least this cosine.
constexpr double kTowards = 0.25;
// A side is seen if at least this share of the points near the outermost one face the pad. Nothing
// tells where a hidden side is if at least the second share face away from it.
constexpr double kMinTowards = 0.2, kMinAway = 0.5;
// A place this far from the border of a pad lies well within it [m].
constexpr double kInside = 0.002;

}  // namespace

std::optional<PadSide> pad_side(std::span<const BetweenPads> points, double sign, double x,
                                double tip, const Gripper& gripper) {
  const double y = sign > 0.0 ? points.back().p_G.y() : points.front().p_G.y();
  Eigen::Vector3d near = Eigen::Vector3d::Zero(), outermost = near, normals = near;
  double top = tip, bottom = std::numeric_limits<double>::lowest();
  int count = 0, outer = 0, towards = 0, away = 0;
  PadSide side;
  for (const BetweenPads& point : points) {
    const double behind = std::abs(point.p_G.y() - y);
    if (behind > kBand) continue;
    near += point.p_G, ++count;
    top = std::min(top, point.p_G.z());
    bottom = std::max(bottom, point.p_G.z());
    if (behind < kOutermost) outermost += point.p_G, ++outer;
    const double cosine = sign * point.n_G.y();
    side.facing += std::max(0.0, cosine);
    away += cosine < -kTowards;
    if (cosine > kTowards) normals += point.n_G, ++towards;
  }
  near /= count, outermost /= outer, side.facing /= count;
  side.height = bottom - top;
  side.p_G = {near.x(), y, near.z()};
  side.seen = towards > kMinTowards * count;
  if (!side.seen && away > kMinAway * count) return std::nullopt;
  side.inner = tip - outermost.z() > kInside &&
               std::abs(outermost.x() - x) < 0.5 * gripper.finger.x() - kInside;
  const bool leans = side.seen && !side.inner;
  side.n_G = leans ? Eigen::Vector3d(normals.normalized())
                   : Eigen::Vector3d(sign * Eigen::Vector3d::UnitY());
  return side;
}

}  // namespace quadrille
