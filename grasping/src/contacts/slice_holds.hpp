#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "contacts/candidates.hpp"
#include "contacts/finger_runs.hpp"
#include "contacts/finger_slices.hpp"
#include "contacts/hold.hpp"
#include "contacts/pad_side.hpp"
#include "contacts/surface_points.hpp"
#include "quadrille/grasping/gripper.hpp"

namespace quadrille {

/// Limits for thin walls that the sensor saw from one side only.
struct ThinWalls {
  /// Least and greatest thickness [m]; there are no thin walls if the latter is 0.
  double min = 0.0, max = 0.0;
  /// Whether space was seen to be free at a point in frame C.
  std::function<bool(const Eigen::Vector3d& p_C)> is_free;
};

/// A hold on the points of a slice.
struct SliceHold {
  Hold hold;
  /// How far the tips reach below the highest point between the fingers [m].
  double depth = 0.0;
};

/// Lowers the fingers of a hand on slices of points. The contacts are the two ends of a run of
/// points without a gap for a finger.
class SliceHolds {
 public:
  /// All arguments must outlive this object.
  /// @param own  for each point, nonzero if it belongs to the target
  /// @param space  the target's centre, from which on slices give positions, and what it stands on
  /// @param max_friction  largest friction coefficient that a hold may need [-]
  SliceHolds(const SurfacePoints& points, const std::vector<char>& own, const Gripper& gripper,
             const ApproachSpace& space, const ThinWalls& walls, double max_friction);

  /// The positions of the points, from the target's centre on [m].
  const std::vector<Eigen::Vector3d>& offsets_C() const { return offsets_C_; }
  /// The heights of points that fingers meet at any of the depths, and of those just below.
  static SliceHeights heights(const Gripper& gripper);

  /// Sets the orientation of the hand, and the points as they were sorted for it.
  void set_orientation(const Eigen::Matrix3d& R_CG, const SortedPoints& sorted);
  /// Adds the holds on a slice for this orientation.
  void find(const FingerSlice& slice, std::vector<SliceHold>& found);

 private:
  // The tips reach so deep below the highest point of the target between the fingers, in lengths of
  // the fingers; deepest first.
  static constexpr std::array kDepthsToFinger = {0.75f, 0.55f, 0.4f, 0.28f, 0.16f};
  static constexpr std::size_t kDepths = kDepthsToFinger.size();
  static_assert(kDepths <= FingerRuns::kMaxDepths);

  /// For each sorted point, the part of its normal along the closing direction, and whether it is
  /// own.
  struct Facing {
    Eigen::ArrayXd cosines;
    Eigen::Array<char, Eigen::Dynamic, 1> is_own;
  };
  /// A quick first look at the points on one side of a run.
  struct Glance {
    FacingCount facing;
    /// The mean of how far they lie along the approach [m].
    double z = 0.0;
  };

  std::uint32_t place(std::size_t k) const { return points_of_slice_.data()[k]; }
  float y(std::size_t k) const { return sorted_.y[place(k)]; }
  double exact_y(std::size_t k) const { return sorted_.exact_y[place(k)]; }
  std::size_t index(std::size_t k) const { return sorted_.index.data()[place(k)]; }
  bool is_own(std::size_t k) const { return facing_->is_own.data()[place(k)] != 0; }
  bool reached_by_fingers(std::size_t k) const {
    const float z = sorted_.z[place(k)];
    return (z < tip_) & (z > root_);
  }
  double lowest_tip(double x) const;
  void find_runs(const FingerSlice& slice);
  void hold_runs(const std::vector<Run>& runs, double x, std::vector<SliceHold>& found);
  bool holds_enough(const Run& run) const;
  std::size_t end_of_head(const Run& run) const;
  std::size_t start_of_tail(const Run& run) const;
  std::span<const BetweenPads> in_hand(std::size_t first, std::size_t last);
  Glance glance(std::size_t first, std::size_t last, std::size_t outermost, double sign) const;
  bool may_hold(const Run& run, std::size_t head, std::size_t tail) const;
  void hold(double x, double tip, const Run& run, std::vector<SliceHold>& found);
  bool is_thin_wall(double x, double tip, const PadSide& left, const PadSide& right) const;
  Eigen::Vector3d in_cloud(const Eigen::Vector3d& offset_G) const;
  bool goes_on(double tip, double low, double high) const;

  const SurfacePoints& points_;
  const std::vector<char>& own_;
  const Gripper& gripper_;
  const ApproachSpace& space_;
  const ThinWalls& walls_;
  const double max_friction_;
  std::vector<Eigen::Vector3d> offsets_C_;
  Eigen::Matrix3d R_CG_ = Eigen::Matrix3d::Identity();
  /// The points as they are sorted along the closing direction that is being tried, and how they
  /// face it; the latter for each direction so far.
  SortedPoints sorted_;
  const Facing* facing_ = nullptr;
  std::vector<Facing> facings_;
  /// How far the tips and the roots of the fingers reach along the approach, at the depth that is
  /// being tried [m].
  float tip_ = 0.0f, root_ = 0.0f;
  /// The points of one slice that the fingers reach at any depth, and those just below, by their
  /// places among the sorted ones.
  std::span<const std::uint32_t> points_of_slice_;
  /// How far tips and roots reach at each depth [m], and the runs of the points in between.
  std::array<float, kDepths> tips_{}, roots_{};
  FingerRuns runs_;
  /// Points of one run.
  std::vector<BetweenPads> between_;
};

}  // namespace quadrille
