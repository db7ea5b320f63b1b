#include "search/vote.hpp"

#include <cmath>

#include "fit/half_gradient.hpp"

namespace quadrille {

std::vector<VotePeak> vote(const Pencil& pencil, const OrientedPointsf& voters,
                           const VoteOptions& options) {
  const HalfGradients g(voters, pencil.Q0);
  // Height of each voter over the data plane.
  const Eigen::Vector4f P = pencil.plane.cast<float>();
  const Eigen::ArrayXf h = P[0] * voters.x() + P[1] * voters.y() + P[2] * voters.z() + P[3];
  const Eigen::ArrayXf lambda = -g.f() / h.square();
  // The gradient of f₀ + λ h² is 2 (g + λ h m), where m is the plane's normal.
  const Eigen::ArrayXf lh = lambda * h;
  const Eigen::ArrayXf ax = g.x() + lh * P[0], ay = g.y() + lh * P[1], az = g.z() + lh * P[2];
  const Eigen::ArrayXf cosine = (ax * voters.nx() + ay * voters.ny() + az * voters.nz()) /
                                (ax.square() + ay.square() + az.square()).sqrt();

  VoteHistogram histogram(options);
  for (Eigen::Index i = 0; i < voters.size(); ++i) {
    if (std::abs(h[i]) > options.min_height && cosine[i] > options.min_cosine) {
      histogram.add(lambda[i]);
    }
  }
  return histogram.peaks();
}

}  // namespace quadrille
