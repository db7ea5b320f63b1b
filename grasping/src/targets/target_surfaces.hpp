#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "contacts/surface_points.hpp"
#include "space/collision.hpp"
#include "targets/target.hpp"

namespace quadrille {

struct SceneParts;

/// The measured surfaces about all targets of a scene. The surroundings of targets overlap, so
/// targets on the same supports share one surface. It is made when it is asked for first, and
/// several threads may ask at once.
class TargetSurfaces {
 public:
  TargetSurfaces() = default;
  explicit TargetSurfaces(const std::vector<Target>& targets);

  /// Returns the surface that shows the surroundings of a target, as far as the hand opens, without
  /// its supports.
  const PointSurface& about(const Target& target, const SceneParts& parts) const;

 private:
  /// The surface about the targets that stand on the same planes.
  struct Shared {
    std::vector<SupportPlane> supports;
    std::once_flag once;
    std::optional<PointSurface> surface;
  };
  Shared* find(const Target& target) const;

  std::vector<std::unique_ptr<Shared>> shared_;
};

/// Returns the region about a target of which the surface tells.
Eigen::AlignedBox3d surroundings_of(const Target& target, const SceneParts& parts);

}  // namespace quadrille
