#include "search/axes/profile.hpp"

#include <Eigen/Dense>

#include "base/symmetric_eigen.hpp"

namespace quadrille {
namespace {

// Steepest cone, and slope below which a cone is a cylinder (3°).
constexpr float kMaxSlope = 2.5f, kMaxSlopeOfCylinder = 0.05f;
// Least |cosine| between the normal of an arc's point and the axis.
constexpr float kMinCosine = 0.1f;

Profile fitted_line(const Profile& profile, std::span<const ProfilePoint> points) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const ProfilePoint& m : points) mean += Eigen::Vector2d(m.h, m.r);
  mean /= static_cast<double>(points.size());
  Eigen::Matrix2d S = Eigen::Matrix2d::Zero();
  for (const ProfilePoint& m : points) {
    const Eigen::Vector2d x = Eigen::Vector2d(m.h, m.r) - mean;
    S += x * x.transpose();
  }
  const Eigen::Vector2d along =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(S).eigenvectors().col(1);
  // A low ring of points does not tell its slope.
  if (std::abs(along.y()) > static_cast<double>(kMaxSlope) * std::abs(along.x())) return profile;
  const double k = along.y() / along.x();
  return {.kind = Profile::Kind::kLine,
          .k = static_cast<float>(k),
          .r0 = static_cast<float>(mean.y() - k * mean.x())};
}

/// Solves r² + h² = 2 c h + (R² − c²), which is linear in c and in the constant.
Profile fitted_arc(const Profile& profile, std::span<const ProfilePoint> points) {
  Eigen::Matrix2d A = Eigen::Matrix2d::Zero();
  Eigen::Vector2d b = Eigen::Vector2d::Zero();
  for (const ProfilePoint& m : points) {
    const Eigen::Vector2d row(2.0 * m.h, 1.0);
    A += row * row.transpose();
    b += row * (m.r * m.r + m.h * m.h);
  }
  const Eigen::Vector2d x = A.ldlt().solve(b);
  const double square = x(1) + x(0) * x(0);
  // This is also refused if it is NaN.
  if (!(square > 0.0)) return profile;
  return {.kind = Profile::Kind::kArc,
          .c = static_cast<float>(x(0)),
          .R = static_cast<float>(std::sqrt(square))};
}

}  // namespace

std::optional<Profile> line_through(const ProfilePoint& m) {
  const float k = -m.n.y() / m.n.x();
  if (!(std::abs(k) <= kMaxSlope)) return std::nullopt;
  return Profile{.kind = Profile::Kind::kLine, .k = k, .r0 = m.r - k * m.h};
}

std::optional<Profile> arc_through(const ProfilePoint& m, float max_radius) {
  if (std::abs(m.n.y()) < kMinCosine) return std::nullopt;
  const float c = m.h - m.r * m.n.y() / m.n.x();
  const float R = std::sqrt(m.r * m.r + (m.h - c) * (m.h - c));
  if (!(R <= max_radius)) return std::nullopt;
  return Profile{.kind = Profile::Kind::kArc, .c = c, .R = R};
}

Profile fitted(const Profile& profile, std::span<const ProfilePoint> points) {
  return profile.kind == Profile::Kind::kArc ? fitted_arc(profile, points)
                                             : fitted_line(profile, points);
}

Quadric revolved(const Profile& profile) {
  const double k = profile.k, r0 = profile.r0, c = profile.c, R = profile.R;
  Eigen::Matrix4d D = Eigen::Matrix4d::Zero();
  D(0, 0) = D(1, 1) = 1.0;
  if (profile.kind == Profile::Kind::kArc) {
    D(2, 2) = 1.0;
    D(2, 3) = D(3, 2) = -c;
    D(3, 3) = c * c - R * R;
  } else {
    D(2, 2) = -k * k;
    D(2, 3) = D(3, 2) = -k * r0;
    D(3, 3) = -r0 * r0;
  }
  return Quadric(D);
}

Family family_of(const Profile& profile) {
  if (profile.kind == Profile::Kind::kArc) return Family::kSphere;
  return std::abs(profile.k) < kMaxSlopeOfCylinder ? Family::kCylinder : Family::kCone;
}

}  // namespace quadrille
