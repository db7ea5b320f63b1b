#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "lab/experiments/plot.hpp"

namespace quadrille::study {

/// A count out of a total.
struct Ratio {
  int counted = 0, of = 0;
};

/// The first grasp of a target, judged and perhaps tried.
struct FirstGrasp {
  double score = 0.0;
  std::string object_type;
  bool good = false, tried = false, held = false;
};

/// All scenes with the same settings.
struct GroupSummary {
  /// "franka, unknown obstacle, tabletop", and for the legend of plots "franka, obstacle,
  /// tabletop".
  std::string name, short_name;
  /// Version and check sum of the settings.
  std::string settings;
  int scenes = 0, failed = 0, without_truth = 0, grasps = 0;
  Ratio objects_with_grasp, objects_with_good, objects_with_held;
  Ratio first_good, first_touching, first_held, all_good, all_touching, all_held;
  std::vector<FirstGrasp> first;
};

/// Sums up the studies of several tables, by gripper and all other settings. A table may be named
/// by either of its files, and more than once.
/// @throws io::FileError if a file is missing or damaged, or a scene occurs in two of the tables
std::vector<GroupSummary> summarise(const std::vector<std::string>& csv_paths);

/// One share of a summary, with its name.
struct Figure {
  std::string name;
  Ratio ratio;
};

/// Returns all shares of a group in the order of the report, those of the first grasps also by type
/// of object; empty if no scene has a ground truth.
std::vector<Figure> figures_of(const GroupSummary& group);

/// Formats a ratio as "312 of 400", "78.0 %" and "73.7 to 81.8 %", Wilson's 95 % interval; as
/// "none", "" and "" if the total is zero.
std::array<std::string, 3> words_of(const Ratio& ratio);

/// Returns a readable summary: shares with Wilson's 95 % intervals, and the first grasps by type of
/// object.
std::string summary_text(const std::vector<GroupSummary>& groups);

/// Plots, for the first grasps with at least a given score, the share that is good and, if any were
/// tried, the share that held.
std::vector<experiments::Plot> score_plots(const std::vector<GroupSummary>& groups);

}  // namespace quadrille::study
