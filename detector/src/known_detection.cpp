#include "quadrille/detector/known_detection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace quadrille {
namespace {

// A plane has an extent across it too [m].
constexpr double kHalfSheet = 0.0005;

[[noreturn]] void refuse(QuadricType type, const std::string& what) {
  throw std::invalid_argument(std::string(to_string(type)) + ": " + what);
}

std::vector<std::string> names_of(QuadricType type) {
  switch (type) {
    case QuadricType::kSphere:
      return {"radius"};
    case QuadricType::kCylinder:
      return {"radius", "length"};
    case QuadricType::kEllipticCylinder:
      return {"a", "b", "length"};
    case QuadricType::kCone:
      return {"half_angle"};
    case QuadricType::kEllipticCone:
      return {"half_angle_a", "half_angle_b"};
    case QuadricType::kEllipticParaboloid:
    case QuadricType::kHyperbolicParaboloid:
      return {"focal_a", "focal_b"};
    case QuadricType::kEllipsoid:
    case QuadricType::kHyperboloidOneSheet:
    case QuadricType::kHyperboloidTwoSheets:
      return {"a", "b", "c"};
    case QuadricType::kHyperbolicCylinder:
      return {"a", "b"};
    case QuadricType::kParabolicCylinder:
      return {"focal"};
    case QuadricType::kPlane:
      return {"width", "height"};
    case QuadricType::kParallelPlanes:
      return {"distance"};
    case QuadricType::kIntersectingPlanes:
      return {"angle"};
    default:
      refuse(type, "has no real surface");
  }
}

/// True for the dimensions that only say how far a surface reaches.
bool is_reach(const std::string& name) {
  return name == "length" || name == "width" || name == "height";
}

/// Largest value of a dimension.
double limit_of(const std::string& name) {
  if (name == "angle") return std::numbers::pi;
  return is_angle(name) ? 0.5 * std::numbers::pi : 1e6;
}

std::vector<Dimension> checked(QuadricType type, const std::map<std::string, double>& given) {
  std::vector<Dimension> dimensions;
  std::string all;
  for (const std::string& name : names_of(type)) {
    all += (all.empty() ? "" : ", ") + name;
    if (const auto found = given.find(name); found != given.end()) {
      if (!(found->second > 0.0 && found->second < limit_of(name))) {
        const char* const right = name == "angle" ? "half a turn" : "a right angle";
        refuse(type,
               name + " must be more than 0 and less than " + (is_angle(name) ? right : "1e6 m"));
      }
      dimensions.push_back({name, found->second, 0.0});
    }
  }
  if (dimensions.size() != names_of(type).size() || dimensions.size() != given.size()) {
    refuse(type, "its dimensions are " + all);
  }
  return dimensions;
}

/// Returns the extent of a type that its dimensions bound; an empty box for other types.
Eigen::AlignedBox3d whole_extent(QuadricType type, const std::vector<Dimension>& d) {
  const auto about = [](double x, double y, double z) {
    const Eigen::Vector3d half(x, y, z);
    return Eigen::AlignedBox3d(-half, half);
  };
  switch (type) {
    case QuadricType::kSphere:
      return about(d[0].value, d[0].value, d[0].value);
    case QuadricType::kEllipsoid:
      return about(d[0].value, d[1].value, d[2].value);
    case QuadricType::kCylinder:
      return about(d[0].value, d[0].value, 0.5 * d[1].value);
    case QuadricType::kEllipticCylinder:
      return about(d[0].value, d[1].value, 0.5 * d[2].value);
    case QuadricType::kPlane:
      return about(0.5 * d[0].value, 0.5 * d[1].value, kHalfSheet);
    default:
      return {};
  }
}

}  // namespace

Detection known_detection(QuadricType type, const Eigen::Isometry3d& X_CQ,
                          const std::map<std::string, double>& dimensions,
                          const Eigen::AlignedBox3d& extent_Q, bool inside) {
  Detection detection;
  detection.type = type;
  detection.X_CQ = rounded(checked_pose(X_CQ, "X_CQ"));
  detection.dimensions = checked(type, dimensions);
  detection.extent_Q = extent_Q.isEmpty() ? whole_extent(type, detection.dimensions) : extent_Q;
  if (detection.extent_Q.isEmpty()) refuse(type, "needs an extent");
  if (!detection.extent_Q.sizes().allFinite()) refuse(type, "its extent must be finite");
  const Eigen::AlignedBox3d whole = whole_extent(type, detection.dimensions);
  if (!whole.isEmpty() && !whole.intersects(detection.extent_Q)) {
    refuse(type, "no part of the surface lies in its extent");
  }
  CanonicalForm form{type, detection.X_CQ, {}};
  for (const Dimension& d : detection.dimensions) {
    if (!is_reach(d.name)) form.dimensions.emplace_back(d.name, d.value);
  }
  const Quadric outward = from_canonical(form).normalized();
  detection.Q_C = Quadric((inside ? outward.flipped() : outward).coefficients());
  detection.score = detection.seen = 1.0;
  return detection;
}

Box known_box(const Eigen::Isometry3d& X_CB, const Eigen::Vector3d& size) {
  if (!(size.allFinite() && size.minCoeff() > 0.0)) {
    throw std::invalid_argument("a box needs three sides of more than 0 m");
  }
  Box box;
  box.score = 1.0;
  box.X_CB = rounded(checked_pose(X_CB, "X_CB"));
  box.size = size;
  box.seen = {true, true, true};
  box.inner_B = box.outer_B = Eigen::AlignedBox3d(-0.5 * size, 0.5 * size);
  return box;
}

Eigen::Isometry3d checked_pose(const Eigen::Isometry3d& X, const std::string& name) {
  // Poses are used as given, so what differs from a rotation by more than this is a mistake.
  constexpr double kMaxOff = 1e-6;
  const bool is_rotation = X.linear().isUnitary(kMaxOff) && X.linear().determinant() > 0.0;
  if (X.matrix().allFinite() && is_rotation &&
      (X.matrix().row(3) - Eigen::RowVector4d(0, 0, 0, 1)).norm() < kMaxOff) {
    return X;
  }
  throw std::invalid_argument(name + " is no rotation and translation");
}

}  // namespace quadrille
