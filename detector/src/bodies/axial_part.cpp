#include "bodies/axial_part.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "boxes/face.hpp"

namespace quadrille {
namespace {

// Distance between two axes that noise explains [m].
constexpr double kMaxOffsetNoise = 0.003;
// A lid is at most this much larger than the part that it closes.
constexpr double kMaxLidShare = 1.25;
// Two semi-axes are equal if they differ by no more than this share.
constexpr double kMaxUnequal = 0.1;

bool equal(double a, double b) { return std::abs(a - b) <= kMaxUnequal * std::max(a, b); }

/// True if the quadric's canonical frame has an axis of revolution along z.
bool is_revolved(const Detection& d) {
  switch (d.type) {
    case QuadricType::kCylinder:
    case QuadricType::kCone:
      return true;
    case QuadricType::kEllipsoid:
    case QuadricType::kEllipticCone:
    case QuadricType::kEllipticCylinder:
    case QuadricType::kEllipticParaboloid:
    case QuadricType::kHyperboloidOneSheet:
    case QuadricType::kHyperboloidTwoSheets:
      return equal(d.dimension(0), d.dimension(1));
    default:
      return false;
  }
}

/// Largest distance of the seen part from the axis z of the canonical frame [m].
double largest_radius(const Detection& d) {
  const Eigen::AlignedBox3d& box = d.extent_Q;
  double largest = 0.0;
  for (const double z : {box.min().z(), box.center().z(), box.max().z()}) {
    const auto crossings =
        d.Q_C.crossings(d.X_CQ * Eigen::Vector3d(0.0, 0.0, z), d.X_CQ.linear().col(0));
    for (const double r : crossings) {
      if (std::isfinite(r)) largest = std::max(largest, std::abs(r));
    }
  }
  // Beyond the tip of a body nothing crosses; its points are all that is known of it.
  const double seen = std::max(box.min().head<2>().cwiseAbs().maxCoeff(),
                               box.max().head<2>().cwiseAbs().maxCoeff());
  return std::max(largest, seen);
}

/// Distance of a point from a part's axis.
double off_axis(const AxialPart& part, const Eigen::Vector3d& p_C) {
  const Eigen::Vector3d x = p_C - part.middle_C;
  return (x - part.axis_C.dot(x) * part.axis_C).norm();
}

}  // namespace

std::optional<AxialPart> axial_part(const Detection& d) {
  if (d.extent_Q.isEmpty()) return std::nullopt;
  AxialPart part;
  part.detection = &d;
  if (d.type == QuadricType::kSphere) {
    part.middle_C = d.X_CQ.translation();
    part.radius = part.half_length = d.dimension(0);
    return part;
  }
  if (!is_revolved(d)) return std::nullopt;
  const Eigen::AlignedBox3d& box = d.extent_Q;
  part.axis_C = d.X_CQ.linear().col(2);
  part.middle_C = d.X_CQ * Eigen::Vector3d(0.0, 0.0, box.center().z());
  part.radius = largest_radius(d);
  part.half_length = 0.5 * box.sizes().z();
  return part;
}

bool share_axis(const AxialPart& a, const AxialPart& b, const AxisTolerance& tolerance) {
  const double radius = std::max(a.radius, b.radius);
  const double offset = tolerance.offset_share * radius + kMaxOffsetNoise;
  const bool a_is_sphere = a.axis_C.isZero(), b_is_sphere = b.axis_C.isZero();
  if (a_is_sphere && b_is_sphere) return (a.middle_C - b.middle_C).norm() < offset;
  const AxialPart& with_axis = a_is_sphere ? b : a;
  const AxialPart& other = a_is_sphere ? a : b;
  if (off_axis(with_axis, other.middle_C) > offset) return false;
  const bool parallel = std::abs(a.axis_C.dot(b.axis_C)) > std::cos(tolerance.skew);
  if (!a_is_sphere && !b_is_sphere && !parallel) return false;
  const double along = std::abs(with_axis.axis_C.dot(other.middle_C - with_axis.middle_C));
  return along - a.half_length - b.half_length < kMaxGapShare * radius;
}

std::vector<int> groups_of(const std::vector<AxialPart>& parts, const AxisTolerance& tolerance) {
  std::vector<int> group(parts.size());
  std::iota(group.begin(), group.end(), 0);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (group[i] == group[k] || !share_axis(parts[i], parts[k], tolerance)) continue;
      // Copies, since std::replace() overwrites what references would name.
      const int from = std::max(group[i], group[k]), to = std::min(group[i], group[k]);
      std::replace(group.begin(), group.end(), from, to);
    }
  }
  return group;
}

bool is_lid(const Detection& plane, const AxialPart& part) {
  if (part.axis_C.isZero()) return false;
  if (std::abs(outward_normal(plane).dot(part.axis_C)) < std::cos(kMaxSkew)) return false;
  Eigen::Vector3d middle_Q = plane.extent_Q.center();
  middle_Q.z() = 0.0;
  const Eigen::Vector3d middle_C = plane.X_CQ * middle_Q;
  if (off_axis(part, middle_C) > part.radius) return false;
  if (plane.extent_Q.sizes().head<2>().maxCoeff() > kMaxLidShare * 2.0 * part.radius) return false;
  const double along = std::abs(part.axis_C.dot(middle_C - part.middle_C));
  return std::abs(along - part.half_length) < kMaxGapShare * part.radius;
}

}  // namespace quadrille
