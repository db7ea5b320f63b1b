#include "surfaces/uncertainty.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/family_spec.hpp"

namespace quadrille {
namespace {

// The noise of a fit that is each point's own, over that of independent noise with the same
// residuals. This and the next five were fitted to the errors of 2,000 dimensions in scenes with
// exact truth, of generated and of simulated stereo, structured light and time of flight.
constexpr double kOwnFactor = 1.4;
// Standard deviation of a mean of noise that all neighbours share, in rms residuals.
constexpr double kSharedShare = 0.64;
// How fast the noise counts as shared, over the correlation of neighbours' residuals and the share
// of common noise, each above what chance gives.
constexpr double kCorrelationRate = 4.8, kChanceCorrelation = 0.033;
constexpr double kCommonRate = 2.4, kChanceCommon = 0.053;
// Semi-axes of one ellipsoid, where the simplest one that explains the samples is published, differ
// from it by this share.
constexpr double kRoundnessStd = 0.12;
// A dimension that the samples show no better than this share of its value is a guess.
constexpr double kGuessShare = 0.5;
// Points for the information of a family that was not fitted, as many as other fits take.
constexpr int kInformationPoints = 240;
// Eigenvalues of the information below this share of the largest: rounding is all there is.
constexpr double kMinInformationShare = 1e-10;
// Directions of the parameters, of bodies about as large as the unit, that are no better known.
constexpr double kOpenStd = 0.5;

/// Parameters and how the samples determine them.
struct Information {
  Family family;
  /// JᵀJ of `points` residuals.
  Eigen::MatrixXd sum;
  double points;
};

/// That an ellipsoid is one of revolution is mostly our choice and not the scene's: it is weighed
/// as any quadric.
Information information_of(const Surface& surface, const SurfaceSamples& samples,
                           QuadricType type) {
  const FamilyFit& fit = surface.fit;
  if (type == QuadricType::kEllipsoid && fit.family != Family::kGeneral) {
    const OrientedPointsf points =
        fit_points(samples, surface.region, surface.local, kInformationPoints);
    const std::optional<FamilyFit> at = refine(points, Family::kGeneral, fit.posed, 0);
    if (at) return {Family::kGeneral, at->information, static_cast<double>(at->points)};
  }
  return {fit.family, fit.information, static_cast<double>(fit.points)};
}

/// Variance of the mean of the noise, in the squared unit of the fit.
double variance_of_mean(const Surface& surface, double common_noise) {
  const double n = surface.fit.points;
  const double free = std::max(1.0, n - family_spec(surface.fit.family).dof);
  const double shared =
      kCorrelationRate * std::max(0.0, surface.evidence.correlation - kChanceCorrelation) +
      kCommonRate * std::max(0.0, common_noise - kChanceCommon);
  return surface.fit.rss / n *
         (kOwnFactor / free + kSharedShare * kSharedShare * -std::expm1(-shared));
}

/// The derivative of a function of the fit by the family's parameters, by finite differences.
template <class Function>
Eigen::MatrixXd derivative(const PosedQuadric& at, Family family, const Eigen::VectorXd& steps,
                           const Function& f) {
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

/// Dimensions of a posed quadric; none where it is of another type.
Eigen::VectorXd dimensions_of(const PosedQuadric& quadric, QuadricType type) {
  const CanonicalForm form = canonical_form(quadric);
  if (form.type != type) return {};
  Eigen::VectorXd values(static_cast<Eigen::Index>(form.dimensions.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    values[i] = form.dimensions[static_cast<std::size_t>(i)].second;
  }
  return values;
}

/// Unit q in frame C of a quadric in local coordinates, on the side of q0.
Vector10d coefficients_of(const PosedQuadric& quadric, const Normalisation& local,
                          const Vector10d& q0) {
  const Vector10d q = local.to_frame(quadric.matrix()).normalized().coefficients();
  return q.dot(q0) < 0 ? Vector10d(-q) : q;
}

/// Deviation of a dimension that the samples give with one, published for the simplest type.
double published_std(double value, double std, QuadricType type) {
  if (std > kGuessShare * std::abs(value)) return std::numeric_limits<double>::infinity();
  if (type != QuadricType::kEllipsoid) return std;
  const double prior = kRoundnessStd * std::abs(value);
  return std * prior / std::hypot(std, prior);
}

}  // namespace

Uncertainty uncertainty_of(const Surface& surface, const SurfaceSamples& samples,
                           const CanonicalForm& form) {
  const Information information = information_of(surface, samples, form.type);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(information.sum);
  const double min_known = kMinInformationShare * eigen.eigenvalues().tail<1>()[0];
  const double variance = variance_of_mean(surface, samples.common_noise) * information.points;
  const Eigen::VectorXd variances =
      eigen.eigenvalues().unaryExpr([&](double l) { return l > min_known ? variance / l : 0.0; });
  const Eigen::MatrixXd& V = eigen.eigenvectors();
  const Eigen::VectorXd std = (V * variances.asDiagonal() * V.transpose()).diagonal().cwiseSqrt();
  const Eigen::VectorXd steps = (1e-3 * std).cwiseMax(1e-6).cwiseMin(1e-3);

  Uncertainty result;
  const Eigen::MatrixXd dimensions =
      derivative(surface.fit.posed, information.family, steps,
                 [&](const PosedQuadric& at) { return dimensions_of(at, form.type); }) *
      V * variances.cwiseSqrt().asDiagonal();
  for (std::size_t i = 0; i < form.dimensions.size(); ++i) {
    const double own = dimensions.row(static_cast<Eigen::Index>(i)).norm();
    result.std.push_back(published_std(form.dimensions[i].second, own, form.type));
  }

  const Vector10d q0 = surface.Q.normalized().coefficients();
  const Eigen::MatrixXd q =
      derivative(surface.fit.posed, information.family, steps,
                 [&](const PosedQuadric& at) {
                   return Eigen::VectorXd(coefficients_of(at, surface.local, q0));
                 }) *
      V;
  Eigen::MatrixXd open = q;
  for (Eigen::Index k = 0; k < variances.size(); ++k) {
    const bool known = eigen.eigenvalues()[k] > min_known && variances[k] < kOpenStd * kOpenStd;
    if (!known) continue;
    result.covariance.known += variances[k] * q.col(k) * q.col(k).transpose();
    open.col(k).setZero();
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(open);
  result.covariance.open = qr.householderQ() * Eigen::MatrixXd::Identity(10, qr.rank());
  return result;
}

}  // namespace quadrille
