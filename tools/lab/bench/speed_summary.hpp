#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "lab/bench/speed.hpp"
#include "lab/bench/speed_baseline.hpp"

namespace quadrille::bench {

/// Share of instructions beyond the baseline's that is too much.
inline constexpr double kTooMuch = 0.03;

/// The cost of one stage, as the mean over the clouds of a set. What is unknown is NaN.
struct StageSpeed {
  std::string stage;
  /// Time [ms] and the floor below it.
  double ms = 0.0, floor_ms = 0.0;
  /// Number of instructions, the floor below it, and the number in the baseline.
  double instructions = std::nan(""), floor_instructions = std::nan(""), stored = std::nan("");

  /// Share by which the instructions exceed those of the baseline; NaN if either is unknown.
  double change() const { return instructions / stored - 1.0; }
};

/// The costs of detection in a set of clouds.
struct SpeedSet {
  std::string name;
  int clouds = 0;
  /// In the order of the stages.
  std::vector<StageSpeed> stages;
  StageSpeed total;
  double cgal_ms = std::nan("");
  /// Why the set was not compared with the baseline; empty if it was.
  std::string not_compared;

  /// True if detection needs more instructions than the baseline and kTooMuch of them.
  bool is_too_slow() const { return not_compared.empty() && total.change() > kTooMuch; }
};

/// Sums up the clouds of each set and compares them with the baseline, if all of them are in it and
/// the same compiler has built both.
/// @param built_by  how the detector was built that was measured
/// @return the sets in the order of their first clouds
std::vector<SpeedSet> summarise(const std::vector<CloudSpeed>& clouds,
                                const SpeedBaseline& baseline, const std::string& built_by);

/// Makes a baseline of what was counted.
SpeedBaseline baseline_of(const std::vector<CloudSpeed>& clouds, const std::string& built_by);

}  // namespace quadrille::bench
