#pragma once

#include <array>
#include <optional>
#include <vector>

#include "fits/normalise.hpp"

namespace quadrille {

/// A row of the paper's table of minimal fits (figure 2a): the number of points of the quadric, and
/// the number of them whose tangent planes are used.
struct PrimalDual {
  int points;
  int planes;
};

/// PD-0 to PD-3. Each point gives one constraint and its tangent plane two more, so these have 9,
/// 9, 9 and 10 constraints for 9 degrees of freedom. Three oriented points alone have the squared
/// data plane as a solution (theorem 1), so PD-3 needs a fourth point and is overdetermined by one.
inline constexpr std::array<PrimalDual, 4> kPrimalDual = {{{9, 0}, {7, 1}, {5, 2}, {4, 3}}};

/// The minimal fit to points, the first of which have tangent planes: the null vector of the rows
/// vᵢᵀ of all points and t·∇vᵢᵀ for both tangents t of the oriented ones. For PD-3 with noise it is
/// the singular vector of the least singular value.
/// @param points  at least `kind.points`; the first columns are used
/// @return nullopt if the points are too few, coplanar, or admit another solution
/// @throws std::invalid_argument if there are more planes than points or fewer than 9 constraints
std::optional<Quadric> fit_primal_dual(const OrientedPointsd& points, const PrimalDual& kind);

/// The quadrics through eight points that touch a given plane anywhere. The single dual constraint
/// Πᵀ Q* Π = 0 (definition 2) is a cubic in the pencil of the eight points, with one to three real
/// solutions.
/// @param points  3x8 positions
/// @param plane   Π with Πᵀ [x 1] = 0
/// @return all real solutions with |q| = 1 and arbitrary sign of the gradient; none for degenerate
///   points, if the whole pencil touches the plane, or if rounding could move a solution,
///   as that of most points of two planes, whose dual vanishes
/// @throws std::invalid_argument if there are not eight points
std::vector<Quadric> fit_eight_points_and_plane(const Eigen::Matrix3Xd& points,
                                                const Eigen::Vector4d& plane);

}  // namespace quadrille
