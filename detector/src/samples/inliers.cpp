#include "samples/inliers.hpp"

#include <cmath>

namespace quadrille {

bool is_inlier(const SurfaceSamples& samples, int i, const Eigen::Matrix4f& Q,
               const InlierTest& test) {
  const Eigen::Vector4f x = samples.raw[i].homogeneous();
  const Eigen::Vector4f h = Q * x;
  const float f = x.dot(h);
  const Eigen::Vector3f g = h.head<3>();
  const float slope = g.norm();
  const float limit = static_cast<float>(test.sigmas) * samples.sigma[i] +
                      static_cast<float>(test.cells) * samples.cell[i];
  return std::abs(f) <= 2.0f * slope * limit &&
         std::abs(g.dot(samples.n[i])) >= static_cast<float>(test.min_cosine) * slope;
}

std::vector<int> connected_inliers(const SurfaceSamples& samples, std::span<const int> start,
                                   const Quadric& quadric, const InlierTest& test,
                                   const std::vector<char>& free) {
  const Eigen::Matrix4f Q = quadric.normalized().matrix().cast<float>();
  std::vector<char> seen(static_cast<std::size_t>(samples.size()), 0);
  std::vector<int> region;
  const auto visit = [&](int i) {
    if (seen[i]) return;
    seen[i] = 1;
    if (free[i] && is_inlier(samples, i, Q, test)) region.push_back(i);
  };
  for (const int i : start) visit(i);
  for (std::size_t k = 0; k < region.size(); ++k) {
    for (const int j : samples.neighbours_of(region[k])) visit(j);
  }
  return region;
}

}  // namespace quadrille
