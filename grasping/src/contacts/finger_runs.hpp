#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "contacts/finger_slices.hpp"

namespace quadrille {

/// The first and the last one of points without a gap between them, by their places in a slice.
struct Run {
  std::size_t first = 0, last = 0;
};

/// Finds the runs of points that fingers reach at several depths, in which there is no gap for a
/// finger.
class FingerRuns {
 public:
  /// Largest number of depths.
  static constexpr std::size_t kMaxDepths = 8;

  /// @param gap  the least distance between the points of different runs [m]
  explicit FingerRuns(float gap) : gap_(gap) {}

  /// Finds the runs at all depths in one pass over the points.
  /// @param points  the points of a slice, by their places in `sorted`
  /// @param tips, roots  how far the tips and the roots of the fingers reach along the approach at
  ///                     each depth; as many as each other, and at most kMaxDepths [m]
  void find(const SortedPoints& sorted, std::span<const std::uint32_t> points,
            std::span<const float> tips, std::span<const float> roots);

  /// The runs at one of these depths, in the order of their points.
  const std::vector<Run>& at(std::size_t depth) const { return runs_[depth]; }

 private:
  float gap_;
  std::array<std::vector<Run>, kMaxDepths> runs_;
};

}  // namespace quadrille
