#pragma once

#include <Eigen/Core>
#include <vector>

#include "contacts/contact_line.hpp"
#include "quadrille/grasping/grasp.hpp"

namespace quadrille {

/// Returns true if a hold adds nothing to one of these grasps, since its contacts and the hand are
/// nearly the same.
bool resembles_one_of(const std::vector<Grasp>& grasps, const ContactLine& line,
                      const Eigen::Vector3d& approach_C);

/// Returns true if a grasp adds nothing to one of the others.
bool resembles_one_of(const std::vector<Grasp>& others, const Grasp& grasp);

}  // namespace quadrille
