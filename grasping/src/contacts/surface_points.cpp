#include "contacts/surface_points.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <utility>

#include "base/point_buckets.hpp"

namespace quadrille {
namespace {

// Normals are taken over the points within so many cells; fewer points than the second number give
// none.
constexpr double kReachInCells = 3.2;
constexpr int kMinNeighbours = 6;

/// The mean of the points in each cell that one eye saw, and that eye.
struct Thinned {
  std::vector<Eigen::Vector3d> points, eyes;
};

/// A cell, and the eye that saw a point in it.
using Seen = std::pair<PointBuckets::Key, std::array<double, 3>>;

Thinned thinned(std::span<const Eigen::Vector3d> points, std::span<const Eigen::Vector3d> eyes,
                double cell) {
  std::vector<std::pair<Seen, std::size_t>> keyed;
  keyed.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d& eye = eyes[i];
    keyed.push_back({{PointBuckets::key_of(points[i], cell), {eye.x(), eye.y(), eye.z()}}, i});
  }
  std::sort(keyed.begin(), keyed.end());
  Thinned means;
  for (auto first = keyed.begin(); first != keyed.end();) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    auto last = first;
    for (; last != keyed.end() && last->first == first->first; ++last) sum += points[last->second];
    means.points.emplace_back(sum / static_cast<double>(last - first));
    means.eyes.push_back(eyes[first->second]);
    first = last;
  }
  return means;
}

}  // namespace

SurfacePoints surface_points(std::span<const Eigen::Vector3d> points_C, double cell,
                             std::span<const Eigen::Vector3d> eyes_C) {
  SurfacePoints surface;
  Thinned means = thinned(points_C, eyes_C, cell);
  surface.p_C = std::move(means.points);
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
        if (d.squaredNorm() > reach * reach || means.eyes[i] != means.eyes[j]) continue;
        sum += d;
        squares += d * d.transpose();
        ++count;
      }
      if (count < kMinNeighbours) continue;
      const Eigen::Vector3d mean = sum / count;
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
      solver.computeDirect(squares / count - mean * mean.transpose());
      const Eigen::Vector3d n = solver.eigenvectors().col(0);
      surface.n_C[i] = n.dot(means.eyes[i] - p) < 0.0 ? Eigen::Vector3d(-n) : n;
    }
  }
  return surface;
}

}  // namespace quadrille
