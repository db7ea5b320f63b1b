#pragma once

#include <span>
#include <vector>

#include "fit/coaxial_fit.hpp"
#include "quadrille/detector/detection.hpp"
#include "surfaces/last_fit.hpp"

namespace quadrille {

/// Surfaces that were fitted about one axis.
struct CommonAxis {
  /// Their numbers, in the order of the covariance's parts.
  std::vector<int> members;
  CoaxialCovariance covariance;
};

/// Fits the parts of each body of revolution once more, about one axis; see fit_coaxial(). The
/// parts are those that share_axis() puts together, and others whose axes are somewhat farther off,
/// as noise may turn them. Spheres share a centre with the other side of their wall, see
/// find_centred_walls(), and take no other part: they show their centres without help, and the
/// outer wall of a bowl whose inner wall passes for a cone would follow the wrong axis.
///
/// Alone, a small part says little about its axis, and the radius of a part of whose section little
/// is seen depends on where its axis is. The near and the far wall of a tapered cup alone pass for
/// cylinders that lean apart; about one axis they are cones. So the two sides of a wall may become
/// cylinders or parallel cones, whichever has the least bic_of().
///
/// Parts do not share an axis after all if the common fit raises their residuals by more than
/// chance does: the sum of the growths of their sums of squares, each divided by N (V + B), where V
/// is its variance_of_mean() and B its bend_variance(), follows a χ² distribution with as many
/// degrees of freedom as the common axis takes away. Then the part whose residuals grow most is
/// left out, like a cup that stands askew in another one. So is a part whose type would change in
/// another way. Parts whose axes are farther off join only if no part's root mean square distance
/// grows by more than a factor of 1.4.
/// @param detections  the surfaces as they were measured
/// @param fits        the surfaces
/// @return the surfaces that have another fit now
std::vector<CommonAxis> fit_common_axes(std::span<const Detection> detections,
                                        std::vector<LastFit>* fits);

}  // namespace quadrille
