#include "process/detector/trackers.hpp"

#include <algorithm>

namespace quadrille {

Tracker& Trackers::of(const std::string& channel, const std::string& frame) {
  const auto found = std::find_if(cameras_.begin(), cameras_.end(), [&](const Camera& camera) {
    return camera.channel == channel && camera.frame == frame;
  });
  if (found != cameras_.end()) {
    cameras_.splice(cameras_.begin(), cameras_, found);
  } else {
    cameras_.push_front({channel, frame, Tracker(options_)});
  }
  if (cameras_.size() > kMaxTrackers) {
    cameras_.pop_back();
    ++given_up_;
  }
  return cameras_.front().tracker;
}

}  // namespace quadrille
