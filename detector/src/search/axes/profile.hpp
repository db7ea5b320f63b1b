#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <span>

#include "quadrille/detector/quadric.hpp"

namespace quadrille {

/// A sample in the half-plane through an axis.
struct ProfilePoint {
  /// Index of the sample.
  int sample;
  /// Distance from the axis and height along it [m].
  float r, h;
  /// Unit normal (n_r, n_h).
  Eigen::Vector2f n;
  /// Number of the sector of the turn about the axis in which it lies.
  int sector;
  /// Largest distance of a profile that the sample supports [m].
  float limit;
};

/// The curve in the half-plane (r, h) that a cylinder, a cone or a sphere has about its axis.
struct Profile {
  enum class Kind {
    kLine,  ///< r = r₀ + k h: a cone, or a cylinder if k is 0
    kArc,   ///< r² + (h − c)² = R²: a sphere
  };
  Kind kind = Kind::kLine;
  float k = 0.0f, r0 = 0.0f;
  float c = 0.0f, R = 0.0f;

  /// Signed distance of a point [m].
  float distance(const ProfilePoint& m) const {
    return kind == Kind::kArc ? std::sqrt(m.r * m.r + (m.h - c) * (m.h - c)) - R
                              : (m.r - r0 - k * m.h) / std::sqrt(1.0f + k * k);
  }
  /// Normal, of any length, at a point that lies on the profile.
  Eigen::Vector2f normal(const ProfilePoint& m) const {
    return kind == Kind::kArc ? Eigen::Vector2f(m.r, m.h - c) : Eigen::Vector2f(1.0f, -k);
  }
};

/// The line through a point along its surface; nullopt if it is steeper than a cone may be.
std::optional<Profile> line_through(const ProfilePoint& m);

/// The arc through a point about where its normal line meets the axis; nullopt if the normal is
/// nearly square to the axis, or if R exceeds the largest radius.
std::optional<Profile> arc_through(const ProfilePoint& m, float max_radius);

/// Fits a profile of the same kind to points by least squares: a line with distances square to it,
/// an arc algebraically. Points that do not determine it leave it as it is.
Profile fitted(const Profile& profile, std::span<const ProfilePoint> points);

/// The quadric of a profile that is turned about the z axis.
Quadric revolved(const Profile& profile);

/// The family of that quadric.
Family family_of(const Profile& profile);

}  // namespace quadrille
