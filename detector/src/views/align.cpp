#include "views/align.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "samples/sample_buckets.hpp"

namespace quadrille {
namespace {

constexpr int kIterations = 10;
// Samples may match if their positions differ by no more than this many cells beside the errors of
// the poses, and their normals by no more than 25°.
constexpr float kMatchCells = 1.0f, kMinCosine = 0.9f;
// Errors of the poses that are looked for, in standard deviations of their prior.
constexpr double kReach = 3.0;
// Standard deviation of the sensor's own, slowly varying error of depth [m], and the number of
// places in a view at which it is independent.
constexpr double kSensorError = 0.001, kPlaces = 30.0;
// Samples at a depth edge have fewer neighbours than this; they lie partly beside the surface.
constexpr std::size_t kMinNeighbours = 8;

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// The samples of earlier views, by place.
class Target {
 public:
  explicit Target(const SurfaceSamples& samples) : samples_(samples), buckets_(samples) {}

  /// The nearest sample with a similar normal within a distance; −1 if there is none.
  int nearest(const Eigen::Vector3f& p, const Eigen::Vector3f& n, float reach) const {
    int best = -1;
    float least = reach * reach;
    for (const int j : buckets_.near(p, reach)) {
      const float square = (samples_.p[j] - p).squaredNorm();
      if (square >= least || samples_.n[j].dot(n) < kMinCosine) continue;
      least = square;
      best = j;
    }
    return best;
  }

 private:
  const SurfaceSamples& samples_;
  SampleBuckets buckets_;
};

/// Weight of a residual by Cauchy's function, which leaves little to those far beyond sigma.
double weight_of(double residual, double sigma) {
  const double x = residual / (2.0 * sigma);
  return 1.0 / (sigma * sigma * (1.0 + x * x));
}

}  // namespace

Eigen::Isometry3d align(const SurfaceSamples& view, const Eigen::Vector3d& eye,
                        const SurfaceSamples& before, const ViewOptions& options) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  if (!(options.shift > 0.0 && options.turn > 0.0)) return X;
  const Target target(before);
  Vector6d prior;
  prior << Eigen::Vector3d::Constant(std::pow(options.turn, -2)),
      Eigen::Vector3d::Constant(std::pow(options.shift, -2));
  Vector6d motion = Vector6d::Zero();
  for (int step = 0; step < kIterations; ++step) {
    Matrix6d A = Matrix6d::Zero();
    Vector6d b = Vector6d::Zero();
    int matches = 0;
    for (int i = 0; i < view.size(); ++i) {
      if (view.neighbours_of(i).size() < kMinNeighbours) continue;
      const Eigen::Vector3d p = X * view.p[i].cast<double>();
      const Eigen::Vector3f n = (X.linear() * view.n[i].cast<double>()).cast<float>();
      const double off = kReach * (options.shift + options.turn * (p - eye).norm());
      const float reach = kMatchCells * view.cell[i] + static_cast<float>(off);
      const int j = target.nearest(p.cast<float>(), n, reach);
      if (j < 0) continue;
      const Eigen::Vector3d normal = before.n[j].cast<double>();
      const double residual = normal.dot(p - before.p[j].cast<double>());
      if (std::abs(residual) > off) continue;
      const double sigma =
          std::sqrt(std::pow(view.sigma[i], 2) + std::pow(before.sigma[j], 2) +
                    std::pow(kSensorError, 2));
      Vector6d J;
      J << (p - eye).cross(normal), normal;
      const double weight = weight_of(residual, sigma);
      A += weight * J * J.transpose();
      b -= weight * residual * J;
      ++matches;
    }
    const double share = std::min(1.0, kPlaces / std::max(1, matches));
    A = share * A + Matrix6d(prior.asDiagonal());
    const Vector6d change = A.ldlt().solve(share * b - prior.cwiseProduct(motion));
    motion += change;
    const Eigen::Vector3d turn = change.head<3>();
    const Eigen::Isometry3d about =
        Eigen::Translation3d(eye + change.tail<3>()) *
        Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()) * Eigen::Translation3d(-eye);
    X = about * X;
    if (change.tail<3>().norm() < 1e-6 && turn.norm() < 1e-6) break;
  }
  return X;
}

}  // namespace quadrille
