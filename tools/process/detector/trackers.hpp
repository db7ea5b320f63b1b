#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <string>

#include "quadrille/detector/tracker.hpp"

namespace quadrille {

/// A tracker for each camera, which is a channel and the name of a frame: what two cameras see is
/// never taken for one.
class Trackers {
 public:
  /// Trackers that are kept; beyond them the one that was not used for longest is given up, and the
  /// tracks of its camera begin anew.
  static constexpr std::size_t kMaxTrackers = 16;

  explicit Trackers(const TrackOptions& options) : options_(options) {}

  Tracker& of(const std::string& channel, const std::string& frame);

  /// Trackers given up so far.
  std::int64_t given_up() const { return given_up_; }

 private:
  struct Camera {
    std::string channel, frame;
    Tracker tracker;
  };

  TrackOptions options_;
  /// The last one used first.
  std::list<Camera> cameras_;
  std::int64_t given_up_ = 0;
};

}  // namespace quadrille
