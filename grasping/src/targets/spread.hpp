#pragma once

#include <vector>

#include "quadrille/grasping/grasp.hpp"

namespace quadrille {

/// Returns how unlike two grasps of one target are, from 0 for the same pose to 1: the largest of
/// the distance between the origins of their frames G as a share of `reach`, the angle between
/// their approaches, and the angle between the lines along which they close, both as shares of a
/// right angle.
/// @param reach  half the target's largest size, beyond which places are wholly different [m]
double difference(const Grasp& a, const Grasp& b, double reach);

/// Picks grasps of one target that are good and unlike each other. The first is the one with the
/// best score. Each next one has the largest product of its score and its difference to the most
/// similar grasp picked before: the probability that it succeeds, times the share in which it is
/// something else than what there is already. Of equals, the first is picked.
/// @return at most `count` grasps, in the order of picking
std::vector<Grasp> spread(const std::vector<Grasp>& grasps, std::size_t count, double reach);

}  // namespace quadrille
