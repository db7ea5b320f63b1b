#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>
#include <optional>
#include <vector>

#include "fit/distance_sums.hpp"
#include "fit/family_fit.hpp"
#include "fit/oriented_points.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille {

/// Returns the quadric after a step in a family's parameters: shapes, then motions.
PosedQuadric moved(Family family, PosedQuadric quadric,
                   const Eigen::Ref<const Eigen::VectorXd>& step);

/// Minimises the sum of squared first-order distances f / |∇f| within a family by
/// Levenberg-Marquardt. Residuals and derivatives are taken with respect to q, where they are the
/// same for all families, and projected onto the family's tangent space dq/dθ.
/// @param points  left at any quadric
/// @param wanted  sum of squares of interest; the fit may stop early if it will not reach it
/// @param min_gain  a step that promises a smaller share of the residual is not evaluated
/// @return nullopt if the start is degenerate or no finite step exists
template <typename Scalar>
std::optional<FamilyFit> refine(DistanceSums<Scalar>* points, Family family,
                                const PosedQuadric& start, int iterations,
                                double wanted = std::numeric_limits<double>::infinity(),
                                double min_gain = 1e-4);

/// Refines a single fit to these points. To fit several families to the same points, lay them out
/// once as DistanceSums.
template <typename Scalar>
std::optional<FamilyFit> refine(const OrientedPoints<Scalar>& points, Family family,
                                const PosedQuadric& start, int iterations,
                                double wanted = std::numeric_limits<double>::infinity(),
                                double min_gain = 1e-4) {
  DistanceSums<Scalar> sums(points);
  return refine(&sums, family, start, iterations, wanted, min_gain);
}

/// The Gauss-Newton equations A step = −b of a quadric's first-order distances in a family's
/// parameters: A = JᵀJ and b = Jᵀr. The parameters are shapes, then motions.
struct StepEquations {
  Eigen::MatrixXd A;
  Eigen::VectorXd b;
  /// Sum of squares rᵀr.
  double rss = 0.0;
};

/// The equations at a posed quadric, which the points are left at.
StepEquations step_equations(DistanceSums<float>* points, Family family,
                             const PosedQuadric& quadric);

/// How the points of a fit determine the family's parameters: shapes, then motions.
struct FitInformation {
  /// JᵀJ, where J holds the derivatives of the residuals by the parameters.
  Eigen::MatrixXd JtJ;
  /// Jᵀ1. If all points move up their gradients by δ, the parameters change by −(JᵀJ)⁻¹ Jᵀ1 δ.
  Eigen::VectorXd Jt1;
};

FitInformation information(const OrientedPointsf& points, const FamilyFit& fit);

}  // namespace quadrille
