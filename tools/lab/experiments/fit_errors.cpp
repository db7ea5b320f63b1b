#include "lab/experiments/fit_errors.hpp"

#include <algorithm>
#include <cmath>

#include "fits/projection.hpp"

namespace quadrille::experiments {
namespace {

/// Returns the lengths of the gradient at the points, scaled to a mean of 1; zeros if all vanish.
Eigen::ArrayXd gradient_lengths(const Quadric& Q, const OrientedPointsd& points) {
  Eigen::ArrayXd lengths(points.size());
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    lengths[i] = Q.gradient(points.points.col(i)).norm();
  }
  const double mean = lengths.mean();
  return mean > 0.0 ? Eigen::ArrayXd(lengths / mean) : lengths;
}

}  // namespace

FitErrors errors_of(const std::optional<Quadric>& fit, const Quadric& truth,
                    const OrientedPointsd& points, double size) {
  if (!fit) return {1.0, 1.0, 1.0};
  FitErrors errors;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d x = points.points.col(i), g = fit->gradient(x);
    const auto foot = project(*fit, x);
    errors.point += foot ? std::min(1.0, (*foot - x).norm() / size) : 1.0;
    errors.angle += g.norm() > 0.0 ? 1.0 - g.normalized().dot(points.normals.col(i)) : 1.0;
  }
  const double count = static_cast<double>(points.size());
  errors.point /= count;
  errors.angle /= count;
  const Eigen::ArrayXd gap = gradient_lengths(*fit, points) - gradient_lengths(truth, points);
  errors.gradient = std::min(1.0, gap.abs().mean());
  return errors;
}

}  // namespace quadrille::experiments
