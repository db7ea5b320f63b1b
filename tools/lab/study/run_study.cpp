#include "lab/study/run_study.hpp"

#include <atomic>
#include <map>
#include <mutex>
#include <stdexcept>

#include "quadrille/detector/parallel_for.hpp"

namespace quadrille::study {
namespace {

/// The rows of one scene.
struct SceneRows {
  std::vector<std::vector<std::string>> grasps;
  std::vector<std::string> scene;
};

SceneRows rows_of(const Study& study, std::size_t index) {
  const SceneName& name = study.names[index];
  StudyInput input;
  try {
    input = study.input(index);
  } catch (const std::runtime_error& error) {
    // A single cloud that cannot be read must not end a study of thousands.
    return {{}, failed_row(study.label, name, error.what())};
  }
  const SceneRecord record = study_scene(input, study.options);
  return {grasp_rows(study.label, name, record), scene_row(study.label, name, record)};
}

/// Receives rows in any order and appends them in the order of the scenes.
class InOrder {
 public:
  InOrder(const Study& study, StudyFiles* files)
      : study_(study), files_(files), start_(files->finished()), next_(start_) {}

  void add(std::size_t index, SceneRows rows) {
    const std::lock_guard lock(mutex_);
    waiting_.emplace(index, std::move(rows));
    ++done_;
    for (auto first = waiting_.begin(); first != waiting_.end() && first->first == next_;
         first = waiting_.erase(first), ++next_) {
      files_->append(first->second.grasps, first->second.scene);
    }
    const double count = static_cast<double>(study_.names.size() - start_);
    if (study_.progress) study_.progress(done_ / count);
  }

 private:
  const Study& study_;
  StudyFiles* files_;
  std::mutex mutex_;
  std::map<std::size_t, SceneRows> waiting_;
  std::size_t start_, next_;
  double done_ = 0.0;
};

}  // namespace

void run_study(const Study& study, StudyFiles* files) {
  const std::size_t start = files->finished();
  InOrder in_order(study, files);
  std::atomic<bool> failed = false;
  parallel_for(static_cast<int>(study.names.size() - start), study.threads, [&](int k) {
    // If rows cannot be written, there is no use in processing further scenes.
    if (failed) return;
    try {
      const std::size_t index = start + static_cast<std::size_t>(k);
      in_order.add(index, rows_of(study, index));
    } catch (...) {
      failed = true;
      throw;
    }
  });
}

std::vector<SceneName> shard_of(const std::vector<SceneName>& names, int shard, int shards) {
  std::vector<SceneName> chosen;
  for (std::size_t i = static_cast<std::size_t>(shard - 1); i < names.size();
       i += static_cast<std::size_t>(shards)) {
    chosen.push_back(names[i]);
  }
  return chosen;
}

}  // namespace quadrille::study
