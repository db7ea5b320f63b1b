#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "lab/study/rows.hpp"
#include "lab/study/study_files.hpp"
#include "lab/study/study_scene.hpp"

namespace quadrille::study {

/// A study, or one shard of it.
struct Study {
  StudyOptions options;
  Label label;
  /// The scenes, in the order of the rows of the table that the study writes.
  std::vector<SceneName> names;
  /// Makes or reads the cloud of a scene, on any thread. If it throws std::runtime_error, the scene
  /// gets a row that says it failed.
  std::function<StudyInput(std::size_t)> input;
  int threads = 1;
  /// Called with the share of the remaining work that is done.
  std::function<void(double)> progress;
};

/// Processes all scenes that the files do not contain yet, and appends them in the order of the
/// scenes, so that the rows are the same for any number of threads.
/// @throws io::FileError if the files cannot be written
void run_study(const Study& study, StudyFiles* files);

/// Returns the scenes of shard `shard` (from 1 on) of `shards`: every shards-th one.
std::vector<SceneName> shard_of(const std::vector<SceneName>& names, int shard, int shards);

}  // namespace quadrille::study
