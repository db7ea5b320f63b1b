#pragma once

#include <span>
#include <vector>

#include "bodies/joint_member.hpp"
#include "fit/coaxial_fit.hpp"
#include "quadrille/detector/detection.hpp"
#include "surfaces/last_fit.hpp"

namespace quadrille {

/// The two sides of a wall as spheres about one centre, the outer one first.
struct CentredWall {
  std::vector<Member> sides;
  CoaxialFit fit;
};

/// Finds the surfaces that are the two sides of a round wall, such as those of a bowl, and fits
/// them as spheres about one centre. A small piece of a sphere says little about its radius and
/// centre alone. At least one side is a sphere, one was seen from outside and the other from
/// inside, and they share an axis within kPerhapsOneAxis. Their residuals grow by no more than
/// chance lets them, and a side that was no sphere alone fits no better as what it was. If a
/// surface may be a side of several walls, it is one of that for which one centre is most likely,
/// by the Bayesian information criterion.
/// @param fits  must outlive the result
std::vector<CentredWall> find_centred_walls(std::span<const Detection> detections,
                                            const std::vector<LastFit>& fits);

}  // namespace quadrille
