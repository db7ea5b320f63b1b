#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "poses/timed_values.hpp"
#include "process/runtime/poses/placement.hpp"
#include "process/runtime/refusals.hpp"
#include "quadrille/detector/robot_shapes.hpp"
#include "quadrille/detector/solid_shape.hpp"

namespace quadrille {

/// The robot's shapes at one time, as a message or the command line says.
struct RobotState {
  /// When they were so [us]; 0: always.
  std::int64_t utime = 0;
  /// Name of the frame of the shapes, see pose_of_camera().
  std::string frame;
  RobotShapes robot;
  /// Shapes that are fixed to the hand, in its frame G.
  std::vector<SolidShape> attached;
};

/// The shapes of a robot that moves. Not for two threads at once.
class RobotHistory {
 public:
  /// Limits of the states that messages tell, in number, and in bytes of the messages but for the
  /// newest. Clouds are handled before a robot that tells its shapes a hundred times a second has
  /// sent so many.
  static constexpr std::size_t kMaxStates = 256, kMaxBytes = std::size_t{64} << 20;

  /// @param given  the shapes of the command line, which are there besides those of messages
  explicit RobotHistory(RobotState given) : given_(std::move(given)) {}

  /// Takes a message of type quadrille.robot_t; one that is refused is counted and logged.
  void receive(const std::string& channel, std::span<const std::byte> bytes, Refusals* refusals);

  /// Returns the robot's shapes in frame K of a cloud, those of the message that is nearest in
  /// time.
  /// @param utime  when the cloud was taken [us]
  /// @param cloud_frame  name of the cloud's frame
  /// @throws std::invalid_argument if the frame of the shapes is not known
  RobotShapes at(std::int64_t utime, const Placement& placement,
                 const std::string& cloud_frame) const;
  /// Returns the robot's shapes in the fixed frame W.
  /// @param utime  when they were there [us]
  /// @throws std::invalid_argument if they are given in another frame
  RobotShapes in_world(std::int64_t utime) const;
  /// Returns the robot's shapes in frame K of a further camera, whose clouds name no frame in which
  /// they could be placed but W. If they are given in another one that is counted and logged as a
  /// refusal of the channel, and the result is nullopt.
  std::optional<RobotShapes> at_view(std::int64_t utime, const Eigen::Isometry3d& X_WK,
                                     const std::string& channel, Refusals* refusals) const;
  /// Returns what was fixed to the hand then.
  std::vector<SolidShape> attached_at(std::int64_t utime) const;

 private:
  RobotShapes all_at(std::int64_t utime,
                     const std::function<Eigen::Isometry3d(const std::string& frame)>& X_DF) const;

  RobotState given_;
  TimedValues<RobotState> states_{kMaxStates, kMaxBytes};
};

}  // namespace quadrille
