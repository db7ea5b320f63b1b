#include "fits/taubin_fit.hpp"

#include "fits/scatter.hpp"
#include "fits/solvers.hpp"

namespace quadrille {

std::optional<Quadric> fit_taubin(const OrientedPoints& points) {
  const auto normalised = normalise(points, 9, Spread::kSpace);
  if (!normalised) return std::nullopt;
  const Scatter scatter(normalised->data);
  const auto q =
      smallest_eigenvector(Eigen::MatrixXd(scatter.values), Eigen::MatrixXd(scatter.gradients));
  if (!q) return std::nullopt;
  return normalised->undo(Quadric(Vector10d(*q)));
}

}  // namespace quadrille
