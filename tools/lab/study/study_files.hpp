#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lab/study/rows.hpp"

namespace quadrille::study {

/// Returns the path of the table of scenes beside that of grasps: NAME.scenes.csv for NAME.csv.
std::string scenes_path(const std::string& csv_path);

/// The two tables of a study, which grow scene by scene and are resumed after an interruption.
///
/// A scene's row is written after its grasps, so that a scene with a row is complete. Rows of a
/// scene that was interrupted are cut off.
class StudyFiles {
 public:
  /// @param csv_path  path of the table of grasps
  /// @param names     the scenes of the study in the order in which they are appended
  /// @throws io::FileError if the files belong to another study, are damaged, in use, or cannot be
  /// written
  StudyFiles(const std::string& csv_path, const Label& label, const std::vector<SceneName>& names);
  StudyFiles(const StudyFiles&) = delete;
  StudyFiles& operator=(const StudyFiles&) = delete;
  ~StudyFiles();

  /// Number of scenes that the files already contained.
  std::size_t finished() const { return finished_; }

  /// Appends the next scene.
  /// @throws io::FileError if that fails
  void append(const std::vector<std::vector<std::string>>& grasps,
              const std::vector<std::string>& scene);

 private:
  void lock();
  void take_up(const Label& label, const std::vector<SceneName>& names);
  void begin();

  std::string grasps_path_, scenes_path_;
  std::size_t finished_ = 0;
  int lock_ = -1;
};

}  // namespace quadrille::study
