#pragma once

#include <Eigen/Geometry>

#include "quadrille/detector/body.hpp"
#include "track/look_match.hpp"

namespace quadrille {

/// The space that a body of any kind takes, by which it is recognised. Its kind and its parts
/// change with the noise: what is a cylinder with a lid in one cloud is a cylinder in the next one,
/// and a lump after that, but takes about the same space.
struct BodyLook {
  Eigen::Vector3d middle_W = Eigen::Vector3d::Zero();
  /// Covariance of the points in the body's box [m²].
  Eigen::Matrix3d spread_W = Eigen::Matrix3d::Identity();
};

/// @param X_WC  pose of the body's frame C in the fixed frame
BodyLook look_of(const SceneBody& body, const Eigen::Isometry3d& X_WC);

/// Standard deviation of the place of a body's middle [m].
double place_std(const BodyLook& look);

/// Returns the body after a translation [m].
BodyLook translated(BodyLook look, const Eigen::Vector3d& shift_W);

/// Returns what is remembered of a body that was seen anew, which is a mean of its last looks.
BodyLook renewed(const BodyLook& before, const BodyLook& now);

/// Compares the space of two bodies, as 8 times the Bhattacharyya distance of normal distributions
/// with the middles and spreads of both. For equal spreads this is the squared distance of the
/// middles in standard deviations of the spread. A body that is seen in few clouds costs more, by
/// the logarithm of the probability to see it.
LookMatch match_looks(const BodyLook& from, const BodyLook& to, const Expectation& expected);

}  // namespace quadrille
