#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>
#include <optional>
#include <vector>

#include "fit/family_fit.hpp"
#include "fit/oriented_points.hpp"
#include "quadrille/detector/quadric_type.hpp"

namespace quadrille {

/// The quadric after a step in a family's parameters (shapes, then motions).
PosedQuadric moved(Family family, PosedQuadric quadric,
                   const Eigen::Ref<const Eigen::VectorXd>& step);

/// Least squares of the first-order distance f / |∇f| within a family, from a start, by
/// Levenberg-Marquardt. Residuals and their derivatives are taken in the space of q, where they
/// are the same for all families, and projected onto the family's tangent space dq/dθ.
/// @param wanted  sum of squares of interest: the fit may stop early where it will not get there
/// @param min_gain  a step that promises less than this share of the residual is not worth its
///                  evaluation
/// @return nullopt if the start is degenerate or no finite step exists
template <typename Scalar>
std::optional<FamilyFit> refine(const OrientedPoints<Scalar>& points, Family family,
                                const PosedQuadric& start, int iterations,
                                double wanted = std::numeric_limits<double>::infinity(),
                                double min_gain = 1e-4);

}  // namespace quadrille
