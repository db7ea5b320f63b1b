#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lab/study/study_scene.hpp"

namespace quadrille::study {

/// The settings that every row of a study names, by column.
using Label = std::vector<std::pair<std::string, std::string>>;

/// @param family  family of the scenes; empty for given clouds
/// @param settings  all settings as text, of which the label holds a short check sum
Label label_of(const StudyOptions& options, const std::string& version, const std::string& family,
               const std::string& settings);

/// The scene of a study that a row describes.
struct SceneName {
  /// Number from 1 on, over all inputs and shards.
  int number = 1;
  /// Where the row's scene comes from: the file of a given cloud, or the family and the seed of a
  /// generated scene.
  std::string input;
  /// Seed of the generated scene; empty for a given cloud.
  std::string seed;
};

/// The columns of the tables of grasps and of scenes; the label's columns come first.
const std::vector<std::string>& grasp_columns();
const std::vector<std::string>& scene_columns();

/// Returns one row per grasp, best first. Cells that need a ground truth or a trial are empty
/// without it.
std::vector<std::vector<std::string>> grasp_rows(const Label& label, const SceneName& name,
                                                 const SceneRecord& record);

/// Returns the row of a scene.
std::vector<std::string> scene_row(const Label& label, const SceneName& name,
                                   const SceneRecord& record);

/// Returns the row of an input that could not be used.
std::vector<std::string> failed_row(const Label& label, const SceneName& name,
                                    const std::string& error);

}  // namespace quadrille::study
