#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fit/model_selection.hpp"
#include "quadrille/detector/stage_options.hpp"
#include "samples/region.hpp"
#include "samples/sample_buckets.hpp"
#include "search/search.hpp"
#include "surfaces/smooth_parts.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// Chooses among overlapping candidates (paper, "Hypotheses aggregation"): the one that explains
/// most comes first, is refitted to all that it explains, connected or not, joined with earlier
/// ones that the same quadric explains, verified, and claims its samples.
class Aggregation {
 public:
  /// @param samples  on which regions and claims are counted; must outlive this
  Aggregation(const SurfaceSamples& samples, const AggregateOptions& options,
              const InlierTest& inlier);

  /// Takes over candidates, with regions in terms of the samples, and accepts what can be accepted.
  /// @param early  true while finer levels are still to come: only clear cases claim samples
  void offer(std::vector<Candidate> candidates, bool early);

  /// Per sample, nonzero if an accepted surface holds it.
  const std::vector<char>& claimed() const { return parts_.claimed(); }
  const std::vector<Surface>& surfaces() const { return surfaces_; }

 private:
  std::optional<Surface> accept(const Candidate& candidate, bool early);
  std::optional<Surface> fitted(std::vector<int> region) const;
  std::optional<Surface> as_plane(std::vector<int> region) const;
  Evidence evidence_of(std::span<const int> region, const Quadric& Q) const;
  bool stands_off(std::span<const int> region) const;
  void extend(Surface* surface) const;
  void join(Surface* surface);
  double bic_of(const Surface& surface, double effective_size) const;
  std::vector<int> further(const Surface& surface) const;

  const SurfaceSamples& samples_;
  AggregateOptions options_;
  InlierTest inlier_;
  SampleBuckets buckets_;
  SmoothParts parts_;
  std::vector<Candidate> pending_;
  std::vector<Surface> surfaces_;
};

}  // namespace quadrille
