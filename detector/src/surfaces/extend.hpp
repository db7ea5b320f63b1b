#pragma once

#include <vector>

#include "quadrille/detector/stage_options.hpp"
#include "samples/sample_buckets.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// Extends surfaces over open samples that lie on them, connected or not: the other side of an
/// occluder, the inside of a bowl.
class Extender {
 public:
  /// @param samples  of all surfaces; must outlive this
  /// @param buckets  of the samples; must outlive this
  Extender(const SurfaceSamples& samples, const SampleBuckets& buckets,
           const AggregateOptions& options, const InlierTest& inlier);

  /// The surface with all open samples within and near its extent that lie on it, refitted if they
  /// are many. Its evidence is left as it was.
  /// @param claimed  per sample, nonzero to leave it out
  Surface extended(Surface surface, const std::vector<char>& claimed) const;

 private:
  std::vector<int> further(const Surface& surface, const std::vector<char>& claimed) const;

  const SurfaceSamples& samples_;
  AggregateOptions options_;
  InlierTest inlier_;
  const SampleBuckets& buckets_;
};

}  // namespace quadrille
