#include "fits/three_level_fit.hpp"

#include "fits/scatter.hpp"
#include "fits/solvers.hpp"

namespace quadrille {

std::optional<Quadric> fit_three_level(const OrientedPointsd& points,
                                       const ThreeLevelOptions& options) {
  const auto normalised = normalise(points, 4, Spread::kSpace);
  if (!normalised) return std::nullopt;
  const OrientedPointsd& data = normalised->data;
  Matrix10d S = Matrix10d::Zero();
  Vector10d b = Vector10d::Zero();
  for (Eigen::Index i = 0; i < data.size(); ++i) {
    for (const double level : {-options.offset, 0.0, options.offset}) {
      const Vector10d v = monomials(data.points.col(i) + level * data.normals.col(i));
      S += v * v.transpose();
      b += level * v;
    }
  }
  const auto q = solve_normal_equations(S, b);
  if (!q) return std::nullopt;
  return normalised->undo(Quadric(Vector10d(*q)));
}

}  // namespace quadrille
