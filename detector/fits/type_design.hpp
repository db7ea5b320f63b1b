#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string_view>

#include "fits/linear_system.hpp"

namespace quadrille {

/// A design restricts the ten coefficients to q = B θ, with one column per parameter. It is the
/// paper's "minor redesign of A", whose type-specific matrix is A B.
using Design = Eigen::Matrix<double, 10, Eigen::Dynamic>;

/// The design of g·x + j, with 4 parameters.
Design plane_design();
/// The design of a|x|² + g·x + j, with 5 parameters.
Design sphere_design();
/// The design of a|x|² + b(u·x)² + g·x + j about an axis of direction u, with 6 parameters.
Design spheroid_design(const Eigen::Vector3d& u);
/// The design of a|x − (u·x) u|² + g·x + j, where g is orthogonal to the axis of direction u, with
/// 4 parameters.
Design cylinder_design(const Eigen::Vector3d& u);
/// The design of any conic extruded along u, with 6 parameters.
Design extrusion_design(const Eigen::Vector3d& u);
/// The design of any quadric whose quadratic part vanishes along u, as a paraboloid's does along
/// its axis, with 7 parameters.
Design paraboloid_design(const Eigen::Vector3d& u);
/// The design of a|x − p|² + b(u·(x − p))² with apex p and axis u, with 2 parameters.
Design cone_design(const Eigen::Vector3d& p, const Eigen::Vector3d& u);
/// The design of any cone of second order with apex p, with 6 parameters.
Design elliptic_cone_design(const Eigen::Vector3d& p);

/// The system A B θ = n.
LinearSystem restricted(const LinearSystem& system, const Design& B);

/// A row of the paper's table of voting spaces (figure 2b), or one of the two rows that we add.
struct VotingSpace {
  std::string_view type;
  /// Number of oriented points |b| in a basis, and number of dimensions left to the vote: the
  /// columns of A B minus its rank for the basis.
  int basis, dimensions;
};

/// Plane 1/0, two planes 2/0, sphere 1/1 and spheroid 2/3 are as printed. Cylinder 2/0 and cone 3/0
/// follow by the same count, since axis and apex follow from the normals. The printed spheroid does
/// not exploit its symmetry: 10 − rank 7 = 3 holds for every quadric through two oriented points.
inline constexpr std::array<VotingSpace, 6> kVotingSpaces = {{{"plane", 1, 0},
                                                              {"two_planes", 2, 0},
                                                              {"sphere", 1, 1},
                                                              {"spheroid", 2, 3},
                                                              {"cylinder", 2, 0},
                                                              {"cone", 3, 0}}};

/// Least squares of f = 0 and of the tangent constraints w t·∇f = 0 within a design, under Taubin's
/// constraint that the squared gradient has mean 1.
/// @param points  in the same normalised coordinates as the design
/// @return nullopt if another member of the design fits equally well
std::optional<Quadric> fit_design(const OrientedPointsd& points, const Design& B, double weight);

}  // namespace quadrille
