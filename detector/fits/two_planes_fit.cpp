#include "fits/two_planes_fit.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "fits/solvers.hpp"

namespace quadrille {
namespace {

using Planes = std::array<Eigen::Vector4d, 2>;

constexpr Eigen::Index kStarts = 24;
constexpr int kRounds = 20;

/// Distance from a plane, or the deviation of the normal as a length within the unit ball,
/// whichever is larger.
double misfit(const OrientedPointsd& p, Eigen::Index i, const Eigen::Vector4d& plane) {
  const double distance = std::abs(plane.dot(p.points.col(i).homogeneous()));
  const double sine = plane.head<3>().cross(p.normals.col(i)).norm();
  return std::max(distance, 0.3 * sine);
}

int nearest(const OrientedPointsd& p, Eigen::Index i, const Planes& planes) {
  return misfit(p, i, planes[1]) < misfit(p, i, planes[0]) ? 1 : 0;
}

Eigen::Vector4d plane_of(const OrientedPoint& point) {
  return {point.n.x(), point.n.y(), point.n.z(), -point.n.dot(point.x)};
}

double total_misfit(const OrientedPointsd& p, const Planes& planes) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < p.size(); ++i) {
    sum += misfit(p, i, planes[nearest(p, i, planes)]);
  }
  return sum;
}

/// The point that a plane explains worst.
Eigen::Index farthest(const OrientedPointsd& p, const Eigen::Vector4d& plane) {
  Eigen::Index worst = 0;
  for (Eigen::Index i = 1; i < p.size(); ++i) {
    if (misfit(p, i, plane) > misfit(p, worst, plane)) worst = i;
  }
  return worst;
}

Planes best_start(const OrientedPointsd& p) {
  Planes best;
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](const Planes& planes) {
    const double sum = total_misfit(p, planes);
    if (sum < least) least = sum, best = planes;
  };
  const Eigen::Index stride = std::max<Eigen::Index>(1, (p.size() + kStarts - 1) / kStarts);
  for (Eigen::Index i = 0; i < p.size(); i += stride) {
    const Eigen::Vector4d first = plane_of(p.at(i));
    // The few points of a small plane may all be left out by the stride.
    offer({first, plane_of(p.at(farthest(p, first)))});
    for (Eigen::Index j = i + stride; j < p.size(); j += stride) offer({first, plane_of(p.at(j))});
  }
  return best;
}

/// Fits the plane of the points on one side by their scatter.
std::optional<Eigen::Vector4d> refit(const OrientedPointsd& p, const std::vector<int>& side,
                                     int which) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  int count = 0;
  for (Eigen::Index i = 0; i < p.size(); ++i) {
    if (side[i] != which) continue;
    const Eigen::Vector3d x = p.points.col(i);
    mean += x;
    scatter += x * x.transpose();
    ++count;
  }
  if (count < 3) return std::nullopt;
  mean /= count;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(
      Eigen::Matrix3d(scatter - count * mean * mean.transpose()));
  if (!is_unique(eigen.eigenvalues())) return std::nullopt;
  const Eigen::Vector3d n = eigen.eigenvectors().col(0);
  return Eigen::Vector4d(n.x(), n.y(), n.z(), -n.dot(mean));
}

}  // namespace

std::optional<Quadric> fit_two_planes(const OrientedPointsd& points) {
  const auto normalised = normalise(points, 6, Spread::kSpace);
  if (!normalised) return std::nullopt;
  const OrientedPointsd& data = normalised->data;
  Planes planes = best_start(data);
  std::vector<int> side(data.size(), -1);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<int> next(data.size());
    for (Eigen::Index i = 0; i < data.size(); ++i) next[i] = nearest(data, i, planes);
    if (next == side) break;
    side = next;
    for (int which = 0; which < 2; ++which) {
      const auto plane = refit(data, side, which);
      if (!plane) return std::nullopt;
      planes[which] = *plane;
    }
  }
  return normalised->undo(Quadric(
      Eigen::Matrix4d(planes[0] * planes[1].transpose() + planes[1] * planes[0].transpose())));
}

}  // namespace quadrille
