#pragma once

#include <vector>

#include "base/mask.hpp"
#include "quadrille/detector/stage_options.hpp"
#include "surfaces/evidence/sample_blocks.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// Extends surfaces over open samples that lie on them, connected or not: for example on the other
/// side of an occluder, or inside a bowl.
class Extender {
 public:
  /// @param samples  the samples of all surfaces; must outlive this
  /// @param blocks  blocks of the samples; must outlive this
  Extender(const SurfaceSamples& samples, const SampleBlocks& blocks,
           const AggregateOptions& options, const InlierTest& inlier);

  /// Adds to a surface all open samples on it within and near its extent, and refits it if they are
  /// many. Its evidence is not updated.
  /// @param free  samples that may be added
  Surface extended(Surface surface, const Mask& free) const;

 private:
  std::vector<int> further(const Surface& surface, const Mask& free) const;

  const SurfaceSamples& samples_;
  AggregateOptions options_;
  InlierTest inlier_;
  const SampleBlocks& blocks_;
};

}  // namespace quadrille
