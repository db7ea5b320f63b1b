#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "bodies/joint_member.hpp"
#include "fit/coaxial_fit.hpp"
#include "quadrille/detector/detection.hpp"
#include "surfaces/last_fit.hpp"

namespace quadrille {

/// Numbers of surfaces that may be the two sides of one round wall, the outer one first: at least
/// one is a sphere, one was seen from outside and the other from inside, and they share an axis
/// within the tolerance for parts whose place is not well known.
std::vector<std::pair<int, int>> perhaps_one_centre(std::span<const Detection> detections,
                                                    const std::vector<LastFit>& fits);

/// Fits the two sides of a wall, such as those of a bowl, as spheres about one centre. A small
/// piece of a sphere says little about its radius and centre alone.
/// @return nullopt if their residuals grow by more than chance lets them, or if a side that was no
///   sphere alone fits better as what it was
std::optional<CoaxialFit> fit_one_centre(const std::vector<Member>& sides);

}  // namespace quadrille
