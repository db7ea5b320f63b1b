#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// Returns the box in single precision, no smaller than it was within some metres of the origin.
inline Eigen::AlignedBox3f with_rounding(const Eigen::AlignedBox3d& box) {
  constexpr float kSlack = 1e-4f;
  const Eigen::AlignedBox3f rounded = box.cast<float>();
  return {(rounded.min().array() - kSlack).matrix(), (rounded.max().array() + kSlack).matrix()};
}

/// The points of a cloud in the order in which they came, to look at those near a place only.
///
/// Sensors deliver neighbours one after another, so that a run of some points takes little space.
/// If they come in another order, all of this still holds, but saves nothing.
class CloudRuns {
 public:
  CloudRuns() = default;
  /// @param points_C  positions in frame C [m], of which some may be missing; they must outlive
  /// this
  explicit CloudRuns(std::span<const Eigen::Vector3f> points_C);
  /// Not explicit, so that a cloud can be passed where one look at its points is enough.
  CloudRuns(const PointCloud& cloud)  // NOLINT(google-explicit-constructor)
      : CloudRuns(std::span(cloud.points)) {}

  /// All points.
  std::span<const Eigen::Vector3f> points_C() const { return points_C_; }

  /// Calls visit(n), in ascending order, for the index of each point in the box.
  template <class Visit>
  void each_in(const Eigen::AlignedBox3f& box_C, Visit&& visit) const {
    const Eigen::Array3f low = box_C.min(), high = box_C.max();
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      const Run& run = runs_.data()[r];
      if ((run.low > high).any() || (run.high < low).any()) continue;
      const std::size_t end = std::min((r + 1) * kRun, points_C_.size());
      for (std::size_t n = r * kRun; n < end; ++n) {
        const Eigen::Array3f p_C = points_C_.data()[n];
        if ((p_C >= low).all() && (p_C <= high).all()) visit(n);
      }
    }
  }

  /// Calls visit(n), in ascending order, for the index of each point in any of the boxes. No point
  /// may be missing.
  template <class Visit>
  void each_in_any(std::span<const Eigen::AlignedBox3f> boxes_C, Visit&& visit) const {
    std::vector<Eigen::AlignedBox3f> near;
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      const Run& run = runs_.data()[r];
      near.clear();
      bool all = false;
      for (const Eigen::AlignedBox3f& box : boxes_C) {
        const Eigen::Array3f low = box.min(), high = box.max();
        if ((run.low > high).any() || (run.high < low).any()) continue;
        near.push_back(box);
        all |= (run.low >= low).all() && (run.high <= high).all();
      }
      if (near.empty()) continue;
      const std::size_t end = std::min((r + 1) * kRun, points_C_.size());
      for (std::size_t n = r * kRun; n < end; ++n) {
        const Eigen::Vector3f& p_C = points_C_.data()[n];
        const auto holds = [&](const Eigen::AlignedBox3f& box) { return box.contains(p_C); };
        if (all || std::any_of(near.begin(), near.end(), holds)) visit(n);
      }
    }
  }

  /// Returns the number of points in the runs that meet the box: at least as many as are in it, at
  /// a thirtieth of the cost of looking at each.
  std::size_t count_near(const Eigen::AlignedBox3f& box_C) const {
    const Eigen::Array3f low = box_C.min(), high = box_C.max();
    const auto meet = std::count_if(runs_.begin(), runs_.end(), [&](const Run& run) {
      return !((run.low > high).any() || (run.high < low).any());
    });
    return kRun * static_cast<std::size_t>(meet);
  }

 private:
  // Some centimetres of an image row. The bounds take a sixteenth of the memory of the points.
  static constexpr std::size_t kRun = 32;
  /// The bounds of the points of a run.
  struct Run {
    Eigen::Array3f low, high;
  };

  std::span<const Eigen::Vector3f> points_C_;
  std::vector<Run> runs_;
};

}  // namespace quadrille
