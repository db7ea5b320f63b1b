#include "fits/normalise.hpp"

#include <Eigen/SVD>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace quadrille {
namespace {

// An extent below this share of the largest extent counts as rounding error.
constexpr double kFlat = 1e-7;

bool has_spread(const OrientedPointsd::Matrix& centred, Spread spread) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(Eigen::Matrix3d(centred * centred.transpose()));
  // The singular values of the scatter are squared extents.
  const double min_square = kFlat * kFlat * svd.singularValues()[0];
  return svd.singularValues()[static_cast<int>(spread) - 1] > min_square;
}

}  // namespace

std::optional<NormalisedPoints> normalise(const OrientedPointsd& points, Eigen::Index min_size,
                                          Spread spread, NormalLengths lengths) {
  if (points.points.cols() != points.normals.cols()) {
    throw std::invalid_argument("fit: the numbers of points and normals differ");
  }
  if (points.size() < min_size || points.size() == 0) return std::nullopt;
  if (!points.points.allFinite() || !points.normals.allFinite()) return std::nullopt;
  const Eigen::RowVectorXd norms = points.normals.colwise().norm();
  if (!(norms.minCoeff() > 1e-12 * norms.maxCoeff())) return std::nullopt;
  NormalisedPoints result;
  result.local = normalisation_about_centroid(
      static_cast<std::size_t>(points.size()), Radius::kLargest,
      [&](std::size_t i) { return points.points.col(static_cast<Eigen::Index>(i)); });
  const auto& [centre, scale] = result.local;
  // The coordinates of coincident points differ only by rounding.
  if (!(scale > 1e-12 * centre.norm()) || !std::isfinite(scale)) return std::nullopt;
  result.data.points = (points.points.colwise() - centre) / scale;
  if (!has_spread(result.data.points, spread)) return std::nullopt;
  if (lengths == NormalLengths::kUnit) {
    result.data.normals = points.normals.array().rowwise() / norms.array();
  } else {
    result.data.normals = points.normals / std::sqrt(norms.array().square().mean());
  }
  return result;
}

Quadric oriented(const Quadric& Q, const OrientedPointsd& points) {
  double agreement = 0.0;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d g = Q.gradient(points.points.col(i));
    const double slope = g.norm();
    if (slope > 0.0) agreement += g.dot(points.normals.col(i)) / slope;
  }
  return agreement < 0.0 ? Q.flipped() : Q;
}

double NormalisedPoints::rounding() const {
  return std::numeric_limits<double>::epsilon() * (1.0 + local.centre.norm() / local.scale);
}

std::optional<Quadric> NormalisedPoints::undo(const Quadric& Q) const {
  const Eigen::Matrix4d& M = Q.matrix();
  const double size = M.norm();
  if (!M.allFinite() || !(size > 0.0) || M.topRows<3>().norm() < 1e-9 * size) return std::nullopt;
  const Quadric unit(Eigen::Matrix4d(M / size));
  return local.to_frame(oriented(unit, data).matrix()).normalized();
}

}  // namespace quadrille
