#pragma once

#include <vector>

#include "bodies/support.hpp"
#include "bodies/walls.hpp"
#include "quadrille/detector/body.hpp"
#include "quadrille/detector/detection.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// The input of find_bodies(): all that was found in one cloud, which lies near the origin.
struct BodySources {
  const std::vector<Detection>& detections;
  const std::vector<Box>& boxes;
  /// Samples beside the large planes, and for each the id of the detection on which it lies. It
  /// is 0 if there is none, and negative if the detection was not asked for.
  const SurfaceSamples& samples;
  const std::vector<int>& owner;
  /// Places on the planes among the detections.
  const PlacesOnPlanes& places_C;
  /// Walls whose sides are among the detections.
  const std::vector<SeenWall>& walls;
  /// False if only some types were asked for: then what nothing explains is not asked for either,
  /// and there are no lumps.
  bool all_types = true;
};

/// Groups what was found into bodies: boxes with their faces, surfaces that share an axis with
/// their lids, other curved surfaces and small planes alone, and lumps of points above a support
/// that nothing explains. Points that are connected to a body with more points, such as those of a
/// handle, count as its own. Bodies come in the order of their ids.
std::vector<SceneBody> find_bodies(const BodySources& found);

}  // namespace quadrille
