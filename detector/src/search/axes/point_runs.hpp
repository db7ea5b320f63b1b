#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace quadrille {

/// Balls about runs of successive points, by which those far from a line are left out without a
/// look at each. Successive samples are neighbours, so the balls are small.
class PointRuns {
 public:
  /// Number of points in a run; the last one may have fewer.
  static constexpr int kLength = 32;

  explicit PointRuns(std::span<const Eigen::Vector3f> points)
      : size_(static_cast<int>(points.size())) {
    balls_.reserve(points.size() / kLength + 1);
    for (int begin = 0; begin < size_; begin += kLength) {
      Eigen::AlignedBox3f box;
      for (int i = begin; i < end_of(begin); ++i) box.extend(points[static_cast<std::size_t>(i)]);
      balls_.push_back({box.center(), 0.5f * box.diagonal().norm()});
    }
  }

  /// Calls look(begin, end) in ascending order for all runs that may have points within the reach
  /// of a line.
  /// @param direction  unit vector
  template <class Look>
  void for_each_near(const Eigen::Vector3f& point, const Eigen::Vector3f& direction, float reach,
                     Look&& look) const {
    int begin = 0;
    for (const Ball& ball : balls_) {
      const Eigen::Vector3f off = ball.centre - point;
      const float along = direction.dot(off), farthest = kSlack * (reach + ball.radius);
      if (off.squaredNorm() - along * along <= farthest * farthest) look(begin, end_of(begin));
      begin += kLength;
    }
  }

 private:
  /// Factor of distances, for errors by rounding.
  static constexpr float kSlack = 1.02f;

  struct Ball {
    Eigen::Vector3f centre;
    float radius;
  };

  int end_of(int begin) const { return std::min(begin + kLength, size_); }

  int size_;
  std::vector<Ball> balls_;
};

}  // namespace quadrille
