#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "process/planner/messages.hpp"
#include "process/planner/settings.hpp"
#include "process/runtime/limited_log.hpp"
#include "run/publish.hpp"
#include "run/rate_limiter.hpp"

namespace quadrille {

/// Publishes the occupancy of clouds at a limited rate. Of the maps that come too soon after
/// another, the newest waits. For the working thread only.
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
  /// @return number of bytes published
  std::int64_t add(Map map);
  /// Returns the waiting map, if it is due now.
  std::optional<Map> take_due();
  /// Publishes a map at once; a map that does not fit into an OctoMap is logged instead.
  /// @return number of bytes published
  std::int64_t publish(const Map& map);

 private:
  const std::string channel_;
  const bus::Publish publish_;
  bus::RateLimiter due_;
  LimitedLog log_;
  std::optional<Map> late_;
};

}  // namespace quadrille
