#pragma once

#include <Eigen/Core>
#include <vector>

namespace quadrille {

/// Pairs rows with columns, each at most once, such that the sum of costs is least; each row that
/// stays alone costs `alone`. This is Kuhn's (Hungarian) method with potentials, which takes a time
/// of O((rows + columns)^3).
///
/// A greedy choice would take the cheapest pair first and leave the rest to the others, which swaps
/// objects that pass each other.
/// @param cost  costs, not negative; a pair whose cost is at least `alone` or not finite is never
///   made
/// @return the column of each row; -1 for a row that stays alone. Depends only on the values
/// @throws std::invalid_argument if alone is not positive and finite
std::vector<int> assign(const Eigen::MatrixXd& cost, double alone);

}  // namespace quadrille
