#include "boxes/box_hints.hpp"

#include <algorithm>
#include <set>

#include "boxes/box_ends.hpp"
#include "boxes/flat_patches.hpp"

namespace quadrille {
namespace {

/// Ids of the planes that may be faces of a box. A plane that is longer than half the longest side
/// is a shelf or a wall, which connects things.
std::set<int> small_planes(const std::vector<Detection>& detections) {
  std::set<int> ids;
  for (const Detection& d : detections) {
    const bool small = d.extent_Q.sizes().maxCoeff() <= 0.5 * kMaxSide;
    if (d.type == QuadricType::kPlane && small) ids.insert(d.id);
  }
  return ids;
}

/// The planes on which things may stand: those that are too large for a face.
std::vector<Eigen::Hyperplane<double, 3>> floors_of(const std::vector<Detection>& detections) {
  std::vector<Eigen::Hyperplane<double, 3>> floors;
  for (const Detection& d : detections) {
    const bool large = d.extent_Q.sizes().maxCoeff() > 0.5 * kMaxSide;
    if (d.type != QuadricType::kPlane || !large) continue;
    floors.emplace_back(outward_normal(d), d.X_CQ.translation());
  }
  return floors;
}

}  // namespace

BoxHints find_box_hints(const SurfaceSamples& samples, const PlaneOptions& options,
                        const Mask& free, const std::vector<Detection>& detections,
                        const std::vector<int>& owner, std::size_t view) {
  BoxHints hints;
  hints.patches = find_flat_patches(samples, options, free);
  const std::set<int> planes = small_planes(detections);
  Mask open = free;
  for (int i = 0; i < samples.size(); ++i) {
    if (samples.view_of(i) == view && planes.contains(owner[i])) open[i] = 1;
  }
  hints.seeds = find_box_seeds(samples, open, floors_of(detections));
  return hints;
}

}  // namespace quadrille
