#include "samples/inliers.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "samples/flood.hpp"

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
                                   const Quadric& quadric, const InlierTest& test, const Mask& free,
                                   Marks* seen) {
  const Eigen::Matrix4f Q = quadric.normalized().matrix().cast<float>();
  seen->clear();
  const auto joins = [&](int i) {
    return seen->add(i) && free[i] && is_inlier(samples, i, Q, test);
  };
  std::vector<int> region;
  std::copy_if(start.begin(), start.end(), std::back_inserter(region), joins);
  return flood(samples, std::move(region), [&](int i, int) { return joins(i); });
}

}  // namespace quadrille
