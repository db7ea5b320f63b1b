#include "variants/agglomerate.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "samples/inliers.hpp"
#include "samples/region.hpp"
#include "variants/close_distance.hpp"
#include "variants/cluster_greedily.hpp"

namespace quadrille {
namespace {

/// @param local  coordinates of the kept one's region
bool one_surface(const Candidate& kept, const Normalisation& local, const Candidate& other,
                 const SurfaceSamples& samples, const InlierTest& test,
                 const AgglomerateOptions& options) {
  if (close_distance(local.to_local(other.Q), local.to_local(kept.Q), options.max_difference) <=
      options.max_close) {
    return true;
  }
  std::set<int> either(kept.region.begin(), kept.region.end());
  const std::size_t apart = kept.region.size() + other.region.size();
  either.insert(other.region.begin(), other.region.end());
  if (either.size() == apart) return false;  // the regions have no sample in common
  const std::vector<int> region(either.begin(), either.end());
  return far_distance(kept.Q, other.Q, samples, region, test) <= options.max_far;
}

}  // namespace

double far_distance(const Quadric& a, const Quadric& b, const SurfaceSamples& samples,
                    std::span<const int> region, const InlierTest& test) {
  if (region.empty()) return 1.0;
  const Eigen::Matrix4f A = a.normalized().matrix().cast<float>();
  const Eigen::Matrix4f B = b.normalized().matrix().cast<float>();
  const auto both = std::count_if(region.begin(), region.end(), [&](int i) {
    return is_inlier(samples, i, A, test) && is_inlier(samples, i, B, test);
  });
  return 1.0 - static_cast<double>(both) / static_cast<double>(region.size());
}

std::vector<Candidate> agglomerate(std::vector<Candidate> candidates, const SurfaceSamples& samples,
                                   const InlierTest& test, const AgglomerateOptions& options) {
  std::erase_if(candidates, [](const Candidate& candidate) { return candidate.region.empty(); });
  using Cluster = GreedyCluster<Normalisation>;
  const auto local_of = [&](const Candidate& c) { return normalisation_of(samples, c.region); };
  const auto is_same = [&](const Cluster& next, const Cluster& known) {
    return one_surface(known.first, known.traits, next.first, samples, test, options);
  };
  std::vector<Candidate> kept;
  for (Cluster& cluster : cluster_greedily(std::move(candidates), local_of, is_same)) {
    kept.push_back(std::move(cluster.first));
  }
  return kept;
}

}  // namespace quadrille
