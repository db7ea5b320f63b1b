#include "search/vote.hpp"

#include <cmath>

#include "search/vote_histogram.hpp"

namespace quadrille {

std::vector<VotePeak> vote(const Pencil& pencil, const FitPoints& voters,
                           const VoteOptions& options) {
  const Eigen::Matrix4f Q = pencil.Q0.cast<float>();
  const Eigen::Vector4f P = pencil.plane.cast<float>();
  const Eigen::ArrayXf &x = voters.x, &y = voters.y, &z = voters.z;
  // Half gradients of f₀, f₀ itself, and the height over the data plane.
  const Eigen::ArrayXf gx = Q(0, 0) * x + Q(0, 1) * y + Q(0, 2) * z + Q(0, 3);
  const Eigen::ArrayXf gy = Q(0, 1) * x + Q(1, 1) * y + Q(1, 2) * z + Q(1, 3);
  const Eigen::ArrayXf gz = Q(0, 2) * x + Q(1, 2) * y + Q(2, 2) * z + Q(2, 3);
  const Eigen::ArrayXf f =
      gx * x + gy * y + gz * z + Q(0, 3) * x + Q(1, 3) * y + Q(2, 3) * z + Q(3, 3);
  const Eigen::ArrayXf h = P[0] * x + P[1] * y + P[2] * z + P[3];
  const Eigen::ArrayXf lambda = -f / h.square();
  // The gradient of f₀ + λ h² is 2 (g + λ h m).
  const Eigen::ArrayXf lh = lambda * h;
  const Eigen::ArrayXf ax = gx + lh * P[0], ay = gy + lh * P[1], az = gz + lh * P[2];
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
