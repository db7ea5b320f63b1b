#include "surfaces/evidence/intruders.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "samples/inliers.hpp"
#include "samples/plane_sums.hpp"

namespace quadrille {
namespace {

// A sample lies off a quadric if its distance exceeds this many times its noise plus this share of
// its cell.
constexpr float kOffSigmas = 2.0f, kOffCells = 0.1f;

/// Matrix whose rows are the principal axes of a region.
Eigen::Matrix3f principal_axes(const PlaneSums& sums) {
  const Eigen::Vector3d mean = sums.sum / sums.n;
  const Eigen::Matrix3d covariance = sums.squares() / sums.n - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  return eigen.computeDirect(covariance).eigenvectors().transpose().cast<float>();
}

}  // namespace

void add_intruders(const SurfaceSamples& samples, const SampleBlocks& blocks,
                   std::span<const int> region, const Quadric& quadric, Evidence* evidence) {
  const Eigen::Matrix4f Q = quadric.normalized().matrix().cast<float>();
  std::vector<char> inside(static_cast<std::size_t>(samples.size()), 0);
  PlaneSums sums;
  float side = 0;
  for (const int i : region) {
    inside[i] = 1;
    sums.add(samples.raw[i].cast<double>());
    side += (Q * samples.raw[i].homogeneous()).head<3>().normalized().dot(samples.n[i]);
  }
  const Eigen::Vector3f centre = (sums.sum / sums.n).cast<float>();
  const Eigen::Matrix3f axes = principal_axes(sums);
  Eigen::AlignedBox3f box;
  for (const int i : region) box.extend(Eigen::Vector3f(axes * (samples.raw[i] - centre)));
  const Eigen::Affine3f X_BC = Eigen::Affine3f(axes) * Eigen::Translation3f(-centre);
  int in_front = 0, behind = 0;
  for (const int i : blocks.in_box(X_BC, box)) {
    if (inside[i] || !box.contains(Eigen::Vector3f(axes * (samples.raw[i] - centre)))) continue;
    const float d = distance_to(Q, samples.raw[i]);
    if (std::abs(d) < kOffSigmas * samples.sigma[i] + kOffCells * samples.cell[i]) continue;
    ++((d > 0) == (side > 0) ? in_front : behind);
  }
  evidence->in_front = in_front / sums.n;
  evidence->behind = behind / sums.n;
}

}  // namespace quadrille
