#pragma once

#include <Eigen/Core>
#include <vector>

namespace quadrille {

/// Clusters of raw hypotheses by agglomeration (paper, "Hypotheses aggregation"): each is a cluster
/// at first, and the two nearest clusters become one until no two are nearer than `max_distance`.
/// Two clusters are as far apart as the two members that differ most by d_close (complete linkage),
/// so that a cluster is never wider than that, and the order of the hypotheses does not count but
/// between equal distances.
/// @param hypotheses    symmetric 4x4 matrices in one frame, best normalised to the unit ball
/// @param tau           of d_close, see close_distance()
/// @return for each cluster the indices of its members, ascending; clusters by their first member
std::vector<std::vector<int>> cluster_hypotheses(const std::vector<Eigen::Matrix4d>& hypotheses,
                                                 double tau, double max_distance);

}  // namespace quadrille
