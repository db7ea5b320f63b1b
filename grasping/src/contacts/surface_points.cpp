#include "contacts/surface_points.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <utility>

#include "contacts/point_buckets.hpp"

namespace quadrille {
namespace {

// Normals are taken over the points within so many cells; fewer points than the second number give
// none.
constexpr double kReachInCells = 3.2;
constexpr int kMinNeighbours = 6;

std::vector<Eigen::Vector3d> thinned(std::span<const Eigen::Vector3d> points, double cell) {
  std::vector<std::pair<PointBuckets::Key, Eigen::Vector3d>> keyed;
  keyed.reserve(points.size());
  for (const Eigen::Vector3d& p : points) keyed.emplace_back(PointBuckets::key_of(p, cell), p);
  std::stable_sort(keyed.begin(), keyed.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Eigen::Vector3d> means;
  for (auto first = keyed.begin(); first != keyed.end();) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    auto last = first;
    for (; last != keyed.end() && last->first == first->first; ++last) sum += last->second;
    means.emplace_back(sum / static_cast<double>(last - first));
    first = last;
  }
  return means;
}

}  // namespace

SurfacePoints surface_points(std::span<const Eigen::Vector3d> points_C, double cell,
                             const Eigen::Vector3d& viewpoint_C) {
  SurfacePoints surface;
  surface.p_C = thinned(points_C, cell);
  surface.n_C.assign(surface.p_C.size(), Eigen::Vector3d::Zero());
  const double reach = kReachInCells * cell;
  const PointBuckets buckets(surface.p_C, reach);
  for (std::size_t n = 0; n < buckets.keys().size(); ++n) {
    const std::vector<int> near = buckets.near(buckets.keys()[n]);
    for (const int i : buckets.members(n)) {
      const Eigen::Vector3d& p = surface.p_C[i];
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
      int count = 0;
      for (const int j : near) {
        const Eigen::Vector3d d = surface.p_C[j] - p;
        if (d.squaredNorm() > reach * reach) continue;
        sum += d;
        squares += d * d.transpose();
        ++count;
      }
      if (count < kMinNeighbours) continue;
      const Eigen::Vector3d mean = sum / count;
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
      solver.computeDirect(squares / count - mean * mean.transpose());
      const Eigen::Vector3d n = solver.eigenvectors().col(0);
      surface.n_C[i] = n.dot(viewpoint_C - p) < 0.0 ? Eigen::Vector3d(-n) : n;
    }
  }
  return surface;
}

}  // namespace quadrille
