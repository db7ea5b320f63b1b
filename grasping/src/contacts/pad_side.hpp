#pragma once

#include <Eigen/Core>
#include <span>

#include "quadrille/grasping/gripper.hpp"

namespace quadrille {

/// A measured point between the fingers.
struct BetweenPads {
  /// Position along the axes of G, from any origin [m].
  Eigen::Vector3d p_G;
  /// Unit normal along the axes of G; zero if it is not known.
  Eigen::Vector3d n_G;
  /// True if it belongs to the target.
  bool own = false;
};

/// Contacts are measured over the points within this distance of the outermost one [m]; all others
/// are of no effect. It is more than the noise of a depth camera.
inline constexpr double kPadBand = 0.004;

/// Counts how many of the points near the outermost one face the pad, and how many face away.
class FacingCount {
 public:
  /// @param cosine  between the pad's direction and the normal of a point; 0 if it is not known
  void add(double cosine) {
    ++count_;
    towards_ += faces_pad(cosine);
    away_ += faces_away(cosine);
  }
  static bool faces_pad(double cosine) { return cosine > kTowards; }
  static bool faces_away(double cosine) { return cosine < -kTowards; }

  int count() const { return count_; }
  /// Whether the side counts as seen, and whether nothing tells where it is, as in PadSide.
  bool seen() const { return towards_ > kMinTowards * count_; }
  bool behind() const { return !seen() && away_ > kMinAway * count_; }

 private:
  // A point faces the pad, or faces away from it, if its normal does with at least this cosine.
  static constexpr double kTowards = 0.25;
  // A side is seen if at least this share of the points near the outermost one face the pad.
  // Nothing tells where a hidden side is if at least the second share face away from it.
  static constexpr double kMinTowards = 0.2, kMinAway = 0.5;

  int count_ = 0, towards_ = 0, away_ = 0;
};

/// The side of some points that a pad touches.
struct PadSide {
  /// The contact: the mean of the points near the outermost one, moved out as far as it [m].
  Eigen::Vector3d p_G;
  /// Unit normal of the contact.
  Eigen::Vector3d n_G;
  /// True if points were seen that face the pad. Otherwise the side is hidden, and assumed to face
  /// the pad.
  bool seen = false;
  /// True if nothing tells where the hidden side is: behind a surface that faces away from the pad.
  bool behind = false;
  /// True if no point at the borders of the pad lies farther out than those within. Then the pad
  /// touches the body at its outermost point, where the surface faces the pad.
  bool inner = false;
  /// Mean cosine between the pad's direction and the normals, where those turned away count as 0.
  double facing = 0.0;
  /// How far the points near the outermost one reach along the approach [m].
  double height = 0.0;
};

/// Returns the side towards a pad of points, at least one, sorted along the closing direction y.
/// @param sign  1 for the pad at the last point, −1 for that at the first
/// @param x  middle of the pad along x [m]
/// @param tip  how far the tips reach along z [m]
PadSide pad_side(std::span<const BetweenPads> points, double sign, double x, double tip,
                 const Gripper& gripper);

}  // namespace quadrille
