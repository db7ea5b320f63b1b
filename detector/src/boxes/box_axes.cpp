#include "boxes/box_axes.hpp"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <limits>

#include "base/convex_hull.hpp"

namespace quadrille {
namespace {

/// Direction of a side of the smallest rectangle around a hull.
Eigen::Vector2d smallest_rectangle(const std::vector<Eigen::Vector2d>& hull) {
  Eigen::Vector2d best = Eigen::Vector2d::UnitX();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const Eigen::Vector2d u = (hull[(k + 1) % hull.size()] - hull[k]).normalized();
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& p : hull) {
      box.extend(Eigen::Vector2d(u.dot(p), u.x() * p.y() - u.y() * p.x()));
    }
    if (box.sizes().prod() < least) {
      least = box.sizes().prod();
      best = u;
    }
  }
  return best;
}

/// Axes of a single face: its normal, and the sides of the smallest rectangle around its points.
Eigen::Matrix3d axes_of_rectangle(const Face& face) {
  const Eigen::Vector3d e1 = face.n_C.unitOrthogonal(), e2 = face.n_C.cross(e1);
  std::vector<Eigen::Vector2d> places;
  for (const Eigen::Vector3d& p : face.points_C) {
    const Eigen::Vector3d x = p - face.middle_C;
    places.emplace_back(e1.dot(x), e2.dot(x));
  }
  const Eigen::Vector2d u = smallest_rectangle(convex_hull(std::move(places)));
  Eigen::Matrix3d R;
  R.col(0) = face.n_C;
  R.col(1) = u.x() * e1 + u.y() * e2;
  R.col(2) = R.col(0).cross(R.col(1));
  return R;
}

}  // namespace

Eigen::Matrix3d box_axes(const std::vector<const Face*>& faces) {
  if (faces.size() == 1) return axes_of_rectangle(*faces.front());
  Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const double weight = static_cast<double>(faces[i]->points_C.size());
    S.col(static_cast<Eigen::Index>(i)) = weight * faces[i]->n_C;
  }
  if (faces.size() == 2) {
    // The third axis is determined by the two normals, so it gets a negligible weight.
    S.col(2) = 1e-6 * faces[0]->n_C.cross(faces[1]->n_C) * S.norm();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(S, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d R = svd.matrixU() * svd.matrixV().transpose();
  if (R.determinant() < 0.0) R.col(2) *= -1.0;
  return R;
}

}  // namespace quadrille
