#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "process/planner/messages.hpp"
#include "process/planner/settings.hpp"
#include "quadrille/bus/publish.hpp"
#include "quadrille/bus/rate_limiter.hpp"

namespace quadrille {

/// Publishes the occupancy of clouds, no more often than asked: the newest of those that come too
/// soon after another waits. For the working thread.
class MapPublisher {
 public:
  /// The space of a cloud, in the camera's frame K.
  struct Map {
    Stamp stamp;
    std::shared_ptr<const OccupancyGrid> space;
    Eigen::Isometry3d X_RK;
  };

  MapPublisher(const PlannerSettings& settings, bus::Publish publish);

  /// Publishes the map now, in the frame of the results, or keeps it until it is due.
  /// @return how many bytes went out
  std::int64_t add(Map map);
  /// The map that waited, if it is due now.
  std::optional<Map> take_due();
  /// Publishes a map at once; one that has no place in an OctoMap is logged.
  /// @return how many bytes went out
  std::int64_t publish(const Map& map);

 private:
  const std::string channel_;
  const bus::Publish publish_;
  bus::RateLimiter due_, log_;
  std::optional<Map> late_;
};

}  // namespace quadrille
