#include "lab/experiments/neighbourhood.hpp"

#include <array>
#include <cmath>

#include "lab/experiments/random_quadric.hpp"

namespace quadrille::experiments {
namespace {

// Radius of a neighbourhood, as a share of the radius of the ball that holds the quadric's points.
constexpr double kRadius = 0.6;

/// Returns points of a random quadric within a ball around one of them, scaled to the unit ball.
OrientedPointsd random_piece(Eigen::Index count, RandomStream& random) {
  const Quadric Q = random_quadric(curved_type(random.below(kCurvedTypes)), random);
  const Eigen::Vector3d centre = sample(Q, 1, random).points.col(0);
  OrientedPointsd piece(count);
  Eigen::Index found = 0;
  while (found < count) {
    const OrientedPointsd more = sample(Q, count, random);
    for (Eigen::Index i = 0; i < more.size() && found < count; ++i) {
      const Eigen::Vector3d x = (more.points.col(i) - centre) / kRadius;
      if (x.norm() > 1.0) continue;
      piece.points.col(found) = x;
      piece.normals.col(found++) = more.normals.col(i);
    }
  }
  return piece;
}

/// Returns a random point of a plane within the unit ball.
OrientedPoint on_plane(const Eigen::Vector3d& n, double height, RandomStream& random) {
  const Eigen::Vector3d side = n.unitOrthogonal(), other = n.cross(side);
  const double radius = std::sqrt((1.0 - height * height) * random.uniform());
  const double angle = 2.0 * M_PI * random.uniform();
  return {height * n + radius * (std::cos(angle) * side + std::sin(angle) * other), n};
}

void add_planes(OrientedPointsd* points, Eigen::Index from, RandomStream& random) {
  std::array<Eigen::Vector3d, 3> normals;
  std::array<double, 3> heights;
  for (int k = 0; k < 3; ++k) {
    normals[k] = random_direction(random);
    heights[k] = 1.4 * random.uniform() - 0.7;
  }
  for (Eigen::Index i = from; i < points->size(); ++i) {
    const OrientedPoint point = on_plane(normals[i % 3], heights[i % 3], random);
    points->points.col(i) = point.x;
    points->normals.col(i) = point.n;
  }
}

OrientedPointsf to_voters(const OrientedPointsd& points) {
  OrientedPointsf voters(points.size());
  voters.points = points.points.cast<float>();
  voters.normals = points.normals.cast<float>();
  return voters;
}

void shuffle(OrientedPointsd* points, RandomStream& random) {
  for (int i = static_cast<int>(points->size()) - 1; i > 0; --i) {
    const int j = random.below(i + 1);
    points->points.col(i).swap(points->points.col(j));
    points->normals.col(i).swap(points->normals.col(j));
  }
}

}  // namespace

Neighbourhood random_neighbourhood(const NeighbourhoodOptions& options, RandomStream& random) {
  const auto count = static_cast<Eigen::Index>(
      std::lround((1.0 - options.outliers) * static_cast<double>(options.size)));
  Neighbourhood result;
  result.truth = random_piece(count, random);
  result.points = OrientedPointsd(options.size);
  result.points.points.leftCols(count) = result.truth.points;
  result.points.normals.leftCols(count) = result.truth.normals;
  add_planes(&result.points, count, random);
  add_point_noise(&result.points, options.point_noise, random);
  add_normal_noise(&result.points, options.normal_noise, random);
  shuffle(&result.points, random);
  result.voters = to_voters(result.points);
  return result;
}

bool is_found(const Quadric& Q, const Neighbourhood& neighbourhood, double distance) {
  const OrientedPointsd& truth = neighbourhood.truth;
  Eigen::Index on = 0;
  for (Eigen::Index i = 0; i < truth.size(); ++i) {
    const Eigen::Vector3d x = truth.points.col(i), g = Q.gradient(x);
    if (std::abs(Q.distance(x)) <= distance && g.dot(truth.normals.col(i)) >= 0.9 * g.norm()) ++on;
  }
  return 10 * on >= 9 * truth.size();
}

}  // namespace quadrille::experiments
