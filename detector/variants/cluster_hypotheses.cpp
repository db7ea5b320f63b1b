#include "variants/cluster_hypotheses.hpp"

#include <algorithm>
#include <limits>

#include "variants/close_distance.hpp"

namespace quadrille {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The distances of all pairs; infinite on the diagonal.
Eigen::MatrixXd distances_of(const std::vector<Eigen::Matrix4d>& hypotheses, double tau) {
  const auto count = static_cast<Eigen::Index>(hypotheses.size());
  Eigen::MatrixXd distances = Eigen::MatrixXd::Constant(count, count, kInfinity);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      distances(i, j) = distances(j, i) = close_distance(
          hypotheses[static_cast<std::size_t>(i)], hypotheses[static_cast<std::size_t>(j)], tau);
    }
  }
  return distances;
}

}  // namespace

std::vector<std::vector<int>> cluster_hypotheses(const std::vector<Eigen::Matrix4d>& hypotheses,
                                                 double tau, double max_distance) {
  std::vector<std::vector<int>> clusters;
  clusters.reserve(hypotheses.size());
  for (int i = 0; i < static_cast<int>(hypotheses.size()); ++i) clusters.push_back({i});
  Eigen::MatrixXd distances = distances_of(hypotheses, tau);
  while (clusters.size() > 1) {
    Eigen::Index kept = 0, gone = 0;
    if (!(distances.minCoeff(&kept, &gone) <= max_distance)) break;
    if (kept > gone) std::swap(kept, gone);
    std::vector<int>&into = clusters[static_cast<std::size_t>(kept)],
    &from = clusters[static_cast<std::size_t>(gone)];
    into.insert(into.end(), from.begin(), from.end());
    from.clear();
    const Eigen::VectorXd farther = distances.col(kept).cwiseMax(distances.col(gone));
    distances.col(kept) = farther;
    distances.row(kept) = farther.transpose();
    distances.col(gone).setConstant(kInfinity);
    distances.row(gone).setConstant(kInfinity);
    distances(kept, kept) = kInfinity;
    if (!distances.array().isFinite().any()) break;
  }
  std::erase_if(clusters, [](const std::vector<int>& cluster) { return cluster.empty(); });
  for (std::vector<int>& cluster : clusters) std::sort(cluster.begin(), cluster.end());
  std::sort(clusters.begin(), clusters.end());
  return clusters;
}

}  // namespace quadrille
