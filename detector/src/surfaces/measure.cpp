#include "surfaces/measure.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/quantile.hpp"
#include "fit/family_spec.hpp"
#include "quadrille/detector/canonical.hpp"

namespace quadrille {
namespace {

// Share of the samples beyond each end of the extent: stray ones do not stretch it.
constexpr double kTrimmedShare = 0.004;
// Bins of which those that hold a sample were seen.
constexpr int kBinsAround = 24, kBinsAlong = 8;
// The variance of a fit's noise over that of independent noise with the same residuals, as measured
// in generated scenes: rounded depths and mixed pixels make neighbours alike.
constexpr double kNoiseFactor = 1.5;
// Noise that neighbours have in common comes in waves. So many samples lie on one, and count as one
// measurement of it.
constexpr double kSamplesPerWave = 64.0;
// Points for the information of a family that was not fitted, as many as other fits take.
constexpr int kInformationPoints = 240;
// Eigenvalues of the information below this share of the largest: the data leave the direction
// open.
constexpr double kMinInformationShare = 1e-10;
// At an edge the last cells are mixed or lost: deviation of an extent, in cells.
constexpr double kEdgeCells = 3.0;

/// Positions of the region in the canonical frame.
std::vector<Eigen::Vector3d> canonical_points(const Surface& surface, const SurfaceSamples& samples,
                                              const Eigen::Isometry3d& X_CQ) {
  const Eigen::Isometry3d X_QC = X_CQ.inverse();
  std::vector<Eigen::Vector3d> points;
  points.reserve(surface.region.size());
  for (const int i : surface.region) points.push_back(X_QC * samples.raw[i].cast<double>());
  return points;
}

Eigen::AlignedBox3d trimmed_box(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d low, high;
  std::vector<double> x(points.size());
  const auto trim = static_cast<std::size_t>(kTrimmedShare * static_cast<double>(points.size()));
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t k = 0; k < points.size(); ++k) x[k] = points[k][axis];
    low[axis] = nth_smallest(x, trim);
    high[axis] = nth_smallest(x, x.size() - 1 - trim);
  }
  return {low, high};
}

bool extends_along_z(QuadricType type) {
  return type == QuadricType::kCylinder || type == QuadricType::kEllipticCylinder ||
         type == QuadricType::kHyperbolicCylinder || type == QuadricType::kIntersectingPlanes;
}

/// Turns the frame by half a turn about x so that z points the other way.
void flip_z(Eigen::Isometry3d* X) {
  X->linear().col(1) *= -1.0;
  X->linear().col(2) *= -1.0;
}

/// x along the longest extent of the points across z.
void align_x(const std::vector<Eigen::Vector3d>& points, Eigen::Isometry3d* X) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector3d& p : points) mean += p.head<2>();
  mean /= static_cast<double>(points.size());
  Eigen::Matrix2d S = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector3d& p : points) {
    S += (p.head<2>() - mean) * (p.head<2>() - mean).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(S);
  const Eigen::Vector2d d = eigen.eigenvectors().col(1);
  X->linear() =
      X->linear() * Eigen::AngleAxisd(std::atan2(d.y(), d.x()), Eigen::Vector3d::UnitZ()).matrix();
}

/// Resolves what a quadric leaves open: signs of axes, origin along them, x of a plane.
void settle_frame(const Surface& surface, const SurfaceSamples& samples, const Eigen::Vector3d& eye,
                  QuadricType type, Eigen::Isometry3d* X_CQ) {
  const Eigen::Vector3d towards = eye - X_CQ->translation();
  if (type == QuadricType::kPlane) {
    if (X_CQ->linear().col(2).dot(towards) < 0) flip_z(X_CQ);
    align_x(canonical_points(surface, samples, *X_CQ), X_CQ);
  } else if (extends_along_z(type) && X_CQ->linear().col(2).dot(towards) < 0) {
    flip_z(X_CQ);
  } else if (type == QuadricType::kCone) {
    // z points from the apex into the seen part.
    double sum = 0;
    for (const Eigen::Vector3d& p : canonical_points(surface, samples, *X_CQ)) sum += p.z();
    if (sum < 0) flip_z(X_CQ);
  }
  const Eigen::AlignedBox3d box = trimmed_box(canonical_points(surface, samples, *X_CQ));
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  if (extends_along_z(type)) shift.z() = box.center().z();
  if (type == QuadricType::kParabolicCylinder) shift.y() = box.center().y();
  if (is_flat(type) && type != QuadricType::kIntersectingPlanes) {
    shift.head<2>() = box.center().head<2>();
  }
  X_CQ->translation() = *X_CQ * shift;
}

/// Bins around z and along it, within the extent, that hold a sample. Equal steps of z are equal
/// areas on a sphere, and nearly so on the other round surfaces.
double share_seen(const std::vector<Eigen::Vector3d>& points, const Eigen::AlignedBox3d& box,
                  QuadricType type) {
  std::array<bool, kBinsAround * kBinsAlong> seen{};
  const bool flat = is_flat(type);
  const auto bin = [](double x, double low, double high, int bins) {
    return std::clamp(static_cast<int>((x - low) / std::max(1e-9, high - low) * bins), 0, bins - 1);
  };
  for (const Eigen::Vector3d& p : points) {
    const int along = flat ? bin(p.y(), box.min().y(), box.max().y(), kBinsAlong)
                           : bin(p.z(), box.min().z(), box.max().z(), kBinsAlong);
    const int around =
        flat ? bin(p.x(), box.min().x(), box.max().x(), kBinsAround)
             : bin(std::atan2(p.y(), p.x()), -std::numbers::pi, std::numbers::pi, kBinsAround);
    seen[static_cast<std::size_t>(along * kBinsAround + around)] = true;
  }
  return static_cast<double>(std::count(seen.begin(), seen.end(), true)) /
         (kBinsAround * kBinsAlong);
}

