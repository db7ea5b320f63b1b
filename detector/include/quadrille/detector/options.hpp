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
  visit("planes.min_samples", o.planes.min_samples);
  visit("planes.sigmas", o.planes.sigmas);
  visit("planes.angle", o.planes.angle);
  visit("planes.min_radius", o.planes.min_radius);
  visit("planes.min_proven_radius", o.planes.min_proven_radius);
  visit("inlier.sigmas", o.inlier.sigmas);
  visit("inlier.cells", o.inlier.cells);
  visit("inlier.min_cosine", o.inlier.min_cosine);
  visit("search.basis", o.search.basis);
  visit("search.quantisation", o.search.quantisation);
  visit("search.bases", o.search.bases);
  visit("search.voters", o.search.voters);
  visit("search.hash_triplets", o.search.hash_triplets);
  visit("search.min_support", o.search.min_support);
  visit("search.grow.min_samples", o.search.grow.min_samples);
  visit("search.grow.rounds", o.search.grow.rounds);
  visit("search.grow.fit_points", o.search.grow.fit_points);
  visit("agglomerate.enabled", o.agglomerate.enabled);
  visit("agglomerate.max_difference", o.agglomerate.max_difference);
  visit("agglomerate.max_close", o.agglomerate.max_close);
  visit("agglomerate.max_far", o.agglomerate.max_far);
  visit("aggregate.min_open", o.aggregate.min_open);
  visit("aggregate.min_samples", o.aggregate.min_samples);
  visit("aggregate.min_plane_samples", o.aggregate.min_plane_samples);
  visit("aggregate.min_confidence", o.aggregate.min_confidence);
  visit("aggregate.min_confidence_early", o.aggregate.min_confidence_early);
  visit("aggregate.max_residual_early", o.aggregate.max_residual_early);
  visit("aggregate.max_residual", o.aggregate.max_residual);
  visit("aggregate.min_spread", o.aggregate.min_spread);
  visit("aggregate.max_residual_plane", o.aggregate.max_residual_plane);
  visit("aggregate.fit_points", o.aggregate.fit_points);
  visit("aggregate.effective_share", o.aggregate.effective_share);
  visit("aggregate.effective_size", o.aggregate.effective_size);
  visit("aggregate.claim", o.aggregate.claim);
}

}  // namespace quadrille
