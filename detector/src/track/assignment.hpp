#pragma once

#include <Eigen/Core>
#include <vector>

namespace quadrille {

/// Pairs rows with columns, each at most once, so that the sum of the costs is least, where each
/// row that stays alone costs as much as `alone`: the method of Kuhn (Hungarian) with potentials,
/// O((rows + columns)^3).
///
/// A greedy choice takes the cheapest pair first and leaves what is left to the others; where
/// objects pass each other that swaps them.
/// @param cost  not negative; a pair that costs `alone` or more, or is not finite, is never made
/// @return the column of each row; -1 for one that stays alone. Depends on the values only
/// @throws std::invalid_argument if alone is not positive and finite
std::vector<int> assign(const Eigen::MatrixXd& cost, double alone);

}  // namespace quadrille
