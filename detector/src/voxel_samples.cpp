#include "quadrille/detector/voxel_samples.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille {
namespace {

constexpr std::size_t kNeighbours = 8;
// Radius within which voxels are neighbours, in voxels.
constexpr float kNextReach = 1.9f;
constexpr float kLeastSigma = 1e-4f, kUsualSigma = 1e-3f;
constexpr std::size_t kLeastPatches = 8, kLeastInPatch = 18;

/// Running sums of offsets from a point near them, for a plane by principal components.
struct PlaneSums {
  float n = 0;
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  /// Sums of xx, yy, zz and of xy, yz, zx.
  Eigen::Array3f squares = Eigen::Array3f::Zero(), products = Eigen::Array3f::Zero();

  void add(const Eigen::Vector3f& d) {
    n += 1;
    sum += d;
    squares += d.array().square();
    products += d.array() * Eigen::Array3f(d.y(), d.z(), d.x());
  }
  /// Mean of the offsets, and the direction of their least spread.
  /// @return false if they are few or lie on a line
  bool solve(Eigen::Vector3f* mean, Eigen::Vector3f* normal) const {
    if (n < 4) return false;
    *mean = sum / n;
    Eigen::Matrix3f square = squares.matrix().asDiagonal();
    square(0, 1) = square(1, 0) = products[0];
    square(1, 2) = square(2, 1) = products[1];
    square(2, 0) = square(0, 2) = products[2];
    const Eigen::Matrix3d S = (square / n - *mean * mean->transpose()).cast<double>();
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
    eigen.computeDirect(S);
    if (!(eigen.eigenvalues()[1] > 0.05 * eigen.eigenvalues()[2])) return false;
    *normal = eigen.eigenvectors().col(0).cast<float>();
    return normal->allFinite();
  }
};

/// Residual of a quadratic height over the plane of the points; negative if they are few.
/// @param points  relative to a point near them [m]
float quadratic_residual(const std::vector<Eigen::Vector3f>& points, float radius) {
  PlaneSums sums;
  for (const Eigen::Vector3f& p : points) sums.add(p);
  Eigen::Vector3f mean, normal;
  if (points.size() < kLeastInPatch || !sums.solve(&mean, &normal)) return -1.0f;
  const Eigen::Vector3f e1 = normal.unitOrthogonal(), e2 = normal.cross(e1);
  Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> b = Eigen::Matrix<double, 6, 1>::Zero();
  double hh = 0;
  for (const Eigen::Vector3f& p : points) {
    const Eigen::Vector3f d = (p - mean) / radius;
    const double s = d.dot(e1), t = d.dot(e2), h = d.dot(normal);
    Eigen::Matrix<double, 6, 1> row;
    row << 1, s, t, s * s, s * t, t * t;
    A += row * row.transpose();
    b += h * row;
    hh += h * h;
  }
  const Eigen::Matrix<double, 6, 1> a = A.ldlt().solve(b);
  const double rss = std::max(0.0, hh - a.dot(b));
  return radius * static_cast<float>(std::sqrt(rss / static_cast<double>(points.size() - 6)));
}

/// Appends the nearest voxels of the list of (squared distance, voxel) to the neighbours.
void add_nearest(std::vector<std::pair<float, int>>* list, std::vector<int>* neighbours) {
  if (list->size() > kNeighbours) {
    std::nth_element(list->begin(), list->begin() + kNeighbours, list->end());
    list->resize(kNeighbours);
  }
  for (const auto& [distance, voxel] : *list) neighbours->push_back(voxel);
}

}  // namespace

SurfaceSamples make_voxel_samples(const VoxelGrid& grid, const std::vector<char>& keep, float sigma,
                                  const Eigen::Vector3f& eye, float reach) {
  const float edge = grid.edge();
  const float next = kNextReach * edge * kNextReach * edge;
  SurfaceSamples samples;
  samples.first.push_back(0);
  std::vector<int> sample_of(static_cast<std::size_t>(grid.size()), -1);
  std::vector<std::pair<float, int>> nearest;
  VoxelFinder finder(grid, reach * edge, keep);
  std::vector<int> voxels;  // the neighbours, before all samples are known
  for (int v = 0; v < grid.size(); ++v) {
    if (!keep[v]) continue;
    const Eigen::Vector3f p = grid.mean()[v];
    nearest.clear();
    PlaneSums sums;
    finder.visit(p, [&](int other, const Eigen::Vector3f& offset, float distance) {
      sums.add(offset);
      if (other != v && distance <= next) nearest.emplace_back(distance, other);
    });
    Eigen::Vector3f mean, n;
    if (!sums.solve(&mean, &n)) continue;
    if (n.dot(eye - p) < 0) n = -n;
    sample_of[v] = samples.size();
    samples.p.push_back(p + n * n.dot(mean));
    samples.n.push_back(n);
    samples.raw.push_back(p);
    samples.sigma.push_back(sigma);
    samples.cell.push_back(edge);
    samples.count.push_back(grid.count()[v]);
    samples.source.push_back(v);
    add_nearest(&nearest, &voxels);
    samples.first.push_back(static_cast<int>(voxels.size()));
  }
  // Voxels without a normal are nobody's neighbours.
  int begin = 0;
  for (int i = 0; i < samples.size(); ++i) {
    const int end = samples.first[i + 1];
    for (int k = begin; k < end; ++k) {
      const int other = sample_of[voxels[k]];
      if (other >= 0) samples.neighbours.push_back(other);
    }
    samples.first[i + 1] = static_cast<int>(samples.neighbours.size());
    begin = end;
  }
  return samples;
}

float measure_noise(const VoxelGrid& grid, const NoiseOptions& options) {
  const float radius = std::max(static_cast<float>(options.radius), 3.0f * grid.edge());
  std::vector<float> residual;
  std::vector<Eigen::Vector3f> patch;
  VoxelFinder finder(grid, radius);
  const int stride = std::max(1, grid.size() / options.patches);
  for (int v = 0; v < grid.size(); v += stride) {
    const Eigen::Vector3f p = grid.mean()[v];
    patch.clear();
    finder.visit(p, [&](int, const Eigen::Vector3f& offset, float) { patch.push_back(offset); });
    const float r = quadratic_residual(patch, radius);
    if (r >= 0) residual.push_back(r);
  }
  if (residual.size() < kLeastPatches) return kUsualSigma;
  const auto at =
      residual.begin() +
      static_cast<std::ptrdiff_t>(options.quantile * static_cast<double>(residual.size() - 1));
  std::nth_element(residual.begin(), at, residual.end());
  return std::max(kLeastSigma, *at);
}

}  // namespace quadrille
