#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "quadrille/detector/tracker.hpp"
#include "quadrille/inputs.hpp"

namespace quadrille {

/// Tracks the clouds of each source, which is a channel of a log, or all files together.
class Tracking {
 public:
  Tracking(const TrackOptions& options, bool files_too)
      : options_(options), files_too_(files_too) {}

  void add_to(const InputCloud& input, const std::string& path, DetectionResult* result);

 private:
  TrackOptions options_;
  bool files_too_;
  std::int64_t files_ = 0;
  std::map<std::pair<std::string, std::string>, Tracker> trackers_;
};

}  // namespace quadrille
