#include "search/vote.hpp"

#include <cmath>

#include "base/vector_clones.hpp"
#include "fit/half_gradient.hpp"

namespace quadrille {
namespace {

/// Finds what all points vote for.
/// @param points, normals  rows of the 3xN voters
/// @param gradients  rows of the half gradients of f₀ there, and of f₀
/// @param votes  rows of the results: height over the data plane, λ, and the cosine between normal
///   and gradient
QUADRILLE_VECTOR_CLONES
void find_votes(const float* plane, Eigen::Index size, const float* points, const float* normals,
                const float* gradients, float* __restrict votes) {
  const float px = plane[0], py = plane[1], pz = plane[2], offset = plane[3];
  const float *x = points, *y = x + size, *z = y + size;
  const float *nx = normals, *ny = nx + size, *nz = ny + size;
  const float *gx = gradients, *gy = gx + size, *gz = gy + size, *f = gz + size;
  float *height = votes, *lambda = height + size, *cosine = lambda + size;
  for (Eigen::Index i = 0; i < size; ++i) {
    const float h = px * x[i] + py * y[i] + pz * z[i] + offset;
    const float l = -f[i] / (h * h);
    // The gradient of f₀ + λ h² is 2 (g + λ h m), where m is the plane's normal.
    const float lh = l * h;
    const float ax = gx[i] + lh * px, ay = gy[i] + lh * py, az = gz[i] + lh * pz;
    const float dot = ax * nx[i] + ay * ny[i] + az * nz[i];
    height[i] = h, lambda[i] = l;
    cosine[i] = dot / std::sqrt(ax * ax + ay * ay + az * az);
  }
}

}  // namespace

std::vector<VotePeak> vote(const Pencil& pencil, const OrientedPointsf& voters,
                           const VoteOptions& options) {
  const HalfGradients g(voters, pencil.Q0);
  const Eigen::Vector4f P = pencil.plane.cast<float>();
  Eigen::ArrayX3f votes(voters.size(), 3);
  find_votes(P.data(), voters.size(), voters.points.data(), voters.normals.data(), g.x().data(),
             votes.data());
  const auto h = votes.col(0), lambda = votes.col(1), cosine = votes.col(2);
  VoteHistogram histogram(options);
  for (Eigen::Index i = 0; i < voters.size(); ++i) {
    if (std::abs(h[i]) > options.min_height && cosine[i] > options.min_cosine) {
      histogram.add(lambda[i]);
    }
  }
  return histogram.peaks();
}

}  // namespace quadrille
