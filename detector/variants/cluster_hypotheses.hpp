#pragma once

#include <Eigen/Core>
#include <vector>

namespace quadrille {

/// Clusters raw hypotheses by agglomeration (paper, "Hypotheses aggregation"). Each hypothesis
/// starts as a cluster, and the two nearest clusters are merged until no two are nearer than
/// `max_distance`. The distance of two clusters is the largest d_close between their members
/// (complete linkage), so no cluster is wider than that, and the order of the hypotheses matters
/// only between equal distances.
/// @param hypotheses    symmetric 4x4 matrices in one frame, best normalised to the unit ball
/// @param tau           limit of close_distance()
/// @return for each cluster the indices of its members, ascending; clusters are sorted by first
///   member
std::vector<std::vector<int>> cluster_hypotheses(const std::vector<Eigen::Matrix4d>& hypotheses,
                                                 double tau, double max_distance);

}  // namespace quadrille
