#include "quadrille/grasping/seen_cloud.hpp"

#include <utility>

#include "scene/seen_parts.hpp"

namespace quadrille {

SeenCloud::SeenCloud(PointCloud cloud, const PlanOptions& options)
    : cloud_(std::move(cloud)), resolution_(options.resolution), baseline_(options.baseline) {
  options.check();
  parts_ = std::make_unique<SeenParts>(cloud_, options);
}

SeenCloud::SeenCloud(SeenCloud&&) noexcept = default;
SeenCloud& SeenCloud::operator=(SeenCloud&&) noexcept = default;
SeenCloud::~SeenCloud() = default;

const PointCloud& SeenCloud::cloud() const { return cloud_; }

}  // namespace quadrille
