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

/// One cloud among the inputs of a study.
struct StudyCloud {
  /// The path; for the clouds of a log PATH#1, PATH#2, …
  std::string name;
  std::string path;
  /// Position in the log, from 1 on; 0 for a file with one cloud.
  int place = 0;
};

/// Lists the clouds of files, logs and folders of these, in the given order. Folders are searched
/// recursively, by name.
/// @throws io::FileError if an input is given twice, is missing, or is neither a cloud nor a log
std::vector<StudyCloud> list_clouds(const std::vector<std::string>& inputs);

/// Reads clouds on any thread. A log is read once, in its own order.
class StudyCloudReader {
 public:
  /// @param clouds  the clouds that will be requested
  StudyCloudReader(const std::vector<StudyCloud>& clouds, const FrameArguments& frames);

  /// Reads a cloud, with the ground truth beside it if there is any.
  /// @throws std::runtime_error naming what cannot be read
  study::StudyInput read(const StudyCloud& cloud);

 private:
  /// A log that is being read, with the clouds that were read before they were requested.
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
