#include "process/planner/map_publisher.hpp"

#include <fmt/format.h>

#include <chrono>
#include <stdexcept>
#include <utility>

#include "quadrille/bus/encode.hpp"
#include "quadrille/grasping/rigid_motion.hpp"

namespace quadrille {
namespace {

using Space = std::shared_ptr<const OccupancyGrid>;

/// Transforms the map from frame K into frame R.
Space in_frame(const Space& space, const Eigen::Isometry3d& X_RK) {
  if (!space || X_RK.matrix().isIdentity(0.0)) return space;
  return std::make_shared<const OccupancyGrid>(space->moved(X_RK));
}

/// Returns the least time between maps; 0 in a replay, whose results must not depend on its speed.
std::chrono::milliseconds interval_of(const PlannerSettings& settings) {
  if (!settings.process.in_log.empty()) return std::chrono::milliseconds(0);
  return std::chrono::milliseconds(static_cast<int>(1000.0 * settings.occupancy_period));
}

}  // namespace

MapPublisher::MapPublisher(const PlannerSettings& settings, bus::Publish publish)
    : channel_(settings.occupancy_channel),
      publish_(std::move(publish)),
      due_(interval_of(settings)) {}

std::int64_t MapPublisher::add(Map map) {
  if (!due_.admit()) {
    late_ = std::move(map);
    return 0;
  }
  late_.reset();
  return publish(map);
}

std::optional<MapPublisher::Map> MapPublisher::take_due() {
  if (!late_ || !due_.admit()) return std::nullopt;
  return std::exchange(late_, std::nullopt);
}

std::int64_t MapPublisher::publish(const Map& map) {
  try {
    const auto bytes =
        bus::encode(make_occupancy_message(map.stamp, in_frame(map.space, map.X_RK).get()));
    publish_(channel_, bytes);
    return static_cast<std::int64_t>(bytes.size());
  } catch (const std::invalid_argument& error) {
    // The grasps are already published. In frame W, a map may lie too far from the origin.
    log_.warning(
        fmt::format("{}: no map of cloud {}: {}", channel_, map.stamp.utime, error.what()));
    return 0;
  }
}

}  // namespace quadrille
