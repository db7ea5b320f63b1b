#include "process/detector/node.hpp"

namespace quadrille {

/// Publishes the messages for Meldis after the results.
void DetectorNode::show(const bus::CloudMessage& cloud, const Placement& placement,
                        const DetectionResult& result) {
  const auto points = encode_viewer_cloud(cloud, placement.X_RK * placement.X_CK.inverse());
  publish_(settings_.viewer_cloud_channel, points);
  const std::int64_t bytes =
      viewer_->show(cloud.utime, links_of(result)) + static_cast<std::int64_t>(points.size());
  const std::lock_guard lock(mutex_);
  counts_.published_bytes += bytes;
}

}  // namespace quadrille
