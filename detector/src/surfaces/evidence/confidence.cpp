#include "surfaces/evidence/confidence.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "surfaces/evidence/confidence_weights.hpp"

namespace quadrille {
namespace {

// Added before the logarithm: a remainder or intruders well below this count as none.
constexpr double kNone = 0.05;
// Lower limit of arguments of logarithms, below which differences carry no information.
constexpr double kLeast = 1e-3;

double log_of(double x) { return std::log(std::max(kLeast, x)); }

}  // namespace

std::array<double, kConfidenceTerms.size()> confidence_terms(const Evidence& e, int dof,
                                                             double log_prior) {
  return {e.log_count,
          e.spread,
          e.smooth_border,
          e.open_border,
          e.depth_edge,
          e.interior,
          e.thickness,
          std::log(e.size),
          std::log(e.cell / e.size),
          e.two_planes,
          e.one_plane,
          std::log(e.sigma),
          e.common_noise,
          log_of(e.residual),
          log_of(e.roughness),
          e.correlation,
          e.convexity,
          std::log(kNone + e.in_front),
          std::log(kNone + e.behind),
          std::log(kNone + e.remainder),
          e.uprightness,
          e.see_through,
          static_cast<double>(dof),
          log_prior};
}

double confidence(const std::array<double, kConfidenceTerms.size()>& terms, SurfaceKind kind) {
  const ConfidenceModel& model = kind == SurfaceKind::kFlat ? kFlatModel : kCurvedModel;
  std::array<double, ConfidenceModel::kSize + 1> z{1.0};
  for (std::size_t k = 0; k < terms.size(); ++k) {
    const TermScale& scale = model.scales[k];
    z[k + 1] = (std::clamp(terms[k], scale.min, scale.max) - scale.mean) / scale.deviation;
  }
  double log_odds = 0.0;
  std::size_t next = 0;
  for (std::size_t i = 0; i < z.size(); ++i) {
    for (std::size_t j = i; j < z.size(); ++j) log_odds += model.form[next++] * z[i] * z[j];
  }
  return 1.0 / (1.0 + std::exp(-log_odds));
}

}  // namespace quadrille
