#pragma once

#include <cstddef>
#include <lcmtypes/quadrille/collision_shapes_t.hpp>
#include <lcmtypes/quadrille/occupancy_t.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "process/planner/pairing.hpp"
#include "process/planner/settings.hpp"
#include "process/runtime/refusals.hpp"
#include "process/runtime/robot/robot_history.hpp"
#include "quadrille/grasping/surroundings.hpp"

namespace quadrille {

/// What is known when a cloud is planned on, in the camera's frame K.
struct Known {
  Surroundings surroundings;
  std::vector<CollisionShape> obstacles;
  /// In the hand's frame G.
  std::vector<CollisionShape> attached;
};

/// What the robot knows of its scene, by its command line and by the newest message of each kind.
/// Not for two threads at once.
class Knowledge {
 public:
  /// The settings must outlive this object.
  explicit Knowledge(const PlannerSettings& settings);

  /// Takes a message on one of its channels; one that is refused is counted and logged.
  /// @return false if the channel is none of them
  bool receive(const std::string& channel, std::span<const std::byte> bytes, Refusals* refusals);

  /// @throws std::invalid_argument if something is in a frame that is not known
  Known about(const CloudAndQuadrics& pair) const;

  /// Returns the robot's shapes in frame K of a further camera; see RobotHistory::at_view().
  std::optional<RobotShapes> robot_at_view(std::int64_t utime, const Eigen::Isometry3d& X_WK,
                                           Refusals* refusals) const {
    return robot_.at_view(utime, X_WK, settings_.robot_channel, refusals);
  }

 private:
  /// Something in a frame that a message names.
  template <class Value>
  struct InFrame {
    std::string frame;
    Value value;
  };

  void take_obstacles(const collision_shapes_t& message);
  void take_map(const occupancy_t& message);

  const PlannerSettings& settings_;
  RobotHistory robot_;
  InFrame<std::vector<CollisionShape>> obstacles_;
  /// Once a message has come, it counts in place of the command line's plane, also if it withdraws
  /// that.
  std::optional<InFrame<std::optional<KnownSupport>>> support_;
  std::optional<InFrame<std::shared_ptr<const octomap::OcTree>>> map_;
};

}  // namespace quadrille
