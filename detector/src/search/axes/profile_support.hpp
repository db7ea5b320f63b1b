#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "search/axes/profile.hpp"

namespace quadrille {

/// Which points support a profile, and how many it needs to be taken for a surface.
struct SupportTest {
  /// Least cosine between the normals of a point and of the profile.
  float min_cosine = 0.0f;
  /// Least number of points, and of sectors of the turn about the axis that they span.
  std::size_t min_points = 0;
  int min_sectors = 0;
};

/// True if a point lies on a profile with a compatible normal.
bool supports(const ProfilePoint& m, const Profile& profile, float min_cosine);

/// Points that many profiles are tried on, stored such that all are compared with a profile at
/// once.
class ProfileSupport {
 public:
  ProfileSupport(std::span<const ProfilePoint> points, const SupportTest& test);

  /// Sum of a truncated quadratic in the distances of the points that support a profile; 0 if they
  /// are few or span little of the turn, or if their number shows that the sum cannot exceed
  /// `least`.
  float of(const Profile& profile, float least = 0.0f);

 private:
  SupportTest test_;
  std::size_t size_;
  /// Rows of distances from the axis, heights, both coordinates of the normals, and limits.
  std::vector<float> rows_;
  /// The bit of each point's sector.
  std::vector<std::uint64_t> sector_;
  /// For the profile at hand, each point's distance as a share of its limit, and one if the point
  /// supports it, otherwise zero; then the points that do.
  std::vector<float> share_;
  std::vector<int> is_on_, on_;
};

}  // namespace quadrille
