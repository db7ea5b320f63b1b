#include "quadrille/detector/vote.hpp"

#include <algorithm>
#include <cmath>

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

  std::vector<float> histogram(options.bins, 0.0f);
  const float per_bin = static_cast<float>(options.bins / M_PI);
  for (Eigen::Index i = 0; i < voters.size(); ++i) {
    if (!(std::abs(h[i]) > options.least_height && cosine[i] > options.least_cosine)) continue;
    const float theta = std::atan(lambda[i] / static_cast<float>(options.lambda_scale));
    const float position = (theta + static_cast<float>(M_PI_2)) * per_bin;
    ++histogram[std::clamp(static_cast<int>(position), 0, options.bins - 1)];
  }

  // Kernel density with a triangular kernel of two bins; the range is no circle: its ends are the
  // doubled data plane, approached from two sides.
  std::vector<VotePeak> peaks;
  const auto at = [&](int i) { return i < 0 || i >= options.bins ? 0.0f : histogram[i]; };
  std::vector<float> density(options.bins);
  for (int i = 0; i < options.bins; ++i) {
    density[i] = at(i - 2) + 2 * at(i - 1) + 3 * at(i) + 2 * at(i + 1) + at(i + 2);
  }
  for (int i = 0; i < options.bins; ++i) {
    const float left = i ? density[i - 1] : -1.0f;
    const float right = i + 1 < options.bins ? density[i + 1] : -1.0f;
    if (density[i] <= 0 || density[i] < left || density[i] <= right) continue;
    // Mean over the kernel's core, finer than a bin.
    const float mass = at(i - 1) + at(i) + at(i + 1);
    const float shift = mass > 0 ? (at(i + 1) - at(i - 1)) / mass : 0.0f;
    const double theta = (i + 0.5 + shift) / per_bin - M_PI_2;
    peaks.push_back({options.lambda_scale * std::tan(theta), density[i] / 9.0});
  }
  std::stable_sort(peaks.begin(), peaks.end(),
                   [](const VotePeak& a, const VotePeak& b) { return a.votes > b.votes; });
  if (static_cast<int>(peaks.size()) > options.peaks) peaks.resize(options.peaks);
  return peaks;
}

}  // namespace quadrille
