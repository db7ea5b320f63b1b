#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "lab/experiments/plot.hpp"

namespace quadrille::study {

/// So many of so many.
struct Ratio {
  int counted = 0, of = 0;
};

/// A judged, and perhaps tried, first grasp of a target.
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

/// Sums up the studies of some tables, by gripper and all other settings. A table may be named by
/// either of its files, and more than once.
/// @throws io::FileError if a file is missing or damaged, or a scene is in two of them
std::vector<GroupSummary> summarise(const std::vector<std::string>& csv_paths);

/// One share of a summary, by its name.
struct Figure {
  std::string name;
  Ratio ratio;
};

/// All shares of a group in the order in which they are told, the first grasps also by type of
/// object; empty if no scene has a truth.
std::vector<Figure> figures_of(const GroupSummary& group);

/// "312 of 400", "78.0 %" and "73.7 to 81.8 %", Wilson's 95 % interval; "none", "" and "" of
/// nothing.
std::array<std::string, 3> words_of(const Ratio& ratio);

/// For people: shares with Wilson's 95 % intervals, and the first grasps by type of object.
std::string summary_text(const std::vector<GroupSummary>& groups);

/// The share of the first grasps from a score on that are good, and, if any were tried, that were
/// held.
std::vector<experiments::Plot> score_plots(const std::vector<GroupSummary>& groups);

}  // namespace quadrille::study
