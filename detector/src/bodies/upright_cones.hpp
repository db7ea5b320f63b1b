#pragma once

#include <Eigen/Core>
#include <vector>

#include "surfaces/last_fit.hpp"

namespace quadrille {

/// Makes upright cones of cylinders that lean somewhat. From one side, a tapered cup looks like a
/// cylinder that leans, and noise decides between the two. But things stand upright far more often
/// than they lean by some degrees.
///
/// So the cone is taken if the residuals grow by no more than chance and bent surfaces let them
/// (see is_chance()), and if an upright cylinder explains the points significantly worse than it.
/// @param up  normal of the support [unit vector]
/// @return numbers of the surfaces that have another fit now
std::vector<int> stand_cones_up(const Eigen::Vector3d& up, std::vector<LastFit>* fits);

}  // namespace quadrille
