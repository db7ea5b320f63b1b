#include "surfaces/wall_thickness.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "fit/family_spec.hpp"
#include "fit/geometric_fit.hpp"
#include "samples/region.hpp"
#include "surfaces/surface_fit.hpp"

namespace quadrille {
namespace {

// Number of steps of the fit, which starts near its end.
constexpr int kThicknessSteps = 4;
// Number of points of each side that suffice: the samples of a region are worth about 40
// independent ones; see Surface::effective_size.
constexpr std::size_t kSidePoints = 200;
// Step of the numeric derivatives, in local coordinates, in which a surface has about size 1.
constexpr double kDifference = 1e-4;

/// Some points of one side, in the surface's local coordinates.
OrientedPointsf points_of_side(const Surface& surface, const SurfaceSamples& samples,
                               const std::vector<int>& side) {
  const std::vector<int> some = spread_evenly(side, kSidePoints);
  return fit_points(samples, some, surface.local, static_cast<int>(some.size()));
}

/// The distance from x to the quadric xᵀQx = 0 along the gradient at x. It is exact for spheres and
/// circular cylinders, where the first-order distance is off by d²/2R.
double distance_along_gradient(const Eigen::Matrix4d& Q, const Eigen::Vector3d& x) {
  const Eigen::Vector4d h = Q * x.homogeneous();
  const double f = x.homogeneous().dot(h), slope = h.head<3>().norm();
  const Eigen::Vector3d n = h.head<3>() / slope;
  const double root = slope * slope - f * n.dot(Q.topLeftCorner<3, 3>() * n);
  return f / (slope + std::sqrt(std::max(0.0, root)));
}

/// The residuals of all points, of `up` first, for a thickness t.
Eigen::VectorXd residuals(const OrientedPointsf& up, const OrientedPointsf& down,
                          const PosedQuadric& posed, double t) {
  const Eigen::Matrix4d Q = posed.matrix();
  Eigen::VectorXd r(up.size() + down.size());
  Eigen::Index k = 0;
  for (const auto& x : up.points.colwise()) r[k++] = distance_along_gradient(Q, x.cast<double>());
  for (const auto& x : down.points.colwise()) {
    r[k++] = distance_along_gradient(Q, x.cast<double>()) + t;
  }
  return r;
}

/// The residuals r, and J = dr/d(θ, t).
struct ThicknessEquations {
  Eigen::VectorXd r;
  Eigen::MatrixXd J;
};

ThicknessEquations thickness_equations(const OrientedPointsf& up, const OrientedPointsf& down,
                                       Family family, const PosedQuadric& posed, double t) {
  const FamilySpec& spec = family_spec(family);
  const auto count = static_cast<Eigen::Index>(spec.shapes.size() + spec.motions.size());
  ThicknessEquations result{residuals(up, down, posed, t),
                            Eigen::MatrixXd::Zero(up.size() + down.size(), count + 1)};
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::VectorXd step = kDifference * Eigen::VectorXd::Unit(count, k);
    result.J.col(k) = (residuals(up, down, moved(family, posed, step), t) -
                       residuals(up, down, moved(family, posed, -step), t)) /
                      (2.0 * kDifference);
  }
  result.J.col(count).tail(down.size()).setOnes();
  return result;
}

/// The last diagonal element of (JᵀJ)⁻¹: one over the squared length of the last column's part that
/// is square to the others.
double last_cofactor(const Eigen::MatrixXd& J) {
  const auto others = J.leftCols(J.cols() - 1);
  const Eigen::VectorXd last = J.col(J.cols() - 1);
  const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition(others);
  return 1.0 / (last - others * decomposition.solve(last)).squaredNorm();
}

}  // namespace

SeenSides sides_of(const Quadric& quadric, const SurfaceSamples& samples,
                   std::span<const int> region) {
  const Eigen::Matrix4f Q = quadric.matrix().cast<float>();
  SeenSides sides;
  for (const int i : region) {
    const Eigen::Vector3f h = (Q * samples.raw[i].homogeneous()).head<3>();
    (h.dot(samples.n[i]) > 0.0f ? sides.up : sides.down).push_back(i);
  }
  return sides;
}

std::optional<MeasuredThickness> wall_thickness(const Surface& surface,
                                                const SurfaceSamples& samples,
                                                const SeenSides& sides) {
  if (sides.up.empty() || sides.down.empty()) return std::nullopt;
  const OrientedPointsf up = points_of_side(surface, samples, sides.up);
  const OrientedPointsf down = points_of_side(surface, samples, sides.down);
  PosedQuadric posed = surface.fit.posed;
  double t = 0.0;
  for (int step = 0; step < kThicknessSteps; ++step) {
    const ThicknessEquations now = thickness_equations(up, down, surface.fit.family, posed, t);
    const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> J(now.J);
    const Eigen::VectorXd change = -J.solve(now.r);
    if (!change.allFinite()) return std::nullopt;
    posed = moved(surface.fit.family, posed, change.head(change.size() - 1));
    t += change[change.size() - 1];
  }
  const ThicknessEquations last = thickness_equations(up, down, surface.fit.family, posed, t);
  const auto size = static_cast<double>(last.r.size());
  // Residuals below the noise are chance.
  const double noise = mean_sigma(samples, surface.region) / surface.local.scale;
  const double variance =
      std::max(noise * noise, last.r.squaredNorm() / size) * size / surface.effective_size;
  const double cofactor = last_cofactor(last.J);
  if (!std::isfinite(cofactor)) return std::nullopt;
  return MeasuredThickness{surface.local.scale * t,
                           surface.local.scale * std::sqrt(variance * cofactor)};
}

}  // namespace quadrille
