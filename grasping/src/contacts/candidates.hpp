#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "contacts/contact_line.hpp"
#include "quadrille/grasping/grasp_query.hpp"
#include "quadrille/grasping/gripper.hpp"

namespace quadrille {

/// A contact line and a direction to approach it from.
struct GraspCandidate {
  /// Index of the contact line.
  int line = 0;
  /// Unit approach direction, across the closing direction.
  Eigen::Vector3d approach_C = Eigen::Vector3d::UnitZ();
  /// How promising it is before any collision check, more is better.
  double prior = 0.0;
};

/// Where a hand can come from.
struct ApproachSpace {
  /// Unit direction from the target to the sensor.
  Eigen::Vector3d view_C = -Eigen::Vector3d::UnitZ();
  /// Unit normal of the plane that the target stands on; zero if none is known.
  Eigen::Vector3d up_C = Eigen::Vector3d::Zero();
  /// Unit direction into the mouth of a shell, which the hand comes along within 45°; or zero.
  Eigen::Vector3d into_C = Eigen::Vector3d::Zero();
  /// Directions of approach that are wanted.
  std::optional<Cone> wanted;
  /// Axes of the target's canonical frame, the reference where the view gives none.
  Eigen::Matrix3d axes_C = Eigen::Matrix3d::Identity();
  /// The target's middle [m].
  Eigen::Vector3d centre_C = Eigen::Vector3d::Zero();
  /// Half the target's largest size [m].
  double reach = 0.1;
};

/// True for an approach direction that is wanted.
bool wanted(const Eigen::Vector3d& approach, const ApproachSpace& space);

/// True for an approach direction from the sensor's side or from above, and along a mouth.
bool reachable(const Eigen::Vector3d& approach, const ApproachSpace& space);

/// Approach directions around lines, and how many more are not reachable() or not wanted().
struct SampledApproaches {
  std::vector<GraspCandidate> candidates;
  int unreachable = 0, unwanted = 0;
};

/// Approach directions every 15° around each line that come from the sensor's side or from above,
/// the most promising first: along the line of sight or downward, closing across the line of sight,
/// near the target's middle. Into a mouth also, and best, straight along the wall. Also the
/// direction nearest to the middle of those that are wanted. They come in the passes of
/// visit_in_passes(). Always the same order for the same input.
SampledApproaches sample_approaches(const std::vector<ContactLine>& lines,
                                    const ApproachSpace& space);

/// The 24 unit directions across a closing direction, every 15° from `first` on, a unit vector at
/// right angles to it.
std::vector<Eigen::Vector3d> around_closing(const Eigen::Vector3d& closing,
                                            const Eigen::Vector3d& first);

/// The grasp frame of a line: z along the approach, y along the closing direction, the origin moved
/// by `depth` [m] along the approach from the line's centre.
Eigen::Isometry3d grasp_pose(const ContactLine& line, const Eigen::Vector3d& approach_C,
                             double depth);

}  // namespace quadrille
