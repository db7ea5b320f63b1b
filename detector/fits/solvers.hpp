#pragma once

#include <Eigen/Core>
#include <optional>

namespace quadrille {

/// True if the first of ascending eigenvalues is the only one of its size.
bool is_unique(const Eigen::VectorXd& ascending);

/// The unit vector of least qᵀSq for a symmetric S ≥ 0; nullopt if another one is as good.
std::optional<Eigen::VectorXd> smallest_eigenvector(const Eigen::MatrixXd& S);

/// The vector of least qᵀSq with qᵀGq = 1, for symmetric S, G ≥ 0; nullopt if another one is as
/// good, or if one with qᵀGq = 0 fits exactly.
std::optional<Eigen::VectorXd> smallest_eigenvector(const Eigen::MatrixXd& S,
                                                    const Eigen::MatrixXd& G);

/// The solution of the normal equations S q = b; nullopt if S is (nearly) singular.
std::optional<Eigen::VectorXd> solve_normal_equations(const Eigen::MatrixXd& S,
                                                      const Eigen::VectorXd& b);

}  // namespace quadrille
