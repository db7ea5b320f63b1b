#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "planes/planes.hpp"
#include "quadrille/detector/options.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "samples/sample_tree.hpp"
#include "surfaces/evidence/scene_context.hpp"

namespace quadrille::trials {

/// The samples on which the detector's search works, for a cloud near the origin.
struct SearchSamples {
  /// The coarsest samples, and the planes among them.
  SurfaceSamples coarse;
  std::vector<PlaneRegion> planes;
  SceneContext context;
  /// The samples off the planes.
  std::unique_ptr<SampleTree> tree;
};

/// Makes the samples as the detector does; nullopt if the cloud gives none.
std::optional<SearchSamples> search_samples(const PointCloud& cloud,
                                            const DetectorOptions& options);

}  // namespace quadrille::trials
