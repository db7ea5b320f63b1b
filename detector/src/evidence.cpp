#include "quadrille/detector/evidence.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

namespace quadrille {
namespace {

/// Least-squares plane of the samples of one group, relative to the origin.
Eigen::Vector4d plane_of_group(const SurfaceSamples& samples, std::span<const int> region,
                               const std::vector<int>& group, int wanted,
                               const Eigen::Vector3d& origin) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
  double n = 0;
  for (std::size_t r = 0; r < region.size(); ++r) {
    if (group[r] != wanted) continue;
    const Eigen::Vector3d x = samples.raw[region[r]].cast<double>() - origin;
    n += 1, sum += x, square += x * x.transpose();
  }
  if (n < 3) return {0, 0, 0, 1e3};
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect(square / n - sum * sum.transpose() / (n * n));
  const Eigen::Vector3d m = eigen.eigenvectors().col(0);
  return {m.x(), m.y(), m.z(), -m.dot(sum) / n};
}

/// Residual sum of squares of k planes over the region: the normals are grouped by k-means from
/// the most different ones, each group gets its plane.
double planes_rss(const SurfaceSamples& samples, std::span<const int> region, int k) {
  std::array<Eigen::Vector3f, 3> centre;
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  for (const int i : region) mean += samples.n[i];
  // The farthest from the mean, then the farthest from those chosen.
  for (int c = 0; c < k; ++c) {
    float least = 2.0f;
    for (const int i : region) {
      float nearest = c == 0 ? samples.n[i].dot(mean.normalized()) : -1.0f;
      for (int d = 0; d < c; ++d) nearest = std::max(nearest, samples.n[i].dot(centre[d]));
      if (nearest < least) least = nearest, centre[c] = samples.n[i];
    }
  }
  std::vector<int> group(region.size(), 0);
  for (int round = 0; round < 5; ++round) {
    std::array<Eigen::Vector3f, 3> sum;
    sum.fill(Eigen::Vector3f::Zero());
    for (std::size_t r = 0; r < region.size(); ++r) {
      const Eigen::Vector3f& n = samples.n[region[r]];
      int best = 0;
      for (int c = 1; c < k; ++c) {
        if (n.dot(centre[c]) > n.dot(centre[best])) best = c;
      }
      group[r] = best;
      sum[best] += n;
    }
    for (int c = 0; c < k; ++c) {
      if (sum[c].norm() > 0) centre[c] = sum[c].normalized();
    }
  }
  // Near an edge the smoothed normals lie between the faces: from here on the distance decides.
  const Eigen::Vector3d origin = samples.raw[region[0]].cast<double>();
  double rss = 0;
  for (int round = 0; round < 4; ++round) {
    std::array<Eigen::Vector4d, 3> plane;
    for (int c = 0; c < k; ++c) plane[c] = plane_of_group(samples, region, group, c, origin);
    rss = 0;
    for (std::size_t r = 0; r < region.size(); ++r) {
      const Eigen::Vector4d x = (samples.raw[region[r]].cast<double>() - origin).homogeneous();
      double least = 1e300;
      for (int c = 0; c < k; ++c) {
        const double d = std::abs(plane[c].dot(x));
        if (d < least) least = d, group[r] = c;
      }
      rss += least * least;
    }
  }
  return rss;
}

/// Share of the border where the surface goes on smoothly. Windows of neighbouring normals overlap,
/// so that even a crease looks smooth from one sample to the next: the walk goes one sample
/// further before it compares the normals.
double smooth_border(const SurfaceSamples& samples, std::span<const int> region) {
  constexpr float kSmooth = 0.87f;  // 30°
  std::vector<char> inside(static_cast<std::size_t>(samples.size()), 0);
  for (const int i : region) inside[i] = 1;
  double border = 0, smooth = 0;
  for (const int i : region) {
    int within = 0;
    for (const int j : samples.neighbours_of(i)) {
      if (inside[j]) {
        ++within;
        continue;
      }
      const Eigen::Vector3f step = samples.raw[j] - samples.raw[i];
      int next = -1;
      float most = 0.5f * step.squaredNorm();
      for (const int k : samples.neighbours_of(j)) {
        const float along = (samples.raw[k] - samples.raw[j]).dot(step);
        if (along > most) most = along, next = k;
      }
      if (next >= 0 && !inside[next]) smooth += samples.n[next].dot(samples.n[i]) > kSmooth;
    }
    border += 8 - within;
  }
  return smooth / std::max(1.0, border);
}

}  // namespace

Evidence collect_evidence(const SurfaceSamples& samples, std::span<const int> region,
                          const Quadric& quadric) {
  Evidence e;
  const double n = static_cast<double>(region.size());
  e.log_count = std::log(n);
  double square = 1e-12 * n;
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  for (const int i : region) {
    const double d = quadric.distance(samples.raw[i].cast<double>());
    square += d * d;
    mean += samples.n[i];
  }
  mean.normalize();
  std::vector<float> cosine;
  for (const int i : region) cosine.push_back(samples.n[i].dot(mean));
  const auto tenth = cosine.begin() + static_cast<std::ptrdiff_t>(cosine.size() / 10);
  std::nth_element(cosine.begin(), tenth, cosine.end());
  e.spread = std::acos(std::clamp(*tenth, -1.0f, 1.0f));
  e.smooth_border = smooth_border(samples, region);
  e.two_planes = std::log((planes_rss(samples, region, 2) + 1e-12 * n) / square);
  return e;
}

double confidence(const Evidence& e, int dof) {
  const double z = -0.92 + 1.04 * e.log_count - 1.72 * e.spread - 13.9 * e.smooth_border +
                   1.69 * std::clamp(e.two_planes, -1.0, 5.0) - 0.656 * dof;
  return 1.0 / (1.0 + std::exp(-z));
}

}  // namespace quadrille
