#include "bodies/upright_cones.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "bodies/joint_member.hpp"
#include "fit/geometric_fit.hpp"
#include "fit/posed_quadric.hpp"
#include "fit/straight_profile.hpp"
#include "quadrille/detector/quadric.hpp"
#include "surfaces/surface_fit.hpp"

namespace quadrille {
namespace {

// Least lean of a cylinder that noise hardly explains, 2.6°, and largest one of what may stand
// upright, 11°. In simulated kitchens 43 of 46 cylinders seem to lean by less than 2°, and 10 of 12
// tapered cups that pass for cylinders by 4.6° to 9.4°.
constexpr double kLeastLean = 0.045, kMostLean = 0.2;
// 95 % quantile of the χ² distribution with one degree of freedom: by so much the residuals of the
// cylinder exceed those of the cone.
constexpr double kSignificant = 3.84;
// Number of Gauss-Newton steps, after which the fit has converged.
constexpr int kSteps = 8;

/// A cone or cylinder about an axis along z, by the place of the axis and the profile r0 + slope z.
struct Upright {
  double x = 0.0, y = 0.0, r0 = 0.0, slope = 0.0;
};

/// Fits a cone about an axis along z, or a cylinder, by Gauss-Newton.
/// @param points  3xN
std::optional<Upright> fit_upright(const Eigen::Matrix3Xd& points, Family family, Upright fit) {
  for (int step = 0; step < kSteps; ++step) {
    Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
    Eigen::Vector4d b = Eigen::Vector4d::Zero();
    const double length = std::sqrt(1.0 + fit.slope * fit.slope);
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      const Eigen::Vector2d d(points(0, i) - fit.x, points(1, i) - fit.y);
      const double r = d.norm(), z = points(2, i);
      if (!(r > 0.0)) continue;
      const double of_slope = family == Family::kCone ? -z : 0.0;
      const Eigen::Vector4d J = Eigen::Vector4d(-d.x() / r, -d.y() / r, -1.0, of_slope) / length;
      A += J * J.transpose(), b += J * (r - fit.r0 - fit.slope * z) / length;
    }
    if (family == Family::kCylinder) A(3, 3) = 1.0;
    const Eigen::Vector4d change = A.ldlt().solve(-b);
    if (!change.allFinite()) return std::nullopt;
    fit.x += change[0], fit.y += change[1], fit.r0 += change[2], fit.slope += change[3];
  }
  return fit;
}

/// The upright surface of a family that suits a cylinder's points best, in its local coordinates.
std::optional<FamilyFit> upright_fit(const LastFit& cylinder, Family family,
                                     const Eigen::Vector3d& up) {
  const Eigen::Isometry3d X = pose_along(Eigen::Vector3d::Zero(), up);
  const Eigen::Matrix3Xd points = X.linear().transpose() * cylinder.points.points.cast<double>();
  const PosedQuadric& leaning = cylinder.surface.fit.posed;
  const Eigen::Vector3d place = X.linear().transpose() * leaning.X.translation();
  const double radius = canonical_form(leaning).dimensions.front().second;
  const auto upright = fit_upright(points, family, {place.x(), place.y(), radius, 0.0});
  if (!upright || !(upright->r0 > 0.0)) return std::nullopt;
  ProfileLine line{X, 0.0, upright->r0, upright->slope};
  line.X.translation() = X.linear() * Eigen::Vector3d(upright->x, upright->y, 0.0);
  FamilyFit fit = cylinder.surface.fit;
  fit.family = family;
  fit.posed = straight_quadric(family, line, line.slope);
  fit.rss = DistanceSums(cylinder.points).evaluate(fit.posed.matrix()).squares();
  return fit;
}

bool leans_somewhat(const Surface& surface, const Eigen::Vector3d& up) {
  if (surface.fit.family != Family::kCylinder) return false;
  const double cosine = std::abs(form_of(surface).X.linear().col(2).dot(up));
  return cosine < std::cos(kLeastLean) && cosine > std::cos(kMostLean);
}

}  // namespace

std::vector<int> stand_cones_up(const Eigen::Vector3d& up, std::vector<LastFit>* fits) {
  std::vector<int> changed;
  for (std::size_t k = 0; k < fits->size(); ++k) {
    LastFit& leaning = (*fits)[k];
    if (leaning.points.size() == 0 || !leans_somewhat(leaning.surface, up)) continue;
    std::optional<FamilyFit> cone = upright_fit(leaning, Family::kCone, up);
    const std::optional<FamilyFit> cylinder = upright_fit(leaning, Family::kCylinder, up);
    if (!cone || !cylinder) continue;
    const Member member = member_of(static_cast<int>(k), leaning, false, false);
    const double growth = growth_of(member, *cone);
    const bool tapers = growth_of(member, *cylinder) - growth > kSignificant;
    if (!tapers || !is_chance(growth, 1)) continue;
    Surface& surface = leaning.surface;
    set_fit(&surface, std::move(*cone));
    surface.information = information(leaning.points, surface.fit);
    changed.push_back(static_cast<int>(k));
  }
  return changed;
}

}  // namespace quadrille
