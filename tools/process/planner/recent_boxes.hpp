#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "quadrille/bus/boxes_message.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// The boxes of the last clouds. The detector sends them before the quadrics of the same cloud.
class RecentBoxes {
 public:
  void add(bus::BoxesMessage boxes);

  /// Takes the newest boxes with the utime, seq and frame of the quadrics, and forgets older ones;
  /// nullopt if they have not come, as with a detector that sends none. To be called as soon as the
  /// quadrics have come, since senders that do not tell the time give all clouds the same stamps.
  std::optional<std::vector<Box>> take(const bus::QuadricsMessage& quadrics);

 private:
  std::deque<bus::BoxesMessage> messages_;
};

}  // namespace quadrille
