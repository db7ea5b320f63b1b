#pragma once

#include <functional>
#include <list>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "view/backend.hpp"
#include "view/log/log_frames.hpp"
#include "view/scene/scene.hpp"

namespace quadrille::view {

/// Detects and plans on one cloud of a log.
/// @throws std::invalid_argument if the choice names something that does not exist
using MakeScene = std::function<Scene(LogFrame frame, const PlanChoice& choice)>;

/// Shows the clouds of a log. Each cloud is processed when it is first requested, one at a time.
class LogBackend : public Backend {
 public:
  /// Limit of the packed scenes that are kept [byte].
  static constexpr std::size_t kMaxCacheBytes = std::size_t{128} << 20;

  /// @param grippers  names of the grippers that may be chosen
  LogBackend(LogFrames frames, std::vector<std::string> grippers, MakeScene make_scene,
             const PackLimits& limits = {});

  io::Json session() override;
  Pack frame(std::size_t number, const PlanChoice& choice) override;

 private:
  using Key = std::pair<std::size_t, PlanChoice>;

  Pack cached(const Key& key);
  void keep(const Key& key, const Pack& pack);

  LogFrames frames_;
  std::vector<std::string> grippers_;
  MakeScene make_scene_;
  PackLimits limits_;
  std::mutex work_mutex_, cache_mutex_;
  /// Cached scenes, the most recently used first.
  std::list<std::pair<Key, Pack>> cache_;
  std::size_t cached_bytes_ = 0;
};

}  // namespace quadrille::view
