#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "io/settings/config.hpp"
#include "lab/bench/frames.hpp"
#include "lab/bench/instructions.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille::bench {

/// Number of detections in each cloud; the best time of each stage counts.
inline constexpr int kSpeedRuns = 5;

/// What to measure.
struct SpeedOptions {
  /// The clouds need no truth.
  FrameOptions frames;
  /// The detector's settings, and the file from which they are; empty for the defaults.
  io::DetectorConfig config;
  std::string config_path;
  /// Folder of the programs of peers, and of the one whose instructions are counted.
  std::string programs;
};

/// The cost of detection in a cloud, with one thread.
struct CloudSpeed {
  /// Family of a generated scene, or folder of a file.
  std::string set;
  /// Name in the baseline.
  std::string name;
  std::size_t points = 0;
  /// Best times by stage, and best time in all [ms].
  std::vector<StageTime> stages;
  double total_ms = 0.0;
  /// Best times of one pass over all points, and over all samples [ms].
  double points_ms = 0.0, samples_ms = 0.0;
  /// Processor time of CGAL's Efficient RANSAC [ms]; NaN if it is not built.
  double cgal_ms = std::nan("");
  /// By stage, and of both passes; empty if they cannot be counted.
  Instructions counts;
};

/// Detects in each cloud, and counts instructions if they can be counted; see why_not_counted().
/// @throws std::runtime_error if a cloud cannot be read, or a program fails
std::vector<CloudSpeed> measure_speed(const SpeedOptions& options);

}  // namespace quadrille::bench
