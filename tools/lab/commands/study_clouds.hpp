#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/frame_arguments.hpp"
#include "lab/study/study_scene.hpp"
#include "logs/cloud_log_reader.hpp"

namespace quadrille {

/// One cloud of the inputs of a study.
struct StudyCloud {
  /// The path; of a log's clouds PATH#1, PATH#2, …
  std::string name;
  std::string path;
  /// Its place in a log from 1 on; 0 for a file of one cloud.
  int place = 0;
};

/// The clouds of files, logs and folders of them, in the order given and within a folder by name,
/// its folders included.
/// @throws io::FileError if one is given twice, is missing, or is no cloud and no log
std::vector<StudyCloud> list_clouds(const std::vector<std::string>& inputs);

/// Reads clouds on any thread. A log is read once, in its order.
class StudyCloudReader {
 public:
  /// @param clouds  those that will be asked for
  StudyCloudReader(const std::vector<StudyCloud>& clouds, const FrameArguments& frames);

  /// With the truth beside it, if there is any.
  /// @throws std::runtime_error naming what cannot be read
  study::StudyInput read(const StudyCloud& cloud);

 private:
  /// A log that is being read, with the clouds that came before their turn.
  struct OpenLog {
    std::unique_ptr<logs::CloudLogReader> reader;
    int last = 0;
    std::map<int, PointCloud> waiting;
  };

  PointCloud from_log(const StudyCloud& cloud);

  FrameArguments frames_;
  std::mutex mutex_;
  std::map<std::string, std::set<int>> wanted_;
  std::map<std::string, OpenLog> logs_;
};

}  // namespace quadrille
