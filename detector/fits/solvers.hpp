#pragma once

#include <Eigen/Core>
#include <optional>

namespace quadrille {

/// True if an eigenvalue of sums of squares is so large that rounding of the sums moves a solution
/// by less than 5e-8 of the points' extent. Rounding moves an eigenvector, or the solution of
/// normal equations, by about 2e-16 of the largest eigenvalue over this one.
bool is_above_rounding(double eigenvalue, double largest);

/// True if the first of ascending eigenvalues is not a multiple one: the second is above rounding.
bool is_unique(const Eigen::VectorXd& ascending);

/// The unit vector that minimises qᵀSq for a symmetric S ≥ 0; nullopt if it is not unique.
std::optional<Eigen::VectorXd> smallest_eigenvector(const Eigen::MatrixXd& S);

/// The vector that minimises qᵀSq subject to qᵀGq = 1, for symmetric S, G ≥ 0; nullopt if it is not
/// unique, if rounding decides whether qᵀGq = 0 for some q, or if a vector with qᵀGq = 0 fits
/// exactly.
std::optional<Eigen::VectorXd> smallest_eigenvector(const Eigen::MatrixXd& S,
                                                    const Eigen::MatrixXd& G);

/// The solution of the normal equations S q = b; nullopt if S is (nearly) singular.
std::optional<Eigen::VectorXd> solve_normal_equations(const Eigen::MatrixXd& S,
                                                      const Eigen::VectorXd& b);

}  // namespace quadrille
