// Makes the solid that a detection stands for.
#include <algorithm>
#include <cmath>
#include <string>

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

void set_extent(Body& body, const Detection& d) {
  body.z_min = d.extent_Q.min().z();
  body.z_max = d.extent_Q.max().z();
}

/// Orients the sheet that was seen towards z ≥ c; returns false if both sheets were seen.
bool fill_sheet(Body& body, const Detection& d) {
  body.profile = Profile::kSheet;
  body.a = d.dimension(0);
  body.b = d.dimension(1);
  body.c = d.dimension(2);
  if (body.z_max <= 0.0) body = turned(body);
  if (!(body.z_min > 0.0)) return false;
  body.z_min = std::max(body.z_min, body.c);
  return body.z_max > body.z_min;
}

void fill_ellipsoid(Body& body, const Detection& d) {
  const bool sphere = d.type == QuadricType::kSphere;
  body.profile = Profile::kEllipse;
  body.a = d.dimension(0);
  body.b = sphere ? body.a : d.dimension(1);
  body.c = sphere ? body.a : d.dimension(2);
  body.z_min = -body.c;
  body.z_max = body.c;
}

/// Fills the body with the space between two parallel planes, as far as each was seen.
void fill_box(Body& body, const Detection& d) {
  body.profile = Profile::kBox;
  body.a = 0.5 * d.extent_Q.sizes().x();
  body.b = 0.5 * d.extent_Q.sizes().y();
  body.X_CQ.translation() = d.X_CQ * Eigen::Vector3d(d.extent_Q.center());
  body.z_max = 0.5 * d.dimension(0);
  body.z_min = -body.z_max;
}

/// Returns false if the type bounds no solid, or none where it was seen.
bool fill_profile(Body& body, const Detection& d) {
  set_extent(body, d);
  switch (d.type) {
    case QuadricType::kSphere:
    case QuadricType::kEllipsoid:
      fill_ellipsoid(body, d);
      return true;
    case QuadricType::kCylinder:
    case QuadricType::kEllipticCylinder:
      body.a = d.dimension(0);
      body.b = d.type == QuadricType::kCylinder ? body.a : d.dimension(1);
      return true;
    case QuadricType::kCone:
    case QuadricType::kEllipticCone:
      body.profile = Profile::kLinear;
      body.a = std::tan(d.dimension(0));
      body.b = d.type == QuadricType::kCone ? body.a : std::tan(d.dimension(1));
      return true;
    case QuadricType::kEllipticParaboloid:
      body.profile = Profile::kRoot;
      body.a = std::sqrt(4.0 * std::abs(d.dimension(0)));
      body.b = std::sqrt(4.0 * std::abs(d.dimension(1)));
      body.z_min = 0.0;
      return true;
    case QuadricType::kHyperboloidOneSheet:
      body.profile = Profile::kHyperbola;
      body.a = d.dimension(0);
      body.b = d.dimension(1);
      body.c = d.dimension(2);
      return true;
    case QuadricType::kHyperboloidTwoSheets:
      return fill_sheet(body, d);
    case QuadricType::kParallelPlanes:
      fill_box(body, d);
      return true;
    default:
      return false;
  }
}

/// Cuts a cone that covers both nappes to the one on which most of the seen part lies, and extends
/// it to the apex if that is near.
void end_cone(Body& body) {
  if (body.profile != Profile::kLinear) return;
  if (body.z_min < 0.0 && body.z_max > 0.0) {
    (body.z_max > -body.z_min ? body.z_min : body.z_max) = 0.0;
  }
  double& narrow = body.z_max <= 0.0 ? body.z_max : body.z_min;
  if (std::max(body.a, body.b) * std::abs(narrow) >= kMaxApexRadius ||
      std::abs(narrow) > kMaxApexShare * (body.z_max - body.z_min)) {
    return;
  }
  body.beyond = std::abs(narrow);
  narrow = 0.0;
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

std::optional<Body> make_body(const Detection& detection, std::string* why) {
  const auto refuse = [&](const std::string& reason) {
    if (why) *why = reason;
    return std::nullopt;
  };
  Body body;
  body.X_CQ = detection.X_CQ;
  const std::string type(to_string(detection.type));
  if (is_imaginary(detection.type)) return refuse(type + " has no real surface");
  if (!fill_profile(body, detection)) return refuse(type + " bounds no solid");
  end_cone(body);
  if (!sound(body)) return refuse(type + " has no finite, positive size");
  body.std = deviations(detection, body);
  body.end_std = std::min(end_deviation(detection), Body::kMaxStd);
  return body;
}

}  // namespace quadrille
