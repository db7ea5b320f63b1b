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
  /// The scenes, in the order of the rows.
  std::vector<SceneName> names;
  /// Makes or reads the cloud of one of them, on any thread. What it throws as std::runtime_error
  /// becomes the row of a failed scene.
  std::function<StudyInput(std::size_t)> input;
  int threads = 1;
  /// Called with the share that is done of what there was to do.
  std::function<void(double)> progress;
};

/// Works on all scenes that the files do not have yet, and appends them in the order of the
/// scenes: the same rows for any number of threads.
/// @throws io::FileError if the files cannot be written
void run_study(const Study& study, StudyFiles* files);

/// The scenes of shard `shard` (from 1 on) of `shards`: every shards-th one.
std::vector<SceneName> shard_of(const std::vector<SceneName>& names, int shard, int shards);

}  // namespace quadrille::study
