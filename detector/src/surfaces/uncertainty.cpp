#include "surfaces/uncertainty.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "fit/family_spec.hpp"
#include "surfaces/evidence/effective_share.hpp"

namespace quadrille {
namespace {

// Prior standard deviation, as a share, of the differences between an ellipsoid's semi-axes and
// those of the simplest form that explains the samples, which is published.
constexpr double kRoundnessStd = 0.12;
// A dimension is a guess if its standard deviation exceeds this share of its value.
constexpr double kGuessShare = 0.5;
// A sensor that smooths its image may move a whole surface along its normals. This is the standard
// deviation of that motion if neighbouring cells share all of their noise, as a share of a cell's
// edge. It makes the errors of radii on simulated stereo, structured light and time of flight most
// likely.
constexpr double kOffsetShare = 0.8;
// Share of that motion by which one place of a surface may differ from another. With a third the
// two sides of cups that time of flight bends get one axis; residuals alone do not tell, since a
// fit follows what bends.
constexpr double kUnevenShare = 0.33;
// Directions of the parameter space with a larger standard deviation count as undetermined; bodies
// have about unit size.
constexpr double kOpenStd = 0.5;

/// A family's parameters, and how well the samples determine them.
struct Information {
  Family family;
  FitInformation sum;
  /// Number of residuals in the sum.
  double points;
};

/// Returns the information of a fit. An ellipsoid of revolution is mostly our choice and not the
/// scene's, so its information is that of a general quadric.
Information information_of(const Surface& surface, const SurfaceSamples& samples,
                           QuadricType type) {
  const FamilyFit& fit = surface.fit;
  if (type == QuadricType::kEllipsoid && fit.family != Family::kGeneral) {
    const OrientedPointsf points = fit_points(samples, surface.region, surface.local, fit.points);
    const std::optional<FamilyFit> at = refine(points, Family::kGeneral, fit.posed, 0);
    if (at) return {Family::kGeneral, information(points, *at), static_cast<double>(at->points)};
  }
  return {fit.family, surface.information, static_cast<double>(fit.points)};
}

/// True if neighbours share more of their noise than by chance. The correlation of N samples with
/// about 4 N pairs of neighbours varies by 1 / √(4 N) if there is none; twice that counts as
/// chance.
bool shares_noise(const Surface& surface) {
  const double size = static_cast<double>(surface.region.size());
  return surface.evidence.correlation >= 1.0 / std::sqrt(size);
}

/// Number of views that show the surface; one that shows less of it than another counts less.
double effective_views(const Surface& surface, const SurfaceSamples& samples) {
  std::map<std::size_t, double> shown;
  for (const int i : surface.region) shown[samples.view_of(i)] += 1.0;
  double squares = 0.0;
  for (const auto& [view, count] : shown) squares += count * count;
  const double size = static_cast<double>(surface.region.size());
  return size * size / squares;
}

/// Dimensions of a posed quadric; empty if it is of another type.
Eigen::VectorXd dimensions_of(const PosedQuadric& quadric, QuadricType type) {
  const CanonicalForm form = canonical_form(quadric);
  if (form.type != type) return {};
  Eigen::VectorXd values(static_cast<Eigen::Index>(form.dimensions.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    values[i] = form.dimensions[static_cast<std::size_t>(i)].second;
  }
  return values;
}

/// Unit vector q in frame C of a quadric in local coordinates, with the sign of q0.
Vector10d coefficients_of(const PosedQuadric& quadric, const Normalisation& local,
                          const Vector10d& q0) {
  const Vector10d q = local.to_frame(quadric.matrix()).normalized().coefficients();
  return q.dot(q0) < 0 ? Vector10d(-q) : q;
}

/// Standard deviation that is published for a dimension, given the one from the samples: infinite
/// for a guess, and reduced by the prior for ellipsoids.
double published_std(double value, double std, QuadricType type) {
  if (std > kGuessShare * std::abs(value)) return std::numeric_limits<double>::infinity();
  if (type != QuadricType::kEllipsoid) return std;
  const double prior = kRoundnessStd * std::abs(value);
  return std * prior / std::hypot(std, prior);
}

}  // namespace

Eigen::MatrixXd derivative(const PosedQuadric& at, Family family, const Eigen::VectorXd& steps,
                           const std::function<Eigen::VectorXd(const PosedQuadric&)>& f) {
  const Eigen::VectorXd f0 = f(at);
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(f0.size(), steps.size());
  for (Eigen::Index k = 0; k < steps.size(); ++k) {
    Eigen::VectorXd step = Eigen::VectorXd::Zero(steps.size());
    step[k] = steps[k];
    const Eigen::VectorXd f1 = f(moved(family, at, step));
    if (f1.size() == f0.size()) J.col(k) = (f1 - f0) / steps[k];
  }
  return J;
}

double offset_std(const Surface& surface, const SurfaceSamples& samples) {
  if (!shares_noise(surface)) return 0.0;
  double cells = 0.0;
  for (const int i : surface.region) cells += samples.cell[i];
  const double cell = cells / static_cast<double>(surface.region.size());
  const double share = std::sqrt(surface.evidence.correlation / effective_views(surface, samples));
  return kOffsetShare * share * cell / surface.local.scale;
}

double variance_of_mean(const Surface& surface) {
  const double n = surface.fit.points;
  const double free = std::max(1.0, n - family_spec(surface.fit.family).dof);
  const double averaged =
      surface.fit.rss / (n * free * effective_share(surface.evidence.correlation));
  return averaged + surface.common_error * surface.common_error;
}

double bend_variance(const Surface& surface) {
  if (!shares_noise(surface)) return 0.0;
  const double noise = std::pow(surface.evidence.sigma / surface.local.scale, 2);
  const double uneven = kUnevenShare * kOffsetShare * surface.evidence.cell / surface.local.scale;
  return std::max(uneven * uneven * surface.evidence.correlation,
                  surface.fit.rss / surface.fit.points - noise);
}

Uncertainty uncertainty_of(const Surface& surface, const SurfaceSamples& samples,
                           const CanonicalForm& form) {
  const Information information = information_of(surface, samples, form.type);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(information.sum.JtJ);
  // Smaller eigenvalues consist of rounding errors only.
  const double min_known =
      std::numeric_limits<double>::epsilon() * eigen.eigenvalues().tail<1>()[0];
  const Eigen::VectorXd inverse =
      eigen.eigenvalues().unaryExpr([&](double l) { return l > min_known ? 1.0 / l : 0.0; });
  const Eigen::MatrixXd& V = eigen.eigenvectors();
  const Eigen::VectorXd variances = variance_of_mean(surface) * information.points * inverse;
  const Eigen::VectorXd offset =
      offset_std(surface, samples) * inverse.asDiagonal() * (V.transpose() * information.sum.Jt1);
  const Eigen::VectorXd std = (V * variances.asDiagonal() * V.transpose()).diagonal().cwiseSqrt();
  const Eigen::VectorXd steps = (1e-3 * std).cwiseMax(1e-6).cwiseMin(1e-3);

  Uncertainty result;
  const Eigen::MatrixXd dimensions =
      derivative(surface.fit.posed, information.family, steps,
                 [&](const PosedQuadric& at) { return dimensions_of(at, form.type); }) *
      V;
  const Eigen::MatrixXd averaged = dimensions * variances.cwiseSqrt().asDiagonal();
  const Eigen::VectorXd together = dimensions * offset;
  for (std::size_t i = 0; i < form.dimensions.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double own = std::hypot(averaged.row(row).norm(), together[row]);
    result.std.push_back(published_std(form.dimensions[i].second, own, form.type));
  }

  const Vector10d q0 = surface.Q.normalized().coefficients();
  const Eigen::MatrixXd q =
      derivative(surface.fit.posed, information.family, steps,
                 [&](const PosedQuadric& at) {
                   return Eigen::VectorXd(coefficients_of(at, surface.local, q0));
                 }) *
      V;
  Vector10d q_offset = Vector10d::Zero();
  Eigen::MatrixXd open = q;
  for (Eigen::Index k = 0; k < variances.size(); ++k) {
    const bool known = eigen.eigenvalues()[k] > min_known && variances[k] < kOpenStd * kOpenStd;
    if (!known) continue;
    result.covariance.known += variances[k] * q.col(k) * q.col(k).transpose();
    q_offset += offset[k] * q.col(k);
    open.col(k).setZero();
  }
  result.covariance.known += q_offset * q_offset.transpose();
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(open);
  if (qr.rank() > 0) {
    result.covariance.open = qr.householderQ() * Eigen::MatrixXd::Identity(10, qr.rank());
  }
  return result;
}

}  // namespace quadrille
