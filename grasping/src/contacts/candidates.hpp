#pragma once

#include <Eigen/Geometry>
#include <limits>
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
  /// Unit approach direction, at a right angle to the closing direction.
  Eigen::Vector3d approach_C = Eigen::Vector3d::UnitZ();
  /// How promising the candidate is before any collision check; higher is better.
  double prior = 0.0;
};

/// The directions from which a hand can approach a target.
struct ApproachSpace {
  /// Unit direction from the target to the sensor.
  Eigen::Vector3d view_C = -Eigen::Vector3d::UnitZ();
  /// Unit normal of the plane that the target stands on; zero if none is known.
  Eigen::Vector3d up_C = Eigen::Vector3d::Zero();
  /// Height of the target's centre above that plane; infinite if none is known [m].
  double height = std::numeric_limits<double>::infinity();
  /// Distance that hands have to keep off that plane [m].
  double off_support = 0.0;
  /// Unit direction into the mouth of a shell; the hand approaches within 45° of it. Zero if there
  /// is no mouth.
  Eigen::Vector3d into_C = Eigen::Vector3d::Zero();
  /// Directions of approach that the query asks for.
  std::optional<Cone> wanted;
  /// Axes of the target's canonical frame, used as the reference if the view gives none.
  Eigen::Matrix3d axes_C = Eigen::Matrix3d::Identity();
  /// The target's centre [m].
  Eigen::Vector3d centre_C = Eigen::Vector3d::Zero();
  /// Half the target's largest size [m].
  double reach = 0.1;
};

/// Returns true if the query allows this approach direction.
bool wanted(const Eigen::Vector3d& approach, const ApproachSpace& space);

/// Returns true if an approach direction comes from the sensor's side or from above, and leads into
/// the mouth if there is one.
bool reachable(const Eigen::Vector3d& approach, const ApproachSpace& space);

/// Approach directions around lines, and the numbers of those left out as not reachable() or not
/// wanted().
struct SampledApproaches {
  std::vector<GraspCandidate> candidates;
  int unreachable = 0, unwanted = 0;
};

/// Samples approach directions every 15° around each line that come from the sensor's side or from
/// above. The most promising come first: along the line of sight or downward, closing across the
/// line of sight, near the target's middle. Into a mouth, directions straight along the wall are
/// added and preferred. The direction nearest to the middle of the wanted cone is added too. The
/// order follows visit_in_passes() and is always the same for the same input.
SampledApproaches sample_approaches(const std::vector<ContactLine>& lines,
                                    const ApproachSpace& space);

/// Returns the 24 unit directions at right angles to a closing direction, every 15° from `first`
/// on, itself a unit vector at a right angle to it.
std::vector<Eigen::Vector3d> around_closing(const Eigen::Vector3d& closing,
                                            const Eigen::Vector3d& first);

/// Returns the grasp frame of a line: z along the approach, y along the closing direction, and the
/// origin at the line's centre moved by `depth` [m] along the approach.
Eigen::Isometry3d grasp_pose(const ContactLine& line, const Eigen::Vector3d& approach_C,
                             double depth);

}  // namespace quadrille
