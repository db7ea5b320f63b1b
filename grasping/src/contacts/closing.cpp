#include "contacts/closing.hpp"

#include <algorithm>
#include <cmath>

#include "space/collision.hpp"

namespace quadrille {
namespace {

// Contacts nearer than this to the edge of a pad may in truth miss the pad [m].
constexpr double kEdgeMargin = 0.001;
// Anything this near to a finger that closes flush does not stop it, so that rounding does not
// matter [m].
constexpr double kFlushMargin = 0.0003;
// Largest difference between the lean of the two ends of a chord: 10°.
constexpr double kMaxLeanDifference = 0.17;

}  // namespace

bool on_pads(const ContactLine& line, const Eigen::Isometry3d& X_CG, const Gripper& gripper) {
  const Eigen::Isometry3d X_GC = X_CG.inverse();
  return std::all_of(line.contacts_C.begin(), line.contacts_C.end(), [&](const auto& p_C) {
    const Eigen::Vector3d p_G = X_GC * p_C;
    return std::abs(p_G.x()) <= 0.5 * gripper.pad.x() - kEdgeMargin &&
           p_G.z() <= gripper.finger_front - kEdgeMargin;
  });
}

bool meets_too_early(const ContactLine& line, const Eigen::Isometry3d& X_CG, const Gripper& gripper,
                     const std::vector<CollisionShape>& target, double margin) {
  const double back = -gripper.reach(line.width), front = gripper.finger_front;
  const double x = 0.5 * gripper.finger.x(), y = 0.5 * line.width + margin + kFlushMargin;
  for (const double side : {-1.0, 1.0}) {
    const double near = side * y, far = side * (y + gripper.finger.y());
    const OrientedBox finger =
        box_between(X_CG, {-x, std::min(near, far), back}, {x, std::max(near, far), front});
    const auto meets = [&](const CollisionShape& piece) { return overlaps(finger, piece); };
    if (std::any_of(target.begin(), target.end(), meets)) return true;
  }
  return false;
}

bool lopsided(const ContactLine& line, const Eigen::Vector3d& approach_C) {
  return std::abs((line.normals_C[0] - line.normals_C[1]).dot(approach_C)) > kMaxLeanDifference;
}

}  // namespace quadrille
