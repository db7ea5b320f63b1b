#include "lab/physics/true_body.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace quadrille::physics {
namespace {

using Eigen::Vector3d;

MassProperties box_properties(const TrueBody& body, double density) {
  const Vector3d size = body.box_S.sizes(), square = size.cwiseAbs2();
  const double mass = density * size.prod();
  const Vector3d inertia(square.y() + square.z(), square.x() + square.z(), square.x() + square.y());
  return {mass, body.box_S.center(), mass / 12.0 * inertia};
}

// Returns where the derivative of s(z)·h + z·dz vanishes: h²(p₁ + 2p₂z)² = 4dz²(p₀ + p₁z + p₂z²).
std::array<double, 2> stationary(const TrueBody& body, double h, double dz) {
  const auto [c, b, a] = std::array{body.p[0], body.p[1], body.p[2]};
  const double k = a * h * h - dz * dz;
  const double A = 4.0 * a * k, B = 4.0 * b * k, C = h * h * b * b - 4.0 * dz * dz * c;
  if (A == 0.0) return {-C / B, -C / B};
  const double root = std::sqrt(std::max(0.0, B * B - 4.0 * A * C));
  return {(-B + root) / (2.0 * A), (-B - root) / (2.0 * A)};
}

}  // namespace

double TrueBody::scale(double z) const {
  return std::sqrt(std::max(0.0, p[0] + z * (p[1] + z * p[2])));
}

bool TrueBody::is_convex() const {
  if (is_box) return true;
  constexpr int kSteps = 16;
  const double step = (z_max() - z_min()) / kSteps;
  // Rounding at an apex, where s is the root of almost nothing, is small beside the whole body, but
  // not beside the sections near the apex.
  const double rounding = 1e-6 * std::max(scale(z_min()), scale(z_max()));
  for (int i = 1; i < kSteps; ++i) {
    const double z = z_min() + i * step;
    const double chord = 0.5 * (scale(z - step) + scale(z + step));
    if (chord > scale(z) + rounding) return false;
  }
  return true;
}

bool TrueBody::contains(const Vector3d& p_C) const {
  const Vector3d q = X_CS.inverse() * p_C;
  if (is_box) return box_S.contains(q);
  if (q.z() < z_min() || q.z() > z_max()) return false;
  const double s = scale(q.z());
  return std::hypot(q.x() / a, q.y() / b) <= s;
}

Vector3d TrueBody::point_S(double angle, double z) const {
  const double s = scale(z);
  return {a * s * std::cos(angle), b * s * std::sin(angle), z};
}

Vector3d TrueBody::normal_S(double angle, double z) const {
  // The normal is half the gradient of x²/a² + y²/b² − s².
  const double s = scale(z);
  return Vector3d(s * std::cos(angle) / a, s * std::sin(angle) / b, -0.5 * p[1] - p[2] * z)
      .normalized();
}

MassProperties mass_properties(const TrueBody& body, double density) {
  if (body.is_box) return box_properties(body, density);
  constexpr int kSlices = 400;
  const double step = (body.z_max() - body.z_min()) / kSlices;
  double mass = 0.0, first = 0.0, second = 0.0;
  Vector3d section = Vector3d::Zero();  // moments of the slices about their own centre
  for (int i = 0; i < kSlices; ++i) {
    const double z = body.z_min() + (i + 0.5) * step, s = body.scale(z);
    const double u = body.a * s, v = body.b * s;
    const double slice = density * std::numbers::pi * u * v * step;
    mass += slice;
    first += slice * z;
    second += slice * z * z;
    section += 0.25 * slice * Vector3d(v * v, u * u, u * u + v * v);
  }
  const double centre = first / mass, about = second - mass * centre * centre;
  return {mass, {0.0, 0.0, centre}, section + Vector3d(about, about, 0.0)};
}

Vector3d support_point(const TrueBody& body, double z_0, double z_1, const Vector3d& direction_S) {
  const Vector3d& d = direction_S;
  const double h = std::hypot(body.a * d.x(), body.b * d.y());
  const auto [z_a, z_b] = stationary(body, h, d.z());
  double best = z_0, most = -1e300;
  for (const double z : {z_0, z_1, z_a, z_b}) {
    if (!(z >= z_0 && z <= z_1)) continue;
    const double reach = body.scale(z) * h + z * d.z();
    if (reach > most) {
      most = reach;
      best = z;
    }
  }
  const double s = body.scale(best);
  if (h == 0.0) return {0.0, 0.0, best};
  return {body.a * body.a * d.x() * s / h, body.b * body.b * d.y() * s / h, best};
}

}  // namespace quadrille::physics
