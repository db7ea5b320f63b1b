#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lab/scene/scene.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille::experiments {

/// How a ball, or the camera, moves over a sequence.
enum class BallMotion { kRoll, kLift, kApproach, kOrbit };

/// A generated sequence that stands in for one of table 1.
struct GeneratedSequence {
  std::string name;
  /// Semi-axes [m]; chosen by us, since the paper gives no sizes.
  Eigen::Vector3d axes;
  BallMotion motion;
  /// Distance of the camera from the middle of the table [m].
  double distance;
  /// Whether a box stands in front of the ball, and whether only spheres are searched for.
  bool hidden, sphere_alone;
  /// Detection rate printed in table 1 [%].
  double printed;
};

/// The eight sequences of table 1, in its order.
const std::vector<GeneratedSequence>& ball_sequences();

/// The scene of one frame, with the ball's centre in frame C.
struct BallFrameScene {
  scene::Scene made;
  Eigen::Vector3d centre_C;
  /// Share of the ball's pixels that is visible.
  double seen = 0.0;
};

/// Makes a frame: the ball among clutter that stays the same over the sequence.
/// @param time  0 to 1 over the sequence
BallFrameScene ball_scene(const GeneratedSequence& sequence, double time, std::uint64_t seed);

/// Returns true if a sphere or an ellipsoid agrees in its centre and all three semi-axes, in any
/// order, to within a share of the longest diameter.
bool is_ball(const Detection& found, const Eigen::Vector3d& centre_C, Eigen::Vector3d axes,
             double share);

}  // namespace quadrille::experiments
