#include "surfaces/measure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

#include "base/quantile.hpp"
#include "base/symmetric_eigen.hpp"
#include "quadrille/detector/quadric.hpp"
#include "surfaces/hidden_ends.hpp"
#include "surfaces/uncertainty.hpp"

namespace quadrille {
namespace {

// Share of the samples cut off at each end of the extent, so that stray samples do not stretch it;
// and a larger one, at which the extent is the same but for the share itself if the ends are sharp.
constexpr double kTrimmedShare = 0.004, kDeepTrimmedShare = 0.02;
// Number of bins around the axis and along it; a bin that holds a sample counts as seen.
constexpr int kBinsAround = 24, kBinsAlong = 8;
// A cylinder is longer than its samples show. Each end is half a cell beyond the middle of its last
// cell, and samples within two deviations of the noise from the plane that closes it, such as a cap
// or the table, count as that plane's. Standard deviation of the sum, as a share of it, in scenes
// with exact truth.
constexpr double kLostCells = 1.0, kLostSigmas = 4.0, kLostStd = 0.5;
// Standard deviation of a side of a plane's patch [cells].
constexpr double kPatchEdgeCells = 3.0;
// A surface was joined from views all round it if more than this share of it was seen, and if the
// normals of its two sides, weighted by the slopes of f, differ by less than this share of all. A
// single view sees as much only of the inside of a bowl, and both sides only of a thin shell, of
// which more stays hidden.
constexpr double kSeenAllRound = 0.75, kMaxImbalance = 0.5;
// Factor on the score if a dimension is a guess, since the surface is then only partly right.
constexpr double kGuessFactor = 0.9;

/// Positions of the region's samples in the canonical frame.
std::vector<Eigen::Vector3d> canonical_points(const Surface& surface, const SurfaceSamples& samples,
                                              const Eigen::Isometry3d& X_CQ) {
  const Eigen::Isometry3d X_QC = X_CQ.inverse();
  std::vector<Eigen::Vector3d> points;
  points.reserve(surface.region.size());
  for (const int i : surface.region) points.push_back(X_QC * samples.raw[i].cast<double>());
  return points;
}

/// Range of the points along an axis of the canonical frame.
std::pair<double, double> trimmed_range(const std::vector<Eigen::Vector3d>& points, int axis,
                                        double share = kTrimmedShare) {
  std::vector<double> x(points.size());
  const auto trim = static_cast<std::size_t>(share * static_cast<double>(points.size()));
  for (std::size_t k = 0; k < points.size(); ++k) x[k] = points[k][axis];
  const double low = nth_smallest(x, trim);
  return {low, nth_smallest(x, x.size() - 1 - trim)};
}

Eigen::AlignedBox3d trimmed_box(const std::vector<Eigen::Vector3d>& points) {
  Eigen::AlignedBox3d box;
  for (int axis = 0; axis < 3; ++axis) {
    std::tie(box.min()[axis], box.max()[axis]) = trimmed_range(points, axis);
  }
  return box;
}

bool extends_along_z(QuadricType type) {
  return type == QuadricType::kCylinder || type == QuadricType::kEllipticCylinder ||
         type == QuadricType::kHyperbolicCylinder || type == QuadricType::kIntersectingPlanes;
}

/// Turns the frame by half a turn about x, so that z points the other way.
void flip_z(Eigen::Isometry3d* X) {
  X->linear().col(1) *= -1.0;
  X->linear().col(2) *= -1.0;
}

/// Turns x along the longest extent of the points across z.
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

/// Determines what a quadric leaves open: signs of axes, the origin along them, and x of a plane.
void settle_frame(const Surface& surface, const SurfaceSamples& samples, const Eigen::Vector3d& eye,
                  QuadricType type, Eigen::Isometry3d* X_CQ) {
  const Eigen::Vector3d towards = eye - X_CQ->translation();
  if (type == QuadricType::kPlane) {
    if (X_CQ->linear().col(2).dot(towards) < 0) flip_z(X_CQ);
    align_x(canonical_points(surface, samples, *X_CQ), X_CQ);
  } else if (extends_along_z(type) && X_CQ->linear().col(2).dot(towards) < 0) {
    flip_z(X_CQ);
  } else if (type == QuadricType::kCone) {
    // The z axis points from the apex into the seen part.
    double sum = 0;
    for (const Eigen::Vector3d& p : canonical_points(surface, samples, *X_CQ)) sum += p.z();
    if (sum < 0) flip_z(X_CQ);
  }
  const bool along_z = extends_along_z(type), along_y = type == QuadricType::kParabolicCylinder;
  const bool across_z = is_flat(type) && type != QuadricType::kIntersectingPlanes;
  if (!along_z && !along_y && !across_z) return;
  const std::vector<Eigen::Vector3d> points = canonical_points(surface, samples, *X_CQ);
  const auto middle = [&](int axis) {
    const auto [low, high] = trimmed_range(points, axis);
    return (low + high) / 2.0;
  };
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  if (along_z) shift.z() = middle(2);
  if (along_y) shift.y() = middle(1);
  if (across_z) shift.head<2>() << middle(0), middle(1);
  X_CQ->translation() = *X_CQ * shift;
}

/// Share of the bins around z and along it, within the extent, that hold a sample. Equal steps of z
/// are equal areas on a sphere, and nearly so on other round surfaces.
double share_seen(const std::vector<Eigen::Vector3d>& points, const Eigen::AlignedBox3d& box,
                  QuadricType type) {
  std::array<bool, std::size_t{kBinsAround} * kBinsAlong> seen{};
  const bool flat = is_flat(type);
  const auto bin = [](double x, double low, double high, int bins) {
    const double share = std::clamp((x - low) / std::max(1e-9, high - low), 0.0, 1.0);
    return std::min(static_cast<int>(share * bins), bins - 1);
  };
  for (const Eigen::Vector3d& p : points) {
    const int along = flat ? bin(p.y(), box.min().y(), box.max().y(), kBinsAlong)
                           : bin(p.z(), box.min().z(), box.max().z(), kBinsAlong);
    const int around =
        flat ? bin(p.x(), box.min().x(), box.max().x(), kBinsAround)
             : bin(std::atan2(p.y(), p.x()), -std::numbers::pi, std::numbers::pi, kBinsAround);
    seen[static_cast<std::size_t>(along) * kBinsAround + static_cast<std::size_t>(around)] = true;
  }
  return static_cast<double>(std::count(seen.begin(), seen.end(), true)) /
         (kBinsAround * kBinsAlong);
}

bool has_length(QuadricType type) {
  return type == QuadricType::kCylinder || type == QuadricType::kEllipticCylinder;
}

/// Length along z by which a few samples reach beyond the many: what one trim leaves more than the
/// deeper one, each without its own share.
double raggedness(const std::vector<Eigen::Vector3d>& points, double length) {
  const auto [low, high] = trimmed_range(points, 2, kDeepTrimmedShare);
  const double deep = high - low;
  return std::max(0.0,
                  length / (1.0 - 2.0 * kTrimmedShare) - deep / (1.0 - 2.0 * kDeepTrimmedShare));
}

/// The length of a cylinder. It is a guess if something hides an end.
///
/// Sensors that correlate neighbouring cells by matching windows or filters blur edges over as
/// many: a cell and its neighbours on both sides by the share of the correlation.
Dimension length_of(const Detection& d, const Surface& surface, const SurfaceSamples& samples,
                    const std::vector<Eigen::Vector3d>& points, std::span<const Sight> sights) {
  const Evidence& e = surface.evidence;
  const double seen = d.extent_Q.sizes().z();
  const double lost = kLostCells * e.cell + kLostSigmas * e.sigma;
  const double blur = 1.0 + 2.0 * std::max(0.0, e.correlation);
  const bool open = hides_an_end(sights, samples, surface.region, d.X_CQ, d.extent_Q);
  return {"length", seen + lost,
          open ? std::numeric_limits<double>::infinity()
               : std::hypot(kLostStd * lost * blur, raggedness(points, seen))};
}

}  // namespace

Detection measure(const Surface& surface, const SurfaceSamples& samples, const Eigen::Vector3d& eye,
                  std::span<const Sight> sights) {
  const CanonicalForm form = canonical_form(surface.fit.posed);
  Detection d;
  d.type = form.type;
  d.Q_C = surface.Q;
  d.score = surface.confidence;
  d.rms = surface.rms;
  double side = 0.0, both = 0.0;
  double cell = 0;
  for (const int i : surface.region) {
    d.inliers += samples.count[i];
    const double slope =
        d.Q_C.gradient(samples.raw[i].cast<double>()).dot(samples.n[i].cast<double>());
    side += slope;
    both += std::abs(slope);
    cell = std::max(cell, static_cast<double>(samples.cell[i]));
  }
  if (side < 0) d.Q_C = d.Q_C.flipped();

  d.X_CQ = form.X;
  d.X_CQ.translation() = surface.local.centre + surface.local.scale * form.X.translation();
  settle_frame(surface, samples, eye, form.type, &d.X_CQ);
  const std::vector<Eigen::Vector3d> points = canonical_points(surface, samples, d.X_CQ);
  d.extent_Q = trimmed_box(points);
  d.seen = share_seen(points, d.extent_Q, form.type);
  // The normals of its far side point to the viewpoint through it, but the outside was seen.
  const bool all_round = d.seen > kSeenAllRound && std::abs(side) < kMaxImbalance * both;
  if (all_round && shows_inside(d)) d.Q_C = d.Q_C.flipped();

  Uncertainty uncertainty = uncertainty_of(surface, samples, form);
  bool guessed = false;
  for (std::size_t i = 0; i < form.dimensions.size(); ++i) {
    const auto& [name, value] = form.dimensions[i];
    const double unit = is_angle(name) ? 1.0 : surface.local.scale;
    d.dimensions.push_back({name, unit * value, unit * uncertainty.std[i]});
    guessed |= !std::isfinite(uncertainty.std[i]);
  }
  if (guessed) d.score *= kGuessFactor;
  d.covariance = std::move(uncertainty.covariance);
  if (has_length(d.type)) {
    d.dimensions.push_back(length_of(d, surface, samples, points, sights));
  } else if (d.type == QuadricType::kPlane) {
    const Eigen::Vector3d size = d.extent_Q.sizes();
    const double edge = kPatchEdgeCells * cell;
    d.dimensions.push_back({"width", size.x(), edge});
    d.dimensions.push_back({"height", size.y(), edge});
  }
  return d;
}

}  // namespace quadrille
