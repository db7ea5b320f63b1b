#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/options.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::bench {

/// Number of runs on each cloud with other seeds, and number with the cells shifted.
inline constexpr int kStabilityRuns = 8;

/// Score from which a surface counts as sure.
inline constexpr double kSureScore = 0.8;

/// Largest distance of the same surface in two runs, as a share of its size.
inline constexpr double kSameDistance = 0.7;

/// How often several runs on one cloud find the same curved surfaces.
struct StabilityCounts {
  /// Number of surfaces that any run finds, that all runs find, and that all runs find with the
  /// same type.
  int in_any = 0, in_all = 0, same_type = 0;
  /// Number of surfaces whose score reaches kSureScore in a run, and of those that all runs find.
  int sure_in_any = 0, sure_in_all = 0;

  /// Adds all counts.
  StabilityCounts& operator+=(const StabilityCounts& other);
};

/// Counts the curved detections that were asked for. Two detections of different runs are the same
/// surface if the centres of their extents are closer than kSameDistance of the mean diagonal of
/// their extents and neither has a nearer partner; types do not matter.
StabilityCounts count_stable(std::span<const std::vector<Detection>> runs);

/// The cloud with its cells shifted. A single view loses its first columns and rows of pixels, from
/// which the cells are counted. The points and the viewpoint of any other cloud, whose cells are
/// counted from the origin, move along each axis by this many eighths of a cell.
/// @param pixels  0 to 7
PointCloud shifted(PointCloud cloud, int pixels, const DetectorOptions& options);

/// The counts of a cloud.
struct Stability {
  std::string cloud;
  /// Runs with seeds 1, 2, …, and runs with seed 1 and cells shifted by 0, 1, … pixels.
  StabilityCounts seeds, shifts;
};

/// Detects on each cloud with several seeds and several shifts.
/// @param progress  called with the share of the work that is done, 0 to 1
/// @throws std::runtime_error if a cloud cannot be read
std::vector<Stability> measure_stability(const std::vector<std::string>& clouds,
                                         const DetectorOptions& options,
                                         const std::function<void(double)>& progress);

}  // namespace quadrille::bench
