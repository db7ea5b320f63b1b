#include "fit/closed_form/initial_general.hpp"

#include "fit/closed_form/taubin.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille {
namespace {

// Keeps the weight positive definite despite sums in single precision.
constexpr double kRidge = 1e-9;

}  // namespace

std::optional<PosedQuadric> initial_general(const PointMoments& moments) {
  if (moments.size < 9) return std::nullopt;
  const auto solution = least_taubin(moments.values, kRidge);
  if (!solution) return std::nullopt;
  PosedQuadric general;
  general.D = Quadric(*solution).matrix();
  general.D /= general.D.norm();
  return general;
}

}  // namespace quadrille
