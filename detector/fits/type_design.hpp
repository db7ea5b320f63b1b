#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string_view>

#include "fits/linear_system.hpp"

namespace quadrille {

/// A design restricts the ten coefficients to q = B θ, one column a parameter: the paper's "minor
/// redesign of A", whose type-specific matrix is A B.
using Design = Eigen::Matrix<double, 10, Eigen::Dynamic>;

/// g·x + j: 4 parameters.
Design plane_design();
/// a|x|² + g·x + j: 5 parameters.
Design sphere_design();
/// a|x|² + b(u·x)² + g·x + j about an axis of direction u: 6 parameters.
Design spheroid_design(const Eigen::Vector3d& u);
/// a|x − (u·x) u|² + g·x + j with g across the axis of direction u: 4 parameters.
Design cylinder_design(const Eigen::Vector3d& u);
/// Any conic extruded along u: 6 parameters.
Design extrusion_design(const Eigen::Vector3d& u);
/// Any quadric whose quadratic part vanishes along u, as a paraboloid's along its axis: 7
/// parameters.
Design paraboloid_design(const Eigen::Vector3d& u);
/// a|x − p|² + b(u·(x − p))² with the apex p and the axis u: 2 parameters.
Design cone_design(const Eigen::Vector3d& p, const Eigen::Vector3d& u);
/// Any cone of second order with the apex p: 6 parameters.
Design elliptic_cone_design(const Eigen::Vector3d& p);

/// The system A B θ = n.
LinearSystem restricted(const LinearSystem& system, const Design& B);

/// A row of the paper's table of voting spaces (figure 2b), and our two.
struct VotingSpace {
  std::string_view type;
  /// Oriented points |b| in a basis, and dimensions that remain for the vote: the columns of A B
  /// minus its rank for the basis.
  int basis, dimensions;
};

/// Plane 1/0, two planes 2/0, sphere 1/1 and spheroid 2/3 as printed; cylinder 2/0 and cone 3/0 by
/// the same count, as their axis and apex follow from the normals. The printed spheroid does not
/// use that it is one: 10 − rank 7 = 3 holds for every quadric through two oriented points.
inline constexpr std::array<VotingSpace, 6> kVotingSpaces = {{{"plane", 1, 0},
                                                              {"two_planes", 2, 0},
                                                              {"sphere", 1, 1},
                                                              {"spheroid", 2, 3},
                                                              {"cylinder", 2, 0},
                                                              {"cone", 3, 0}}};

/// Least squares of f = 0 and of the tangent constraints w t·∇f = 0 within a design, under Taubin's
/// constraint that the squared gradient has mean 1.
/// @param points  in normalised coordinates, as the design is
/// @return nullopt if another member of the design fits as well
std::optional<Quadric> fit_design(const OrientedPointsd& points, const Design& B, double weight);

}  // namespace quadrille
