#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille {

/// The paper's 10-vector q = (A B C D E F G H I J).
using Vector10d = Eigen::Matrix<double, 10, 1>;

/// A quadric f(x) = [x 1] Q [x 1]ᵀ = Ax² + By² + Cz² + 2Dxy + 2Exz + 2Fyz + 2Gx + 2Hy + 2Iz + J
/// (paper, eq. 1 to 3). It is known only up to scale; the user chooses the sign of the gradient.
class Quadric {
 public:
  Quadric() = default;
  /// @param Q  4x4 symmetric
  explicit Quadric(const Eigen::Matrix4d& Q) : Q_(Q) {}
  /// @param q  the paper's 10-vector
  QUADRILLE_EXPORT explicit Quadric(const Vector10d& q);

  /// 4x4 symmetric matrix Q.
  const Eigen::Matrix4d& matrix() const { return Q_; }
  /// The 10-vector q.
  QUADRILLE_EXPORT Vector10d coefficients() const;
  /// Returns this surface with |q| = 1 and the sign unchanged; if q is zero, returns it as it is.
  QUADRILLE_EXPORT Quadric normalized() const;
  /// Returns this surface with the opposite gradient.
  Quadric flipped() const { return Quadric(Eigen::Matrix4d(-Q_)); }

  /// The algebraic distance f(x).
  QUADRILLE_EXPORT double value(const Eigen::Vector3d& x) const;
  /// The gradient ∇f(x).
  QUADRILLE_EXPORT Eigen::Vector3d gradient(const Eigen::Vector3d& x) const;
  /// The signed first-order distance f(x) / |∇f(x)| [m]; infinite where the gradient vanishes.
  QUADRILLE_EXPORT double distance(const Eigen::Vector3d& x) const;

  /// Returns the values of t at which the line o + t d crosses the quadric, the smaller magnitude
  /// first; a value is not finite if the line has no such crossing. A line that only touches the
  /// quadric or lies within it does not cross it.
  QUADRILLE_EXPORT std::array<double, 2> crossings(const Eigen::Vector3d& o,
                                                   const Eigen::Vector3d& d) const;

  /// Returns the quadric moved by a rigid motion, which holds X·x for each x of this one: Q_B =
  /// X_BA⁻ᵀ Q_A X_BA⁻¹.
  QUADRILLE_EXPORT Quadric transformed(const Eigen::Isometry3d& X_BA) const;
  /// Returns the quadric mapped by an invertible projective map of homogeneous points, x_B ~ P_BA
  /// x_A.
  /// @throws std::invalid_argument if P_BA is singular or not finite
  QUADRILLE_EXPORT Quadric transformed(const Eigen::Projective3d& P_BA) const;

  /// The dual quadric Q*, the locus of the planes Π with Πᵀ Q* Π = 0 that touch this one (paper,
  /// definition 2). It is the adjugate of Q, which is ~ Q⁻¹ if Q has full rank and exists always:
  /// it has rank 1 for cones and cylinders, and is zero for pairs of planes.
  QUADRILLE_EXPORT Eigen::Matrix4d dual() const;

 private:
  Eigen::Matrix4d Q_ = Eigen::Matrix4d::Zero();
};

}  // namespace quadrille
