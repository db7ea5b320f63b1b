#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lab/scene/scene.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille::experiments {

/// How a ball, or the camera, moves over a sequence.
enum class BallMotion { kRoll, kLift, kApproach, kOrbit };

/// One generated sequence in place of one of table 1's.
struct GeneratedSequence {
  std::string name;
  /// Semi-axes [m]; ours, for the paper tells no sizes.
  Eigen::Vector3d axes;
  BallMotion motion;
  /// Of the camera from the middle of the table [m].
  double distance;
  /// Whether a box stands before the ball, and the search is for spheres alone.
  bool hidden, sphere_alone;
  /// Of table 1 [%].
  double printed;
};

/// The eight of table 1, in its order.
const std::vector<GeneratedSequence>& ball_sequences();

/// The ball of a frame, in frame C.
struct BallFrameScene {
  scene::Scene made;
  Eigen::Vector3d centre_C;
  /// Share of its pixels that is seen.
  double seen = 0.0;
};

/// A frame: the ball among clutter that stays the same over the sequence.
/// @param time  0 to 1 over the sequence
BallFrameScene ball_scene(const GeneratedSequence& sequence, double time, std::uint64_t seed);

/// True if a sphere or an ellipsoid has its centre and all three semi-axes, in any order, within a
/// share of the longest diameter.
bool is_ball(const Detection& found, const Eigen::Vector3d& centre_C, Eigen::Vector3d axes,
             double share);

}  // namespace quadrille::experiments
