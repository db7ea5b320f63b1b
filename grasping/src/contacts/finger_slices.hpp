#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <span>
#include <vector>

#include "quadrille/grasping/gripper.hpp"

namespace quadrille {

/// The points that a finger covers at one place of the hand.
struct FingerSlice {
  /// Middle of the finger, across the closing direction and the approach [m].
  double x = 0.0;
  /// How far the highest own point lies along the approach [m].
  float top = 0.0f;
  /// The points by their places in SortedPoints, so that they are sorted, too.
  std::span<const std::uint32_t> points;
};

/// Points that are sorted along the closing direction.
struct SortedPoints {
  /// How far the points lie along the closing direction, and the same as floats; how far they lie
  /// along the approach [m].
  const double* exact_y = nullptr;
  const float *y = nullptr, *z = nullptr;
  /// Their indices in the original order.
  std::span<const std::uint32_t> index;
  /// The number of the closing direction, in the order in which directions came first.
  std::size_t direction = 0;
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
  /// Points are sorted once for each closing direction.
  /// @param R  axes of the hand as columns: y closing, z approach
  /// @return the slices at these places that hold own points; they last until the next call
  const std::vector<FingerSlice>& cut(const Eigen::Matrix3d& R);
  /// The points as they were sorted for the last call. Those that no slice for its closing
  /// direction can hold are missing. They last as long as these slices.
  SortedPoints sorted() const;

 private:
  using Points = Eigen::Matrix<double, Eigen::Dynamic, 3>;
  /// Values that are all written before they are read. Unlike vectors, these arrays are not filled
  /// with zeros first, and do not check each access.
  template <class Value>
  using Values = Eigen::Array<Value, Eigen::Dynamic, 1>;

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

  /// Heights between two limits; none by default [m].
  struct Window {
    float low = std::numeric_limits<float>::infinity(), high = -low;
  };

  /// The points that a slice for one closing direction may hold, sorted along it: their positions,
  /// places along the direction, indices, and which of them are own.
  struct Sorted {
    Eigen::Vector3d closing = Eigen::Vector3d::Zero();
    Points points;
    Values<double> exact_y;
    Values<float> y;
    Values<std::uint32_t> index, own_places;
  };

  const Sorted& sorted_along(const Eigen::Vector3d& closing);
  void sort(Sorted& sorted);
  void find_keys(const Eigen::Vector3d& closing, double low, double high, double farthest);
  void sort_keys();
  void find_strips(const Eigen::Matrix3d& R, double first, int steps);
  void find_own_ranges(int steps);
  void find_windows();
  void fill();
  std::span<const std::uint32_t> within_reach(std::size_t n) const;

  /// The width of a step, and what a hand spans beside an own point, with one gap farther [m].
  double step_, reach_;
  SliceHeights heights_;
  Points points_, own_;
  std::vector<char> is_own_;
  /// The middle of the own points, and the squared distances of all points from it [m, m²].
  Eigen::Vector3d middle_ = Eigen::Vector3d::Zero();
  Eigen::ArrayXd squares_, own_squares_;
  /// The points for each closing direction so far, and those for that of the last call.
  std::deque<Sorted> directions_;
  const Sorted* sorted_ = nullptr;
  // Kept to reuse their memory:
  Values<std::int64_t> keys_, sorted_keys_;
  Eigen::Index key_count_ = 0;
  Values<std::uint32_t> kept_;
  Eigen::ArrayXd places_, own_y_;
  Values<int> strips_;
  Values<float> z_;
  std::vector<OwnRange> own_strips_, ranges_;
  std::vector<Window> windows_;
  std::vector<std::size_t> counts_;
  std::vector<Limits> limits_;
  std::vector<std::uint32_t> members_;
  std::vector<FingerSlice> slices_;
};

}  // namespace quadrille
