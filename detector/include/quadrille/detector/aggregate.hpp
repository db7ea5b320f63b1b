#pragma once

#include <optional>
#include <span>
#include <vector>

#include "quadrille/detector/model_selection.hpp"
#include "quadrille/detector/region.hpp"
#include "quadrille/detector/sample_buckets.hpp"
#include "quadrille/detector/search.hpp"
#include "quadrille/detector/smooth_parts.hpp"
#include "quadrille/detector/surface.hpp"

namespace quadrille {

/// When a surface is accepted, and how it is fitted.
struct AggregateOptions {
  /// Families that a surface's fit chooses from, beside the general one.
  std::vector<Family> families = {
      Family::kPlane,      Family::kSphere,     Family::kCylinder,         Family::kCone,
      Family::kRevolution, Family::kParaboloid, Family::kEllipticCylinder, Family::kParabolic};
  /// Share of a candidate's samples that no better one has claimed.
  double least_open = 0.5;
  /// Samples of a surface at least, and of a plane that was not found before.
  int least_samples = 30, least_plane_samples = 60;
  /// Least confidence of a curved surface; see evidence.hpp.
  double least_confidence = 0.45;
  /// Largest rms of a curved surface, in multiples of the noise: real objects are quadrics only
  /// nearly.
  double largest_residual = 100.0;
  /// Least spread of the normals of a curved surface [rad]: less is a plane, or anything.
  double least_spread = 0.4;
  /// Least confidence for candidates of the coarser levels, which claim their samples before the
  /// finer ones are searched, and their largest rms in multiples of the noise.
  double least_confidence_early = 0.8, largest_residual_early = 1.3;
  /// Largest rms of a plane that stands in for such a surface, in multiples of the noise.
  double largest_residual_plane = 2.0;
  /// Points that a fit uses at most.
  int fit_points = 240;
  /// Independent measurements at most, per sample and in all. Sensor noise comes in waves, and real
  /// objects are quadrics only nearly: more samples than this argue for no richer type.
  double effective_share = 0.0625, effective_size = 40.0;
  /// Factor on the distance within which an accepted quadric claims further samples.
  double claim = 1.3;
};

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
