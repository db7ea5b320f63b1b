#pragma once

#include <optional>

#include "base/mask.hpp"
#include "quadrille/detector/stage_options.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// A cylinder and a cone that follow each other about one axis, such as the neck and the shoulder
/// of a bottle.
struct TwoPieces {
  /// Without evidence. Either may have fewer samples than a surface needs.
  Surface cylinder, cone;
  /// By how much their Bayesian information criterion is less than that of the one quadric; more
  /// than 0.
  double gain = 0.0;
};

/// Tells a cylinder and the cone next to it apart, to which one curved quadric of revolution was
/// fitted. Neck and shoulder of a bottle look like a hyperboloid of one sheet, shoulder and body
/// like an ellipsoid.
///
/// About the axis, the profile of the samples around is two straight lines; see two_lines(). The
/// pieces are fitted to the samples on these lines about one axis, together with the sibling, by
/// fit_coaxial(). Then the lines are sought about the new axis. What lies on neither piece, like
/// the crease between them that a sensor rounds, counts no more than kMaxDeviations allows.
///
/// Inner sides are left whole: that of a mug is a cylinder that bends where it meets the bottom.
///
/// The loss of the one quadric is compared with that of the pieces, of which each counts on its
/// side of the crease. Samples beyond the one quadric's region may lie on the cylinder in both
/// cases.
/// @param sibling  see sibling.hpp; may be null
/// @param free     samples that belong to no surface
/// @return nullopt if the one quadric explains the samples better, or is no quadric of revolution
///   that curves along its axis
std::optional<TwoPieces> two_pieces(const Surface& surface, const Surface* sibling,
                                    const SurfaceSamples& samples, const Mask& free,
                                    const AggregateOptions& options);

}  // namespace quadrille
