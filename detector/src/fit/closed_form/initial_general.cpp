#include "fit/closed_form/initial_general.hpp"

#include "fit/closed_form/taubin.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille {
namespace {

// Keeps the weight positive definite despite sums in single precision.
constexpr double kRidge = 1e-9;

}  // namespace

std::optional<PosedQuadric> initial_general(const OrientedPointsf& points) {
  if (points.size() < 9) return std::nullopt;
  const auto solution = solve_taubin(scatter_of_values(points), kRidge);
  if (!solution) return std::nullopt;
  PosedQuadric general;
  general.D = Quadric(solution->q).matrix();
  general.D /= general.D.norm();
  return general;
}

}  // namespace quadrille
