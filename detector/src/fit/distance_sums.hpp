#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>

#include "fit/oriented_points.hpp"

namespace quadrille {

using Matrix11d = Eigen::Matrix<double, 11, 11>;

/// Some of the points of a fit, and a quadric's values there.
template <typename Scalar>
struct PointChunk;

/// Sums over the first-order distances r = f / |∇f| of points from quadrics, in the coordinates and
/// the unit of the points. The points are laid out once for all quadrics. Most of the time goes
/// into the normal equations, which a fit does not need where it ends.
template <typename Scalar>
class DistanceSums {
 public:
  explicit DistanceSums(const OrientedPoints<Scalar>& points);
  ~DistanceSums();

  /// Number of points.
  Eigen::Index points() const { return points_; }
  /// Sets the quadric for squares() and normal_equations(), before which it must be called.
  /// @return itself
  DistanceSums& evaluate(const Eigen::Matrix4d& Q);
  /// Sum of the squares of r.
  double squares() const;
  /// The 11x11 matrix [JᵀJ Jᵀr; rᵀJ rᵀr], where J = dr/dq. Rows are in the order of q, the residual
  /// last; its last element is squares().
  Matrix11d normal_equations() const;
  /// The normal equations if each residual were one unit, [JᵀJ Jᵀ1; 1ᵀJ n]: the equations of the
  /// step by which a fit follows its points if all of them move up their gradients by a unit.
  Matrix11d offset_equations() const;

 private:
  /// Sums of the products of J's columns and a last one, r or ones.
  Matrix11d products(bool ones) const;
  std::span<PointChunk<Scalar>> chunks() const;

  Eigen::Index points_;
  std::unique_ptr<PointChunk<Scalar>[]> chunks_;
  /// The least length that a gradient counts as.
  Scalar min_slope_ = 0;
};

}  // namespace quadrille
