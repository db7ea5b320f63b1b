#include "quadrille/detector/options.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace quadrille {
namespace {

template <class Number>
void require_within(const char* field, Number value, Number low, Number high) {
  if (value >= low && value <= high) return;
  std::ostringstream message;
  message << field << " = " << value << ": must lie between " << low << " and " << high;
  throw std::invalid_argument(message.str());
}

}  // namespace

void DetectorOptions::check() const {
  require_within("threads", threads, 1, 256);
  require_within("sampling.cell", sampling.cell, 1e-5, 10.0);
  require_within("sampling.noisiest_cell", sampling.noisiest_cell, 0.01, 100.0);
  require_within("sampling.stride", sampling.stride, 1, 100);
  require_within("sampling.noise.radius", sampling.noise.radius, 1e-4, 10.0);
  require_within("sampling.noise.quantile", sampling.noise.quantile, 0.0, 1.0);
  require_within("sampling.noise.patches", sampling.noise.patches, 1, 1000000);
  require_within("planes.min_samples", planes.min_samples, 4, 1000000);
  require_within("planes.sigmas", planes.sigmas, 0.1, 100.0);
  require_within("planes.angle", planes.angle, 0.01, M_PI_2);
  require_within("planes.min_radius", planes.min_radius, 1e-6, 1e6);
  require_within("planes.min_proven_radius", planes.min_proven_radius, 1e-6, 1e6);
  require_within("inlier.sigmas", inlier.sigmas, 0.1, 100.0);
  require_within("inlier.cells", inlier.cells, 0.0, 10.0);
  require_within("inlier.min_cosine", inlier.min_cosine, -1.0, 1.0);
  if (search.radii.empty()) throw std::invalid_argument("search.radii: must not be empty");
  for (const double radius : search.radii) require_within("search.radii", radius, 0.5, 1000.0);
  if (!std::is_sorted(search.radii.begin(), search.radii.end())) {
    throw std::invalid_argument("search.radii: must ascend");
  }
  require_within("search.bases", search.bases, 1, 10000);
  require_within("search.voters", search.voters, 16, 100000);
  require_within("search.min_support", search.min_support, 0.0, 1.0);
  require_within("search.grow.min_samples", search.grow.min_samples, 9, 1000000);
  require_within("search.grow.rounds", search.grow.rounds, 1, 1000);
  require_within("search.grow.fit_points", search.grow.fit_points, 16, 1000000);
  require_within("agglomerate.max_difference", agglomerate.max_difference, 0.0, 10.0);
  require_within("agglomerate.max_close", agglomerate.max_close, 0.0, 1000.0);
  require_within("agglomerate.max_far", agglomerate.max_far, 0.0, 1.0);
  require_within("aggregate.min_open", aggregate.min_open, 0.0, 1.0);
  require_within("aggregate.min_samples", aggregate.min_samples, 9, 1000000);
  require_within("aggregate.min_plane_samples", aggregate.min_plane_samples, 9, 1000000);
  require_within("aggregate.min_confidence", aggregate.min_confidence, 0.0, 1.0);
  require_within("aggregate.min_confidence_early", aggregate.min_confidence_early, 0.0, 1.0);
  require_within("aggregate.max_residual_early", aggregate.max_residual_early, 0.0, 100.0);
  require_within("aggregate.max_residual", aggregate.max_residual, 0.0, 1000.0);
  require_within("aggregate.min_spread", aggregate.min_spread, 0.0, M_PI);
  require_within("aggregate.max_residual_plane", aggregate.max_residual_plane, 0.0, 100.0);
  require_within("aggregate.fit_points", aggregate.fit_points, 16, 1000000);
  require_within("aggregate.effective_share", aggregate.effective_share, 1e-4, 1.0);
  require_within("aggregate.effective_size", aggregate.effective_size, 10.0, 1e9);
  require_within("aggregate.claim", aggregate.claim, 0.1, 100.0);
}

}  // namespace quadrille
