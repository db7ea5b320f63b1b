// Makes the solid that a detection stands for.
#include <algorithm>
#include <cmath>
#include <optional>

#include "body/body.hpp"

namespace quadrille {
namespace {

using Profile = Body::Profile;

// A cone gives few points near its apex. If its narrow end was seen down to this radius [m], it is
// assumed to end in its apex, provided that the apex lies no farther on than this share of the seen
// length: a slender cone may be cut off.
constexpr double kMaxApexRadius = 0.006, kMaxApexShare = 0.5;

/// Standard deviation of the n-th dimension; 0 if it is missing, and at most 1, which stands for
/// unknown but stays finite.
double deviation(const Detection& d, std::size_t n) {
  if (n >= d.dimensions.size()) return 0.0;
  const double std = d.dimensions[n].std;
  return std::isfinite(std) ? std::min(std, 1.0) : 1.0;
}

/// Propagates the deviations of the dimensions to those of a, b and c.
Eigen::Vector3d deviations(const Detection& d, const Body& body) {
  const double first = deviation(d, 0), second = deviation(d, 1);
  switch (d.type) {
    case QuadricType::kSphere:
      return {first, first, first};
    case QuadricType::kCylinder:
      return {first, first, 0.0};
    case QuadricType::kEllipticCylinder:
      return {first, second, 0.0};
    case QuadricType::kCone:
      return Eigen::Vector3d(1.0, 1.0, 0.0) * first * (1.0 + body.a * body.a);
    case QuadricType::kEllipticCone:
      return {first * (1.0 + body.a * body.a), second * (1.0 + body.b * body.b), 0.0};
    case QuadricType::kEllipticParaboloid:  // a = √(4f)
      return {2.0 * first / body.a, 2.0 * second / body.b, 0.0};
    case QuadricType::kParallelPlanes:
      return Eigen::Vector3d::Zero();
    default:
      return {first, second, deviation(d, 2)};
  }
}

double end_deviation(const Detection& d) {
  if (d.type == QuadricType::kParallelPlanes) return 0.5 * deviation(d, 0);
  for (std::size_t n = 0; n < d.dimensions.size(); ++n) {
    if (d.dimensions[n].name == "length") return deviation(d, n);
  }
  return 0.0;
}

/// Cuts a cone that covers both nappes to the one on which most of the seen part lies, and extends
/// it to the apex if that is near.
Body with_apex(Body body) {
  if (body.z_min < 0.0 && body.z_max > 0.0) {
    (body.z_max > -body.z_min ? body.z_min : body.z_max) = 0.0;
  }
  double& narrow = body.z_max <= 0.0 ? body.z_max : body.z_min;
  const double missing = std::abs(narrow);
  if (std::max(body.a, body.b) * missing >= kMaxApexRadius ||
      missing > kMaxApexShare * (body.z_max - body.z_min)) {
    return body;
  }
  body.beyond = missing;
  narrow = 0.0;
  return body;
}

/// Orients the sheet that was seen towards z ≥ c; nullopt if both sheets were seen.
std::optional<Body> one_sheet(Body body) {
  if (body.z_max <= 0.0) body = turned(body);
  if (!(body.z_min > 0.0)) return std::nullopt;
  body.z_min = std::max(body.z_min, body.c);
  if (!(body.z_max > body.z_min)) return std::nullopt;
  return body;
}

/// Returns the space between two parallel planes, as far as each was seen.
Body slab(Body body, const Detection& d) {
  body.a = 0.5 * d.extent_Q.sizes().x();
  body.b = 0.5 * d.extent_Q.sizes().y();
  body.X_CQ.translation() = d.X_CQ * Eigen::Vector3d(d.extent_Q.center());
  body.z_max = 0.5 * d.dimension(0);
  body.z_min = -body.z_max;
  return body;
}

/// Returns the solid without its deviations; nullopt if the type bounds none, or none where it was
/// seen.
std::optional<Body> solid_of(const Detection& d) {
  Body body;
  body.X_CQ = d.X_CQ;
  body.z_min = d.extent_Q.min().z();
  body.z_max = d.extent_Q.max().z();
  const double first = d.dimension(0), second = d.dimension(1), third = d.dimension(2);
  const auto with = [&](Profile profile, double a, double b, double c = 0.0) {
    body.profile = profile;
    body.a = a;
    body.b = b;
    body.c = c;
    if (profile == Profile::kEllipse) body.z_min = -c, body.z_max = c;
    return body;
  };
  switch (d.type) {
    case QuadricType::kSphere:
      return with(Profile::kEllipse, first, first, first);
    case QuadricType::kEllipsoid:
      return with(Profile::kEllipse, first, second, third);
    case QuadricType::kCylinder:
      return with(Profile::kConstant, first, first);
    case QuadricType::kEllipticCylinder:
      return with(Profile::kConstant, first, second);
    case QuadricType::kCone:
      return with_apex(with(Profile::kLinear, std::tan(first), std::tan(first)));
    case QuadricType::kEllipticCone:
      return with_apex(with(Profile::kLinear, std::tan(first), std::tan(second)));
    case QuadricType::kEllipticParaboloid:
      body.z_min = 0.0;
      return with(Profile::kRoot, std::sqrt(4.0 * std::abs(first)),
                  std::sqrt(4.0 * std::abs(second)));
    case QuadricType::kHyperboloidOneSheet:
      return with(Profile::kHyperbola, first, second, third);
    case QuadricType::kHyperboloidTwoSheets:
      return one_sheet(with(Profile::kSheet, first, second, third));
    case QuadricType::kParallelPlanes:
      return slab(with(Profile::kBox, 0.0, 0.0), d);
    default:
      return std::nullopt;
  }
}

bool sound(const Body& body) {
  if (!body.X_CQ.matrix().allFinite() || !body.X_CQ.linear().isUnitary(1e-3)) return false;
  const Eigen::Vector3d size = body.bounds_Q().sizes();
  return size.allFinite() && size.minCoeff() > 1e-4 && size.maxCoeff() < 100.0;
}

}  // namespace

Body make_body(const Box& box) {
  Body body;
  body.profile = Profile::kBox;
  body.X_CQ = box.X_CB;
  body.X_CQ.translation() = box.X_CB * Eigen::Vector3d(box.outer_B.center());
  const Eigen::Vector3d half = 0.5 * box.outer_B.sizes();
  body.a = half.x();
  body.b = half.y();
  body.z_min = -half.z();
  body.z_max = half.z();
  body.std = (0.5 * box.std).cwiseMin(Body::kMaxStd);
  body.std.z() = 0.0;
  body.end_std = std::min(0.5 * box.std.z(), Body::kMaxStd);
  return body;
}

std::optional<Body> make_body(const Detection& detection) {
  std::optional<Body> body = solid_of(detection);
  if (!body || !sound(*body)) return std::nullopt;
  body->std = deviations(detection, *body);
  body->end_std = std::min(end_deviation(detection), Body::kMaxStd);
  return body;
}

}  // namespace quadrille
