#include "variants/agglomerate.hpp"

#include <algorithm>
#include <set>

#include "samples/inliers.hpp"
#include "samples/region.hpp"
#include "variants/close_distance.hpp"

namespace quadrille {
namespace {

bool one_surface(const Candidate& kept, const Candidate& other, const SurfaceSamples& samples,
                 const InlierTest& test, const AgglomerateOptions& options) {
  const Normalisation local = normalisation_of(samples, kept.region);
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
  std::stable_sort(
      candidates.begin(), candidates.end(),
      [](const Candidate& a, const Candidate& b) { return a.region.size() > b.region.size(); });
  std::vector<Candidate> kept;
  for (Candidate& candidate : candidates) {
    if (candidate.region.empty()) continue;
    const bool known = std::any_of(kept.begin(), kept.end(), [&](const Candidate& k) {
      return one_surface(k, candidate, samples, test, options);
    });
    if (!known) kept.push_back(std::move(candidate));
  }
  return kept;
}

}  // namespace quadrille
