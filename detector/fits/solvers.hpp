#pragma once

#include <Eigen/Core>
#include <optional>

namespace quadrille {

/// True if the first of ascending eigenvalues is not a multiple one: the second is clearly above
/// zero.
bool is_unique(const Eigen::VectorXd& ascending);

/// The unit vector that minimises qᵀSq for a symmetric S ≥ 0; nullopt if it is not unique.
std::optional<Eigen::VectorXd> smallest_eigenvector(const Eigen::MatrixXd& S);

/// The vector that minimises qᵀSq subject to qᵀGq = 1, for symmetric S, G ≥ 0; nullopt if it is not
/// unique, or if a vector with qᵀGq = 0 fits exactly.
std::optional<Eigen::VectorXd> smallest_eigenvector(const Eigen::MatrixXd& S,
                                                    const Eigen::MatrixXd& G);

/// The solution of the normal equations S q = b; nullopt if S is (nearly) singular.
std::optional<Eigen::VectorXd> solve_normal_equations(const Eigen::MatrixXd& S,
                                                      const Eigen::VectorXd& b);

}  // namespace quadrille
