#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <string>

#include "quadrille/detector/tracker.hpp"

namespace quadrille {

/// Keeps a tracker for each camera, given by a channel and the name of a frame, so that objects
/// seen by different cameras are never matched.
class Trackers {
 public:
  /// Limit of the trackers that are kept. Beyond it, the one that was unused for the longest time
  /// is given up, and the tracks of its camera begin anew.
  static constexpr std::size_t kMaxTrackers = 16;

  explicit Trackers(const TrackOptions& options) : options_(options) {}

  Tracker& of(const std::string& channel, const std::string& frame);

  /// Number of trackers given up so far.
  std::int64_t given_up() const { return given_up_; }

 private:
  struct Camera {
    std::string channel, frame;
    Tracker tracker;
  };

  TrackOptions options_;
  /// The cameras, the most recently used first.
  std::list<Camera> cameras_;
  std::int64_t given_up_ = 0;
};

}  // namespace quadrille
