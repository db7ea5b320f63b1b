#include "surfaces/evidence/see_through.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fit/half_gradient.hpp"
#include "fit/posed_quadric.hpp"
#include "samples/region.hpp"
#include "surfaces/evidence/upright.hpp"

namespace quadrille {
namespace {

// Least number of rays to test, if the image has as many; more rays give the same share.
constexpr double kRays = 400.0;
// A quadric is tested within this multiple of its region's size.
constexpr double kReach = 3.0;
// Least cosine between a ray and the normal. Rays that meet the surface at less than about 20° see
// the smear at the edges of objects.
constexpr double kMinCosine = 0.35;
// Bound of closed cross sections, farther than anything that is seen [m].
constexpr double kFar = 1e6;
// A point lies off a quadric if it is farther than this share of the region's size plus this many
// sigma.
constexpr double kOffSizes = 0.1, kOffSigmas = 2.0;

bool has_closed_section(QuadricType type) {
  switch (type) {
    case QuadricType::kSphere:
    case QuadricType::kEllipsoid:
    case QuadricType::kCylinder:
    case QuadricType::kEllipticCylinder:
    case QuadricType::kCone:
    case QuadricType::kEllipticCone:
    case QuadricType::kEllipticParaboloid:
    case QuadricType::kHyperboloidOneSheet:
      return true;
    default:
      return false;
  }
}

/// The part of a quadric that its region supports, in frame V of the sight.
struct VouchedPart {
  Quadric Q;
  /// +1 if the seen side is the one to which the gradient points, else -1.
  double side;
  /// The part lies within a ball, and within a box along the axes x, y, z of a frame.
  Eigen::Vector3d centre;
  double reach;
  Eigen::Matrix3d axes;
  Eigen::AlignedBox3d box;
  /// Distance from Q beyond which a point does not lie on it [m].
  double off;

