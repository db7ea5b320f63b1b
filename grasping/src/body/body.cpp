#include "body/body.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille {

double Body::scale(double z) const {
  switch (profile) {
    case Profile::kLinear:
      return std::abs(z);
    case Profile::kRoot:
      return std::sqrt(std::max(z, 0.0));
    case Profile::kHyperbola:
      return std::sqrt(1.0 + z * z / (c * c));
    case Profile::kSheet:
      return std::sqrt(std::max(0.0, z * z / (c * c) - 1.0));
    case Profile::kEllipse:
      return std::sqrt(std::max(0.0, 1.0 - z * z / (c * c)));
    default:
      return 1.0;
  }
}

double Body::slope(double z) const {
  const double s = std::max(scale(z), 1e-9);
  switch (profile) {
    case Profile::kLinear:
      return z < 0.0 ? -1.0 : 1.0;
    case Profile::kRoot:
      return 0.5 / s;
    case Profile::kHyperbola:
    case Profile::kSheet:
      return z / (c * c * s);
    case Profile::kEllipse:
      return -z / (c * c * s);
    default:
      return 0.0;
  }
}

double Body::width_std(const Eigen::Vector3d& d_Q, double z) const {
  const bool round = profile == Profile::kEllipse;
  const Eigen::Vector3d semi(a, b, round ? c : 0.0);
  const Eigen::Vector3d squared = d_Q.cwiseAbs2();
  const double h = std::sqrt(semi.cwiseAbs2().dot(squared));
  double sum = semi.cwiseProduct(squared).dot(std) / std::max(h, 1e-9);
  if (!round) sum *= scale(z);
  if (profile == Profile::kHyperbola || profile == Profile::kSheet) {
    sum += h * z * z / (c * c * c * std::max(scale(z), 1e-9)) * std.z();
  }
  return std::min(sum, kMaxStd);
}

// The radius r = a·s(z) has the slope r' = a·s'(z), which follows from a and c by
//   d ln r' = da/a + k·dc/c,
// with k = 0 for cones and paraboloids. For the hyperboloids s² = z²/c² ± 1, hence
//   k = −2 + (z²/c²)/s².
double Body::lean_std(double z) const {
  const bool hyperbolic = profile == Profile::kHyperbola || profile == Profile::kSheet;
  if (!hyperbolic && profile != Profile::kLinear && profile != Profile::kRoot) return 0.0;
  const double rise = std::max(a, b) * std::abs(slope(z));
  double share = std::max(std.x() / a, std.y() / b);
  if (hyperbolic) {
    const double s = std::max(scale(z), 1e-9), k = z * z / (c * c * s * s) - 2.0;
    share = std::hypot(share, k * std.z() / c);
  }
  // The angle is atan r'.
  return share * rise / (1.0 + rise * rise);
}

double Body::least_width_std(const Eigen::Vector3d& d_Q) const {
  const bool even = profile == Profile::kConstant || profile == Profile::kEllipse;
  return even ? width_std(d_Q, 0.0) : 0.0;
}

Eigen::Vector2d Body::widest() const {
  const bool bulges = profile == Profile::kEllipse;
  const double s = bulges ? 1.0 : std::max(scale(z_min), scale(z_max));
  return {a * s, b * s};
}

Eigen::AlignedBox3d Body::bounds_Q() const {
  const Eigen::Vector2d w = widest();
  return {Eigen::Vector3d(-w.x(), -w.y(), z_min), Eigen::Vector3d(w.x(), w.y(), z_max)};
}

Eigen::AlignedBox3d Body::bounds_C() const {
  const Eigen::AlignedBox3d box = bounds_Q();
  const Eigen::Vector3d half = X_CQ.linear().cwiseAbs() * (0.5 * box.sizes());
  const Eigen::Vector3d centre = X_CQ * Eigen::Vector3d(box.center());
  return {centre - half, centre + half};
}

bool Body::contains_Q(const Eigen::Vector3d& p, double margin) const {
  if (p.z() < z_min - margin || p.z() > z_max + margin) return false;
  if (profile == Profile::kBox) {
    return std::abs(p.x()) <= a + margin && std::abs(p.y()) <= b + margin;
  }
  if (profile == Profile::kEllipse) {
    const Eigen::Vector3d semi(a + margin, b + margin, c + margin);
    return p.cwiseQuotient(semi).squaredNorm() <= 1.0;
  }
  const double s = scale(std::clamp(p.z(), z_min, z_max));
  const double u = p.x() / (a * s + margin);
  const double v = p.y() / (b * s + margin);
  return u * u + v * v <= 1.0;
}

Body turned(Body body) {
  body.X_CQ.linear().col(1) *= -1.0;
  body.X_CQ.linear().col(2) *= -1.0;
  std::swap(body.z_min, body.z_max);
  body.z_min *= -1.0;
  body.z_max *= -1.0;
  return body;
}

}  // namespace quadrille
