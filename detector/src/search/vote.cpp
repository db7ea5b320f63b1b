#include "search/vote.hpp"

#include <cmath>

#include "search/quadric_values.hpp"
#include "search/vote_histogram.hpp"

namespace quadrille {

std::vector<VotePeak> vote(const Pencil& pencil, const FitPoints& voters,
                           const VoteOptions& options) {
  const QuadricValues q(pencil.Q0.cast<float>(), voters);
  const Eigen::Vector4f P = pencil.plane.cast<float>();
  // The height over the data plane.
  const Eigen::ArrayXf h = P[0] * voters.x + P[1] * voters.y + P[2] * voters.z + P[3];
  const Eigen::ArrayXf lambda = -q.f / h.square();
  // The gradient of f₀ + λ h² is 2 (g + λ h m).
  const Eigen::ArrayXf lh = lambda * h;
  const Eigen::ArrayXf ax = q.gx + lh * P[0], ay = q.gy + lh * P[1], az = q.gz + lh * P[2];
  const Eigen::ArrayXf cosine = (ax * voters.nx + ay * voters.ny + az * voters.nz) /
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
