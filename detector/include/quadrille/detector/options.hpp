#pragma once

#include <cstdint>
#include <vector>

#include "quadrille/detector/quadric_type.hpp"
#include "quadrille/detector/stage_options.hpp"

namespace quadrille {

/// All settings of the detector, stage by stage.
struct DetectorOptions {
  /// Chooses the random stream.
  std::uint64_t seed = 1;
  /// Threads to use; never changes the result.
  int threads = 1;
  /// Report only these types; empty means all. The sphere alone takes the paper's type-specific
  /// path, which sets search, families and the density of the points itself.
  std::vector<QuadricType> only;

  SamplingOptions sampling;
  PlaneOptions planes;
  /// When a sample lies on a quadric, for search and aggregation.
  InlierTest inlier;
  SearchOptions search;
  AgglomerateOptions agglomerate;
  AggregateOptions aggregate;

  /// @throws std::invalid_argument naming the field that is out of range
  void check() const;
};

/// Calls visit(name, field) for each scalar setting, in the order of the configuration file.
/// A name is the dotted TOML key, such as "planes.sigmas"; a field is double, int, bool,
/// std::uint64_t, BasisKind or Quantisation. Lists (only, radii, families) are left out.
template <class Options, class Visitor>
void visit_options(Options& o, Visitor&& visit) {
  visit("seed", o.seed);
  visit("threads", o.threads);
  visit("sampling.cell", o.sampling.cell);
  visit("sampling.noisiest_cell", o.sampling.noisiest_cell);
  visit("sampling.stride", o.sampling.stride);
  visit("sampling.noise.radius", o.sampling.noise.radius);
  visit("sampling.noise.quantile", o.sampling.noise.quantile);
  visit("sampling.noise.patches", o.sampling.noise.patches);
  visit("planes.least_samples", o.planes.least_samples);
  visit("planes.sigmas", o.planes.sigmas);
  visit("planes.angle", o.planes.angle);
  visit("planes.least_radius", o.planes.least_radius);
  visit("planes.least_proven_radius", o.planes.least_proven_radius);
  visit("inlier.sigmas", o.inlier.sigmas);
  visit("inlier.cells", o.inlier.cells);
  visit("inlier.least_cosine", o.inlier.least_cosine);
  visit("search.basis", o.search.basis);
  visit("search.quantisation", o.search.quantisation);
  visit("search.bases", o.search.bases);
  visit("search.voters", o.search.voters);
  visit("search.hash_triplets", o.search.hash_triplets);
  visit("search.least_support", o.search.least_support);
  visit("search.grow.least_samples", o.search.grow.least_samples);
  visit("search.grow.rounds", o.search.grow.rounds);
  visit("search.grow.fit_points", o.search.grow.fit_points);
  visit("agglomerate.enabled", o.agglomerate.enabled);
  visit("agglomerate.largest_difference", o.agglomerate.largest_difference);
  visit("agglomerate.largest_close", o.agglomerate.largest_close);
  visit("agglomerate.largest_far", o.agglomerate.largest_far);
  visit("aggregate.least_open", o.aggregate.least_open);
  visit("aggregate.least_samples", o.aggregate.least_samples);
  visit("aggregate.least_plane_samples", o.aggregate.least_plane_samples);
  visit("aggregate.least_confidence", o.aggregate.least_confidence);
  visit("aggregate.least_confidence_early", o.aggregate.least_confidence_early);
  visit("aggregate.largest_residual_early", o.aggregate.largest_residual_early);
  visit("aggregate.largest_residual", o.aggregate.largest_residual);
  visit("aggregate.least_spread", o.aggregate.least_spread);
  visit("aggregate.largest_residual_plane", o.aggregate.largest_residual_plane);
  visit("aggregate.fit_points", o.aggregate.fit_points);
  visit("aggregate.effective_share", o.aggregate.effective_share);
  visit("aggregate.effective_size", o.aggregate.effective_size);
  visit("aggregate.claim", o.aggregate.claim);
}

}  // namespace quadrille
