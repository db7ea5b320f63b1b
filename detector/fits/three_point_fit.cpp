#include "fits/three_point_fit.hpp"

#include <cmath>

#include "variants/gradient_scales.hpp"

namespace quadrille {
namespace {

// These only prevent division by zero; the estimated error decides how flat a triangle may be.
constexpr double kMinArea = 1e-9, kMinHeight = 1e-9;

std::optional<Eigen::Matrix4d> solve(const OrientedPointsd& points) {
  const auto pencil = make_scaled_pencil({points.at(0), points.at(1), points.at(2)}, 0.0, kMinArea);
  if (!pencil) return std::nullopt;
  const Eigen::Vector4d x = points.points.col(3).homogeneous();
  const double z = pencil->plane.dot(x);
  if (!(std::abs(z) > kMinHeight)) return std::nullopt;
  return pencil->at(-x.dot(pencil->Q0 * x) / (z * z));
}

}  // namespace

std::optional<MinimalFit> fit_three_points(const OrientedPointsd& points) {
  if (points.size() < 4) return std::nullopt;
  const auto normalised = normalise(points.first(4), 4, Spread::kSpace);
  if (!normalised) return std::nullopt;
  return fit_with_error(*normalised, 3, solve);
}

}  // namespace quadrille