/// Variance of an independent measurement by the residuals and what the fit averages over: white
/// noise over its points, and the noise that neighbours have in common over waves.
double variance_of_mean(const Surface& surface, double common_noise) {
  const double n = surface.fit.points;
  const double free = std::max(1.0, n - family_spec(surface.fit.family).dof);
  const double waves =
      std::clamp(static_cast<double>(surface.region.size()) / kSamplesPerWave, 1.0, free);
  const double common = common_noise * common_noise;
  return surface.fit.rss / n * ((1.0 - common) * kNoiseFactor / free + common / waves);
}

/// Covariance of the parameters of a family at the surface's fit; directions that the data leave
/// open are cut off.
/// @param information  of the family's parameters for residuals of unit variance
/// @param points       that the information sums over
Eigen::MatrixXd covariance(const Eigen::MatrixXd& information, double points, double variance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(information);
  const double min_known = kMinInformationShare * eigen.eigenvalues().tail<1>()[0];
  const Eigen::VectorXd inverse =
      eigen.eigenvalues().unaryExpr([&](double l) { return l > min_known ? 1.0 / l : 0.0; });
  return variance * points * eigen.eigenvectors() * inverse.asDiagonal() *
         eigen.eigenvectors().transpose();
}

/// Standard deviations of the canonical dimensions, by finite differences over the parameters.
std::vector<double> deviations(const Surface& surface, const SurfaceSamples& samples,
                               const CanonicalForm& form) {
  const std::size_t size = form.dimensions.size();
  std::vector<double> result(size, 0.0);
  Family family = surface.fit.family;
  Eigen::MatrixXd information = surface.fit.information;
  double count = surface.fit.points;
  // That an ellipsoid is one of revolution is mostly our choice and not the scene's.
  if (form.type == QuadricType::kEllipsoid && family != Family::kGeneral) {
    const OrientedPointsf points =
        fit_points(samples, surface.region, surface.local, kInformationPoints);
    const std::optional<FamilyFit> at = refine(points, Family::kGeneral, surface.fit.posed, 0);
    if (at) {
      family = Family::kGeneral;
      information = at->information;
      count = at->points;
    }
  }
  const Eigen::MatrixXd C =
      covariance(information, count, variance_of_mean(surface, samples.common_noise));
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(size), C.rows());
  for (Eigen::Index k = 0; k < C.rows(); ++k) {
    const double h = std::max(1e-6, 1e-3 * std::sqrt(C(k, k)));
    Eigen::VectorXd step = Eigen::VectorXd::Zero(C.rows());
    step[k] = h;
    const CanonicalForm other = canonical_form(moved(family, surface.fit.posed, step));
    if (other.type != form.type) continue;
    for (std::size_t i = 0; i < size; ++i) {
      J(static_cast<Eigen::Index>(i), k) =
          (other.dimensions[i].second - form.dimensions[i].second) / h;
    }
  }
  const Eigen::MatrixXd V = J * C * J.transpose();
  for (std::size_t i = 0; i < size; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    result[i] = std::sqrt(std::max(0.0, V(k, k)));
  }
  return result;
}

}  // namespace

Detection measure(const Surface& surface, const SurfaceSamples& samples,
                  const Eigen::Vector3d& eye) {
  const CanonicalForm form = canonical_form(surface.fit.posed);
  Detection d;
  d.type = form.type;
  d.Q_C = surface.Q;
  d.score = surface.confidence;
  d.rms = surface.rms;
  double side = 0;
  float cell = 0;
  for (const int i : surface.region) {
    d.inliers += samples.count[i];
    side += d.Q_C.gradient(samples.raw[i].cast<double>()).dot(samples.n[i].cast<double>());
    cell = std::max(cell, samples.cell[i]);
  }
  if (side < 0) d.Q_C = d.Q_C.flipped();

  d.X_CQ = form.X;
  d.X_CQ.translation() = surface.local.centre + surface.local.scale * form.X.translation();
  settle_frame(surface, samples, eye, form.type, &d.X_CQ);
  const std::vector<Eigen::Vector3d> points = canonical_points(surface, samples, d.X_CQ);
  d.extent_Q = trimmed_box(points);
  d.seen = share_seen(points, d.extent_Q, form.type);

  const std::vector<double> std = deviations(surface, samples, form);
  for (std::size_t i = 0; i < form.dimensions.size(); ++i) {
    const auto& [name, value] = form.dimensions[i];
    const double unit = is_angle(name) ? 1.0 : surface.local.scale;
    d.dimensions.push_back({name, unit * value, unit * std[i]});
  }
  const Eigen::Vector3d size = d.extent_Q.sizes();
  const double edge = kEdgeCells * static_cast<double>(cell);
  if (d.type == QuadricType::kCylinder || d.type == QuadricType::kEllipticCylinder) {
    d.dimensions.push_back({"length", size.z(), edge});
  } else if (d.type == QuadricType::kPlane) {
    d.dimensions.push_back({"width", size.x(), edge});
    d.dimensions.push_back({"height", size.y(), edge});
  }
  return d;
}

}  // namespace quadrille
