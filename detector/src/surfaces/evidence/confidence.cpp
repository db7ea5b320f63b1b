#include "surfaces/evidence/confidence.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille {
namespace {

// Beyond 400 samples a surface is as certain as its fit.
constexpr double kMaxLogCount = 6.0;
// Ratios beyond these say no more: the fit is worse than two planes, or exact.
constexpr double kMinTwoPlanes = -2.0, kMaxTwoPlanes = 5.0;
// What more than 150 samples explain hardly better than two planes do, by less than a factor of two
// in the residual, is a box edge; few may be anything.
constexpr double kEdgeLogCount = 5.0, kEdgeTwoPlanes = 0.8;
// Misfits in whose range the training had surfaces.
constexpr double kMinMisfit = 0.05, kMaxMisfit = 6.0;
// A remainder well below this is none.
constexpr double kNoRemainder = 0.05;

}  // namespace

std::array<double, kConfidenceWeights.size()> confidence_terms(const Evidence& e, int dof) {
  const double two_planes = std::clamp(e.two_planes, kMinTwoPlanes, kMaxTwoPlanes);
  const double box_edge =
      std::max(0.0, e.log_count - kEdgeLogCount) * std::max(0.0, kEdgeTwoPlanes - two_planes);
  return {1.0,
          std::min(e.log_count, kMaxLogCount),
          e.spread,
          e.smooth_border,
          e.open_border,
          e.depth_edge,
          e.thickness,
          two_planes,
          box_edge,
          static_cast<double>(dof),
          std::log(std::clamp(e.misfit, kMinMisfit, kMaxMisfit)),
          std::log(kNoRemainder + e.remainder)};
}

double confidence(const Evidence& evidence, int dof, double log_prior) {
  const auto terms = confidence_terms(evidence, dof);
  double log_odds = log_prior;
  for (std::size_t k = 0; k < terms.size(); ++k) {
    log_odds += kConfidenceWeights[k].weight * terms[k];
  }
  return 1.0 / (1.0 + std::exp(-log_odds));
}

}  // namespace quadrille
