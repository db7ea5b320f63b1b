#include "lab/commands/study_clouds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "io/cloud_file.hpp"
#include "io/file_bytes.hpp"
#include "lab/scene/scene_files.hpp"
#include "log/event_log.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille {
namespace {

namespace fs = std::filesystem;

bool is_log(const std::string& path) { return path.ends_with(".lcm") || bus::starts_as_log(path); }

std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string path = entry.path().string();
    const bool fits = path.ends_with(".ply") || path.ends_with(".pcd") || path.ends_with(".lcm");
    if (entry.is_regular_file() && fits) files.push_back(path);
  }
  std::sort(files.begin(), files.end());
  if (files.empty()) throw io::FileError(folder, "", "holds no .ply, .pcd or .lcm");
  return files;
}

void list_log(const std::string& path, std::vector<StudyCloud>* clouds) {
  logs::CloudLogReader reader(path);
  int count = 0;
  while (reader.next()) {
    ++count;
    clouds->push_back({fmt::format("{}#{}", path, count), path, count});
  }
  if (count == 0) throw io::FileError(path, "", "holds no cloud; record POINT_CLOUD messages");
}

std::optional<physics::TrueScene> truth_beside(const std::string& path) {
  if (!path.ends_with(".ply") || !scene::find_truth(path)) return std::nullopt;
  try {
    return physics::read_true_scene(path);
  } catch (const io::FileError&) {
    // NAME.json may be anything, such as a plan, but NAME.truth.json must be a ground truth.
    if (fs::exists(scene::truth_path(path))) throw;
    return std::nullopt;
  }
}

}  // namespace

std::vector<StudyCloud> list_clouds(const std::vector<std::string>& inputs) {
  std::vector<StudyCloud> clouds;
  std::set<std::string> seen;
  for (const std::string& input : inputs) {
    const bool is_folder = fs::is_directory(input);
    for (const std::string& path : is_folder ? files_in(input) : std::vector{input}) {
      std::error_code missing;
      if (!fs::exists(path, missing)) throw io::FileError(path, "", "no such file or folder");
      if (!seen.insert(fs::weakly_canonical(path, missing).string()).second) {
        throw io::FileError(path, "", "is given twice; give each cloud once");
      }
      if (is_log(path)) {
        list_log(path, &clouds);
      } else {
        clouds.push_back({path, path, 0});
      }
    }
  }
  return clouds;
}

StudyCloudReader::StudyCloudReader(const std::vector<StudyCloud>& clouds,
                                   const FrameArguments& frames)
    : frames_(frames) {
  for (const StudyCloud& cloud : clouds) wanted_[cloud.path].insert(cloud.place);
}

study::StudyInput StudyCloudReader::read(const StudyCloud& cloud) {
  study::StudyInput input;
  input.X_CK = frames_.working_frame();
  const Eigen::Isometry3d X_KC = input.X_CK.inverse();
  if (cloud.place > 0) {
    input.cloud = moved(from_log(cloud), X_KC);
  } else {
    input.cloud = io::read_cloud(cloud.path, X_KC);
    input.truth = truth_beside(cloud.path);
  }
  frames_.place_viewpoint(&input.cloud);
  return input;
}

PointCloud StudyCloudReader::from_log(const StudyCloud& cloud) {
  const std::lock_guard lock(mutex_);
  OpenLog& log = logs_[cloud.path];
  if (!log.reader) log.reader = std::make_unique<logs::CloudLogReader>(cloud.path);
  const std::set<int>& wanted = wanted_[cloud.path];
  while (log.last < cloud.place) {
    auto next = log.reader->next();
    if (!next) throw io::FileError(cloud.path, "", "has become shorter while it was read");
    if (wanted.count(++log.last)) log.waiting.emplace(log.last, std::move(next->message.cloud));
  }
  const auto found = log.waiting.extract(cloud.place);
  if (cloud.place == *wanted.rbegin()) log.reader.reset();
  return std::move(found.mapped());
}

}  // namespace quadrille
