#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "quadrille/grasping/gripper.hpp"

namespace quadrille {

/// A point by its index, and how far it lies along the closing direction and the approach [m].
struct InSlice {
  float y, z;
  std::uint32_t index;
};

/// The points that a finger covers at one place of the hand.
struct FingerSlice {
  /// Middle of the finger, across the closing direction and the approach [m].
  double x = 0.0;
  /// How far the highest own point lies along the approach [m].
  float top = 0.0f;
  /// The points, sorted along the closing direction.
  std::span<const InSlice> points;
};

/// The heights that matter in a slice: so far above and below its highest own point [m].
struct SliceHeights {
  float above = 0.0f, below = 0.0f;
};

/// Cuts points into slices as wide as a finger, for one orientation of the hand after another. Most
/// points are of no concern to a hand that holds own ones. They are left out early: the slices
/// without own points, the points at other heights, and those that lie beyond what the hand can
/// span from an own point on, and one gap for a finger farther.
class FingerSlices {
 public:
  /// @param points  positions from any origin near the target [m]
  /// @param own  nonzero for the points of the target
  FingerSlices(std::span<const Eigen::Vector3d> points, std::span<const char> own,
               const Gripper& gripper, const SliceHeights& heights);

  /// Moves a hand of an orientation across the own points, in steps of half a finger's width.
  /// Calls that share the closing direction should follow each other, which saves sorting.
  /// @param R  axes of the hand as columns: y closing, z approach
  /// @return the slices at these places that hold own points; they last until the next call
  const std::vector<FingerSlice>& cut(const Eigen::Matrix3d& R);

 private:
  using Points = Eigen::Matrix<double, Eigen::Dynamic, 3>;

  /// The highest of some own points, and the range that they take along the closing direction.
  struct OwnRange {
    float top = std::numeric_limits<float>::infinity(), low = top, high = -top;
    void join(const OwnRange& other) {
      top = std::min(top, other.top);
      low = std::min(low, other.low);
      high = std::max(high, other.high);
    }
  };

  /// The limits of the heights of the points that belong to a slice [m], none by default, and where
  /// its points begin and end among the members.
  struct Limits {
    float low_z = 0.0f, high_z = 0.0f;
    std::size_t first = 0, end = 0;
  };

  void sort_along(const Eigen::Vector3d& closing);
  void sort_keys();
  /// The heights above and below which no slice has points [m].
  struct Window {
    float low = -std::numeric_limits<float>::infinity(), high = -low;
  };

  void find_strips(const Eigen::Matrix3d& R, const Points& points, double first, int steps,
                   const Window& window);
  Window window() const;
  void find_own_ranges(const Eigen::Matrix3d& R, double first, int steps);
  void fill(const Eigen::Matrix3d& R, double first);
  std::span<const InSlice> within_reach(std::size_t n) const;

  /// The width of a step, and what a hand spans beside an own point, with one gap farther [m].
  double step_, reach_;
  SliceHeights heights_;
  Points points_, own_;
  /// The closing direction along which the points are sorted.
  Eigen::Vector3d closing_ = Eigen::Vector3d::Zero();
  /// The points within reach of the own ones, sorted: their positions, places along the closing
  /// direction and indices. The places of the own points, in the original order.
  Points sorted_;
  Eigen::ArrayXf y_;
  Eigen::Array<std::uint32_t, Eigen::Dynamic, 1> index_;
  Eigen::ArrayXf own_y_;
  // Kept to reuse their memory:
  std::vector<std::int64_t> keys_, sorted_keys_;
  std::vector<std::uint32_t> kept_;
  Eigen::ArrayXd places_;
  Eigen::ArrayXi strips_;
  Eigen::ArrayXf z_;
  std::vector<OwnRange> own_strips_, ranges_;
  std::vector<std::size_t> counts_;
  std::vector<Limits> limits_;
  std::vector<InSlice> members_;
  std::vector<FingerSlice> slices_;
};

}  // namespace quadrille
