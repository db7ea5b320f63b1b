#include "surfaces/sibling.hpp"

#include <algorithm>
#include <cmath>

#include "fit/coaxial_fit.hpp"
#include "surfaces/axis_tolerance.hpp"
#include "surfaces/join.hpp"

namespace quadrille {
namespace {

/// Foot of a point on the z axis of a pose.
Eigen::Vector3d foot_on(const Eigen::Isometry3d& X, const Eigen::Vector3d& p) {
  const Eigen::Vector3d z = X.linear().col(2);
  return X.translation() + z * z.dot(p - X.translation());
}

/// True if a cylinder and a surface have about the same axis.
bool about_one_axis(const Surface& cylinder, const Surface& surface) {
  if (!may_meet(cylinder.local, surface.local)) return false;
  const CanonicalForm form = form_of(cylinder);
  const Eigen::Isometry3d a = form.X, b = form_of(surface).X;
  const Eigen::Vector3d& middle = surface.local.centre;
  const double radius = cylinder.local.scale * form.dimensions.front().second;
  return std::abs(a.linear().col(2).dot(b.linear().col(2))) > std::cos(kPerhapsOneAxis.skew) &&
         (foot_on(a, middle) - foot_on(b, middle)).norm() < kPerhapsOneAxis.offset_share * radius;
}

/// True if the middle of a surface lies beyond the ends of another one along an axis.
bool lies_beyond(const Surface& surface, const Surface& other, const Eigen::Vector3d& axis,
                 const SurfaceSamples& samples) {
  const auto height = [&](const Eigen::Vector3d& p) { return axis.dot(p - other.local.centre); };
  const double middle = height(surface.local.centre);
  return std::all_of(other.region.begin(), other.region.end(), [&](int i) {
    const double h = height(samples.raw[i].cast<double>());
    return middle > 0.0 ? h < middle : h > middle;
  });
}

/// True if a cylinder and a surface follow each other along one axis, unlike the two sides of a
/// wall.
bool follow_each_other(const Surface& cylinder, const Surface& surface,
                       const SurfaceSamples& samples) {
  if (!about_one_axis(cylinder, surface)) return false;
  const Eigen::Vector3d axis = form_of(cylinder).X.linear().col(2);
  return lies_beyond(cylinder, surface, axis, samples) &&
         lies_beyond(surface, cylinder, axis, samples);
}

}  // namespace

const Surface* sibling_of(const Surface& surface, std::span<const Surface> surfaces,
                          const SurfaceSamples& samples) {
  const Surface* sibling = nullptr;
  if (!has_one_axis(surface.fit.family)) return sibling;
  for (const Surface& other : surfaces) {
    if (other.fit.family != Family::kCylinder || !follow_each_other(other, surface, samples))
      continue;
    if (!sibling || other.region.size() > sibling->region.size()) sibling = &other;
  }
  return sibling;
}

}  // namespace quadrille
