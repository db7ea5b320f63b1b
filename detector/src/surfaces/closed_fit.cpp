#include "surfaces/closed_fit.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "fit/distance_sums.hpp"
#include "fit/geometric_fit.hpp"
#include "fit/model_selection.hpp"

namespace quadrille {
namespace {

// Number of steps of the fits, after which nearly all have converged.
constexpr int kSteps = 10;
// Least number of points of an outline, which are more than the unknowns of an elliptic cylinder.
constexpr std::size_t kMinOutline = 8;
// A point of the outline lies on a cylinder within this many deviations; at least this share must.
constexpr double kMaxSigmas = 3.0, kMinShare = 0.75;
// Largest factor by which the outline may raise the wall's root mean square distance. That of a
// foreign lid tears the fit off the wall.
constexpr double kMaxWorse = 1.5;
// Share of the deviation of an outline's points that they have in common: a sensor may widen all
// edges by a part of a pixel, or narrow them.
constexpr double kCommonShare = 0.33;

/// The elliptic cylinder along z of a frame whose section fits best by least squares: a (x² − y²) +
/// 2 b x y + c x + d y + e = −y², which fixes the sum of the two squares' coefficients, so that it
/// does not depend on the frame's turn about z. Nullopt if the section is no ellipse.
std::optional<PosedQuadric> elliptic_start(const OrientedPointsf& points,
                                           const Eigen::Isometry3d& X) {
  Eigen::Matrix<double, Eigen::Dynamic, 5> A(points.size(), 5);
  Eigen::VectorXd b(points.size());
  const Eigen::Isometry3d Y = X.inverse();
  for (Eigen::Index k = 0; k < points.size(); ++k) {
    const Eigen::Vector3d p = Y * points.at(k).x;
    A.row(k) << p.x() * p.x() - p.y() * p.y(), 2.0 * p.x() * p.y(), p.x(), p.y(), 1.0;
    b[k] = -p.y() * p.y();
  }
  const Eigen::Matrix<double, 5, 1> s = A.colPivHouseholderQr().solve(b);
  Eigen::Matrix2d M;
  M << s[0], s[1], s[1], 1.0 - s[0];
  if (!(M.determinant() > 0.0)) return std::nullopt;
  const Eigen::Vector2d half(0.5 * s[2], 0.5 * s[3]);
  const Eigen::Vector2d centre = -M.inverse() * half;
  const double value = s[4] + half.dot(centre);
  if (!(value < 0.0)) return std::nullopt;
  PosedQuadric start;
  start.X = X * Eigen::Translation3d(centre.x(), centre.y(), 0.0);
  start.D.topLeftCorner<2, 2>() = M / -value;
  start.D(3, 3) = -1.0;
  return start;
}

/// The points of the wall, then those of the outline.
OrientedPointsf all_points(const OrientedPointsf& wall, const std::vector<OutlinePoint>& outline) {
  OrientedPointsf all(wall.size() + static_cast<Eigen::Index>(outline.size()));
  all.points.leftCols(wall.size()) = wall.points;
  all.normals.leftCols(wall.size()) = wall.normals;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Eigen::Index column = wall.size() + static_cast<Eigen::Index>(k);
    all.points.col(column) = outline[k].p_C.cast<float>();
    // Nothing reads the normals here.
    all.normals.col(column).setZero();
  }
  return all;
}

/// The round cylinder whose section has the middle and the area of an elliptic one.
PosedQuadric round_start(const PosedQuadric& elliptic) {
  PosedQuadric start;
  start.X = elliptic.X;
  start.D.topLeftCorner<2, 2>().setIdentity();
  start.D(3, 3) = -1.0 / std::sqrt(elliptic.D.topLeftCorner<2, 2>().determinant());
  return start;
}

/// Root mean square of the deviations of an outline's points.
double rms_std(const std::vector<OutlinePoint>& outline) {
  double sum = 0.0;
  for (const OutlinePoint& o : outline) sum += o.std * o.std;
  return std::sqrt(sum / static_cast<double>(outline.size()));
}

/// The cylinder that explains a wall and an outline best. A sensor may blur edges along one
/// direction more than along others, so a residual below the outline's deviation is no evidence for
/// an ellipse.
std::optional<FamilyFit> best_cylinder(const Wall& wall, const std::vector<OutlinePoint>& outline,
                                       const OrientedPointsf& points) {
  const auto elliptic = elliptic_start(points, canonical_form(wall.fit.posed).X);
  if (!elliptic) return std::nullopt;
  SelectionOptions options;
  options.effective_share = (wall.effective_size + static_cast<double>(outline.size())) /
                            static_cast<double>(points.size());
  options.common_noise = std::hypot(wall.common_noise, rms_std(outline));
  DistanceSums<float> sums(points);
  std::optional<FamilyFit> best = refine(&sums, Family::kCylinder, round_start(*elliptic), kSteps);
  const auto other = refine(&sums, Family::kEllipticCylinder, *elliptic, kSteps);
  if (!best || (other && bic(*other, options) < bic(*best, options))) best = other;
  if (!best) return std::nullopt;
  const QuadricType type = canonical_form(best->posed).type;
  if (type != QuadricType::kCylinder && type != QuadricType::kEllipticCylinder) return std::nullopt;
  return best;
}

/// The points of an outline that lie on a quadric within their deviations.
std::vector<OutlinePoint> points_on(const PosedQuadric& posed,
                                    const std::vector<OutlinePoint>& outline) {
  const Quadric Q(posed.matrix());
  std::vector<OutlinePoint> on;
  std::copy_if(outline.begin(), outline.end(), std::back_inserter(on), [&](const OutlinePoint& o) {
    return std::abs(Q.distance(o.p_C)) < kMaxSigmas * o.std;
  });
  return on;
}

}  // namespace

std::vector<OutlinePoint> local_outline(std::span<const OutlinePoint> outline,
                                        const Normalisation& local) {
  std::vector<OutlinePoint> result;
  result.reserve(outline.size());
  for (const OutlinePoint& o : outline) {
    result.push_back({(o.p_C - local.centre) / local.scale, o.std / local.scale});
  }
  return result;
}

std::optional<ClosedFit> fit_closed(const Wall& wall, const std::vector<OutlinePoint>& outline) {
  if (outline.size() < kMinOutline) return std::nullopt;
  OrientedPointsf points = all_points(wall.points, outline);
  std::optional<FamilyFit> fit = best_cylinder(wall, outline, points);
  if (!fit) return std::nullopt;
  const std::vector<OutlinePoint> on = points_on(fit->posed, outline);
  const bool closes =
      static_cast<double>(on.size()) >=
      std::max(double(kMinOutline), kMinShare * static_cast<double>(outline.size()));
  if (!closes) return std::nullopt;
  if (on.size() < outline.size()) {
    points = all_points(wall.points, on);
    fit = best_cylinder(wall, on, points);
    if (!fit) return std::nullopt;
  }
  DistanceSums sums(wall.points);
  const double alone = sums.evaluate(wall.fit.posed.matrix()).squares();
  const double now = sums.evaluate(fit->posed.matrix()).squares();
  if (now > kMaxWorse * kMaxWorse * alone) return std::nullopt;
  fit->rss = now * static_cast<double>(points.size()) / static_cast<double>(wall.points.size());
  return ClosedFit{std::move(*fit), std::move(points), kCommonShare * rms_std(on)};
}

}  // namespace quadrille
