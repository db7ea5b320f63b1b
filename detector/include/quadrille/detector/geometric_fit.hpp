#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>
#include <optional>
#include <vector>

#include "quadrille/detector/canonical.hpp"
#include "quadrille/detector/family.hpp"

namespace quadrille {

/// Oriented points for a fit, in a frame where they fill about the unit ball around the origin
/// (Hartley's normalisation, which the paper asks for).
struct FitPoints {
  /// Coordinates and unit normals, one entry per point.
  Eigen::ArrayXf x, y, z, nx, ny, nz;

  explicit FitPoints(Eigen::Index size = 0)
      : x(size), y(size), z(size), nx(size), ny(size), nz(size) {}
  Eigen::Index size() const { return x.size(); }
  Eigen::Vector3d point(Eigen::Index i) const {
    return Eigen::Vector3f(x[i], y[i], z[i]).cast<double>();
  }
  Eigen::Vector3d normal(Eigen::Index i) const {
    return Eigen::Vector3f(nx[i], ny[i], nz[i]).cast<double>();
  }
};

/// A quadric as a canonical matrix D in a pose X: Q = X⁻ᵀ D X⁻¹.
struct PosedQuadric {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  Eigen::Matrix4d D = Eigen::Matrix4d::Zero();
  Eigen::Matrix4d matrix() const;
};

/// The canonical form of a family's fit, whose zeros are exact but for rounding.
CanonicalForm canonical_form(const PosedQuadric& fit);

/// A fit of one family.
struct FamilyFit {
  Family family = Family::kGeneral;
  PosedQuadric posed;
  /// Sum of squared first-order distances |f| / |∇f|, in the squared unit of the points.
  double rss = 0.0;
  /// Number of points.
  int points = 0;
  /// JᵀJ of the residuals with respect to the family's parameters (shapes, then motions).
  Eigen::MatrixXd information;
};

/// The quadric after a step in a family's parameters (shapes, then motions).
PosedQuadric moved(Family family, PosedQuadric quadric,
                   const Eigen::Ref<const Eigen::VectorXd>& step);

/// Least squares of the first-order distance within a family, from a start, by
/// Levenberg-Marquardt. Residuals and their derivatives are taken in the space of q, where they
/// are the same for all families, and projected onto the family's tangent space dq/dθ.
/// @param wanted  sum of squares of interest: the fit may stop early where it will not get there
/// @return nullopt if the start is degenerate or no finite step exists
std::optional<FamilyFit> refine(const FitPoints& points, Family family, const PosedQuadric& start,
                                int iterations,
                                double wanted = std::numeric_limits<double>::infinity());

}  // namespace quadrille
