#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lab/study/rows.hpp"

namespace quadrille::study {

/// The table of scenes beside that of grasps: NAME.scenes.csv of NAME.csv.
std::string scenes_path(const std::string& csv_path);

/// The two tables of a study, which grow scene by scene and are taken up again after a stop.
///
/// A scene's row is written after its grasps, so that what has a row is whole. What a stop left
/// behind of a scene that was not finished is cut off.
class StudyFiles {
 public:
  /// @param csv_path  the table of grasps
  /// @param names     the scenes of the study in the order in which they are appended
  /// @throws io::FileError if the files are another study's, damaged, in use, or cannot be written
  StudyFiles(const std::string& csv_path, const Label& label, const std::vector<SceneName>& names);
  StudyFiles(const StudyFiles&) = delete;
  StudyFiles& operator=(const StudyFiles&) = delete;
  ~StudyFiles();

  /// How many of the scenes were there already.
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