  /// Cosine between the seen side's normal and the ray back to the sensor at x; 0 if x lies outside
  /// the measured part of the surface, or if the ray meets the side that was not seen.
  double cosine_at(const Eigen::Vector3d& x, const Eigen::Vector3d& ray) const {
    // This is false also for NaN.
    if (!((x - centre).squaredNorm() < reach * reach)) return 0.0;
    if (!box.contains(axes.transpose() * x)) return 0.0;
    const Eigen::Vector3d g = (Q.matrix() * x.homogeneous()).head<3>();
    return std::max(0.0, -side * ray.dot(g) / (ray.norm() * g.norm()));
  }
};

VouchedPart vouched_part(const Eigen::Isometry3d& X_VC, const SurfaceSamples& samples,
                         std::span<const int> region, const Quadric& quadric,
                         const CanonicalForm& form, const std::optional<Eigen::Vector3d>& up) {
  VouchedPart part{};
  const Eigen::Matrix4d X_CV = X_VC.inverse().matrix();
  part.Q = Quadric(Eigen::Matrix4d(X_CV.transpose() * quadric.normalized().matrix() * X_CV));
  Eigen::Matrix3d axes_C = form.X.linear();
  if (!has_axis(form.type) && up) axes_C = pose_along(Eigen::Vector3d::Zero(), *up).linear();
  part.axes = X_VC.linear() * axes_C;
  const Normalisation local = normalisation_of(samples, region);
  part.centre = X_VC * local.centre;
  part.reach = kReach * local.scale;
  part.off = kOffSizes * local.scale;
  const Eigen::Affine3d X_AC(part.axes.transpose() * X_VC.matrix().topRows<3>());
  const Coefficients<float> q(quadric.normalized().matrix());
  double sigmas = 0.0;
  for (const int i : region) {
    const Eigen::Vector3f &x = samples.raw[i], &n = samples.n[i];
    part.box.extend(Eigen::Vector3d(X_AC * x.cast<double>()));
    const HalfGradient<float> g = half_gradient(q, x.x(), x.y(), x.z());
    const Eigen::Vector3f gradient(g.x, g.y, g.z);
    // At the apex of a cone the gradient is zero, and has no side.
    const float length = gradient.norm();
    if (length > 0.0f) part.side += static_cast<double>(gradient.dot(n) / length);
    sigmas += samples.sigma[i];
  }
  part.off += kOffSigmas * sigmas / static_cast<double>(region.size());
  part.side = part.side > 0 ? 1.0 : -1.0;
  if (has_closed_section(form.type)) {
    // Without an axis and without an up direction, all directions are equivalent.
    const int open = has_axis(form.type) || up ? 2 : 3;
    part.box.min().head(open).setConstant(-kFar);
    part.box.max().head(open).setConstant(kFar);
  }
  return part;
}

/// The cells around a position, of which only every stride-th one is used.
struct Window {
  int first_i, last_i, first_j, last_j, stride;
};

Window window_about(const Sight& sight, const Eigen::Vector3d& p_V, double reach) {
  const auto cell = [&](double tangent, float corner, int size) {
    return static_cast<int>(std::clamp((tangent - corner) / sight.step, 0.0, size - 1.0));
  };
  const double u = p_V.x() / p_V.z(), v = p_V.y() / p_V.z(), r = reach / p_V.z();
  Window w{cell(u - r, sight.corner.x(), sight.width), cell(u + r, sight.corner.x(), sight.width),
           cell(v - r, sight.corner.y(), sight.height), cell(v + r, sight.corner.y(), sight.height),
           1};
  const double cells = (w.last_i - w.first_i + 1.0) * (w.last_j - w.first_j + 1.0);
  w.stride = std::max(1, static_cast<int>(std::sqrt(cells / kRays)));
  return w;
}

/// Number of rays that should meet a quadric, and of those among them that see something behind it.
struct RayCounts {
  int through = 0, all = 0;
};

RayCounts count_rays(const Sight& sight, const VouchedPart& part) {
  RayCounts count;
  if (!(part.centre.z() > 0.0)) return count;
  const Window window = window_about(sight, part.centre, part.reach);
  // A ray along d meets the quadric if dᵀMd is positive; see Quadric::crossings().
  const Eigen::Matrix4d& Q = part.Q.matrix();
  const Eigen::Vector3d g = Q.topRightCorner<3, 1>();
  const Eigen::Matrix3d M = g * g.transpose() - Q(3, 3) * Q.topLeftCorner<3, 3>();
  for (int j = window.first_j; j <= window.last_j; j += window.stride) {
    const double y = sight.corner.y() + (j + 0.5) * sight.step;
    const double linear = 2.0 * (M(0, 1) * y + M(0, 2));
    const double constant = (M(1, 1) * y + 2.0 * M(1, 2)) * y + M(2, 2);
    for (int i = window.first_i; i <= window.last_i; i += window.stride) {
      const float w = sight.w[static_cast<std::size_t>(j) * static_cast<std::size_t>(sight.width) +
                              static_cast<std::size_t>(i)];
      const double x = sight.corner.x() + (i + 0.5) * sight.step;
      if (w == 0.0f || !((M(0, 0) * x + linear) * x + constant > 0.0)) continue;
      const Eigen::Vector3d ray(x, y, 1.0);
      for (const double z : part.Q.crossings(Eigen::Vector3d::Zero(), ray)) {
        if (!(z > 0.0)) continue;
        const double cosine = part.cosine_at(z * ray, ray);
        if (cosine < kMinCosine) continue;
        ++count.all;
        count.through += (1.0 / w - z) * ray.norm() * cosine > part.off;
      }
    }
  }
  return count;
}

}  // namespace

double see_through(const SceneContext& context, const SurfaceSamples& samples,
                   std::span<const int> region, const Quadric& Q, const CanonicalForm& form) {
  RayCounts sum;
  const std::vector<Sight>& sights = context.sights;
  for (const Sight& sight : sights) {
    if (sight.w.empty()) continue;
    const RayCounts count = count_rays(
        sight, vouched_part(sight.X_VC.cast<double>(), samples, region, Q, form, context.up));
    sum.through += count.through;
    sum.all += count.all;
  }
  if (sum.all > 0) return static_cast<double>(sum.through) / sum.all;
  const bool blind =
      std::all_of(sights.begin(), sights.end(), [](const Sight& sight) { return sight.w.empty(); });
  return blind ? kUnknownShare : 0.0;
}

}  // namespace quadrille
