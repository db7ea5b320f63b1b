#include "surfaces/evidence/intruders.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "base/vector_clones.hpp"
#include "fit/half_gradient.hpp"
#include "samples/plane_sums.hpp"
#include "surfaces/evidence/box_test.hpp"

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

/// Numbers of samples in the box that lie off the quadric, on the side to which its gradient points
/// and on either side.
struct SideCounts {
  int ahead = 0, all = 0;
};

QUADRILLE_VECTOR_CLONES
SideCounts count_sides(const BoxTest& box, Coefficients<float> q, const SampleRows& s) {
  int ahead = 0, all = 0;
  for (int k = 0; k < s.size; ++k) {
    int inside = box.holds(s.x[k], s.y[k], s.z[k]);
    const HalfGradient<float> g = half_gradient(q, s.x[k], s.y[k], s.z[k]);
    // The distance is f / 2 |g|.
    const float limit = kOffSigmas * s.sigma[k] + kOffCells * s.cell[k];
    const float slope = 4.0f * (g.x * g.x + g.y * g.y + g.z * g.z);
    inside &= !(g.f * g.f < limit * limit * slope);
    all += inside;
    ahead += inside & (g.f > 0.0f);
  }
  return {ahead, all};
}

}  // namespace

void add_intruders(const SurfaceSamples& samples, const SampleBlocks& blocks,
                   std::span<const int> region, const Quadric& quadric, Evidence* evidence) {
  const Eigen::Matrix4d Q = quadric.normalized().matrix();
  const Coefficients<float> q(Q);
  PlaneSums sums;
  float side = 0;
  for (const int i : region) {
    const Eigen::Vector3f &x = samples.raw[i], &n = samples.n[i];
    sums.add(x.cast<double>());
    const HalfGradient<float> g = half_gradient(q, x.x(), x.y(), x.z());
    const Eigen::Vector3f gradient(g.x, g.y, g.z);
    // At the apex of a cone the gradient is zero, and has no side.
    const float length = gradient.norm();
    if (length > 0.0f) side += gradient.dot(n) / length;
  }
  const Eigen::Vector3f centre = (sums.sum / sums.n).cast<float>();
  const Eigen::Matrix3f axes = principal_axes(sums);
  Eigen::AlignedBox3f box;
  for (const int i : region) box.extend(Eigen::Vector3f(axes * (samples.raw[i] - centre)));
  const Eigen::Affine3f X_BC = Eigen::Affine3f(axes) * Eigen::Translation3f(-centre);
  const BoxTest test(X_BC, box);
  // The region's own samples are counted with the others and then taken off.
  const SampleTable own(samples, region);
  const SideCounts within = count_sides(test, q, own.rows());
  SideCounts around;
  for (const SampleRows& rows : blocks.near_box(X_BC, box)) {
    const SideCounts counts = count_sides(test, q, rows);
    around.ahead += counts.ahead, around.all += counts.all;
  }
  const int ahead = around.ahead - within.ahead, rest = around.all - within.all - ahead;
  evidence->in_front = (side > 0 ? ahead : rest) / sums.n;
  evidence->behind = (side > 0 ? rest : ahead) / sums.n;
}

}  // namespace quadrille
