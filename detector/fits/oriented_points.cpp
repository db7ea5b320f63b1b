#include "fits/oriented_points.hpp"

#include <Eigen/SVD>
#include <cmath>
#include <stdexcept>

namespace quadrille {
namespace {

// Below this share of the largest extent, an extent counts as rounding.
constexpr double kFlat = 1e-7;

bool has_spread(const Eigen::Matrix3Xd& centred, Spread spread) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(Eigen::Matrix3d(centred * centred.transpose()));
  // Singular values of the scatter are squared extents.
  const double least = kFlat * kFlat * svd.singularValues()[0];
  return svd.singularValues()[static_cast<int>(spread) - 1] > least;
}

}  // namespace

OrientedPoints OrientedPoints::first(Eigen::Index count) const {
  if (points.cols() != normals.cols()) {
    throw std::invalid_argument("fit: the numbers of points and normals differ");
  }
  OrientedPoints part;
  part.points = points.leftCols(count);
  part.normals = normals.leftCols(count);
  return part;
}

std::optional<NormalisedPoints> normalise(const OrientedPoints& points, Eigen::Index least,
                                          Spread spread, NormalLengths lengths) {
  if (points.points.cols() != points.normals.cols()) {
    throw std::invalid_argument("fit: the numbers of points and normals differ");
  }
  if (points.size() < least || points.size() == 0) return std::nullopt;
  if (!points.points.allFinite() || !points.normals.allFinite()) return std::nullopt;
  const Eigen::RowVectorXd norms = points.normals.colwise().norm();
  if (!(norms.minCoeff() > 1e-12 * norms.maxCoeff())) return std::nullopt;
  NormalisedPoints result;
  result.centre = points.points.rowwise().mean();
  const Eigen::Matrix3Xd centred = points.points.colwise() - result.centre;
  result.scale = centred.colwise().norm().maxCoeff();
  // Coincident points differ by rounding alone.
  if (!(result.scale > 1e-12 * result.centre.norm()) || !std::isfinite(result.scale)) {
    return std::nullopt;
  }
  result.data.points = centred / result.scale;
  if (!has_spread(result.data.points, spread)) return std::nullopt;
  if (lengths == NormalLengths::kUnit) {
    result.data.normals = points.normals.array().rowwise() / norms.array();
  } else {
    result.data.normals = points.normals / std::sqrt(norms.array().square().mean());
  }
  return result;
}

Quadric oriented(const Quadric& Q, const OrientedPoints& points) {
  double agreement = 0.0;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d g = Q.gradient(points.points.col(i));
    const double slope = g.norm();
    if (slope > 0.0) agreement += g.dot(points.normals.col(i)) / slope;
  }
  return agreement < 0.0 ? Q.flipped() : Q;
}

std::optional<Quadric> NormalisedPoints::undo(const Quadric& Q) const {
  const Eigen::Matrix4d& M = Q.matrix();
  const double size = M.norm();
  if (!M.allFinite() || !(size > 0.0) || M.topRows<3>().norm() < 1e-9 * size) return std::nullopt;
  Eigen::Projective3d T = Eigen::Projective3d::Identity();
  T.matrix().topLeftCorner<3, 3>() *= scale;
  T.matrix().topRightCorner<3, 1>() = centre;
  const Quadric back = oriented(Quadric(Eigen::Matrix4d(M / size)), data).transformed(T);
  return back.normalized();
}

}  // namespace quadrille
