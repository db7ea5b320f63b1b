#pragma once

#include <memory>

#include "quadrille/detector/export.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/grasping/plan_options.hpp"

namespace quadrille {

struct SeenParts;

/// A cloud with the depth image that its sensor saw. Only the cloud is needed for it, so that it
/// can be made while detections are still being sought. A GraspScene made of it is the same, bit by
/// bit, as one made of the cloud, and takes less time.
class SeenCloud {
 public:
  /// @param cloud    in frame C, with its viewpoint
  /// @param options  those of the scene; only the resolution and the baseline count
  /// @throws std::invalid_argument if an option is out of range
  QUADRILLE_EXPORT SeenCloud(PointCloud cloud, const PlanOptions& options);
  QUADRILLE_EXPORT SeenCloud(SeenCloud&&) noexcept;
  QUADRILLE_EXPORT SeenCloud& operator=(SeenCloud&&) noexcept;
  QUADRILLE_EXPORT ~SeenCloud();

  QUADRILLE_EXPORT const PointCloud& cloud() const;

 private:
  friend class GraspScene;

  PointCloud cloud_;
  double resolution_, baseline_;
  std::unique_ptr<SeenParts> parts_;
};

}  // namespace quadrille
