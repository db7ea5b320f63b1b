#include "fits/compact_fit.hpp"

#include <cmath>

#include "fits/scatter.hpp"
#include "fits/solvers.hpp"
#include "search/basis.hpp"

namespace quadrille {

std::optional<Quadric> fit_compact(const OrientedPointsd& points,
                                   const CompactFitOptions& options) {
  const auto normalised = normalise(points, 4, Spread::kSpace, NormalLengths::kAsGiven);
  if (!normalised) return std::nullopt;
  const Scatter scatter(normalised->data);
  const double w2 = options.weight * options.weight;
  const auto q =
      solve_normal_equations(scatter.values + w2 * scatter.gradients, w2 * scatter.alignment);
  if (!q) return std::nullopt;
  return normalised->undo(Quadric(Vector10d(*q)));
}

std::optional<Quadric> fit_three_and_one(const OrientedPointsd& points) {
  if (points.size() < 4) return std::nullopt;
  const auto normalised = normalise(points.first(4), 4, Spread::kSpace, NormalLengths::kAsGiven);
  if (!normalised) return std::nullopt;
  const OrientedPointsd& data = normalised->data;
  const auto pencil = make_pencil({data.at(0), data.at(1), data.at(2)});
  if (!pencil) return std::nullopt;
  const Eigen::Vector4d x = data.points.col(3).homogeneous();
  const double z = pencil->plane.dot(x);
  if (!(std::abs(z) > 1e-7)) return std::nullopt;
  const double lambda = -x.dot(pencil->Q0 * x) / (z * z);
  return normalised->undo(Quadric(pencil->at(lambda)));
}

}  // namespace quadrille
