#include "surfaces/evidence/confidence.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "surfaces/evidence/confidence_weights.hpp"

namespace quadrille {
namespace {

// Added before the logarithm: intruders well below this count as none.
constexpr double kNone = 0.05;
// Lower limit of arguments of logarithms, below which differences carry no information.
constexpr double kLeast = 1e-3;

double log_of(double x) { return std::log(std::max(kLeast, x)); }

double log_odds(const ConfidenceTerms& terms, SurfaceKind kind) {
  static_assert(kTermRanges.size() == kConfidenceTerms.size());
  // The last value is 1, by which a weight without a second term is multiplied.
  std::array<double, kConfidenceTerms.size() + 1> x{};
  x.back() = 1.0;
  for (std::size_t k = 0; k < terms.size(); ++k) {
    x[k] = std::clamp(terms[k], kTermRanges[k].min, kTermRanges[k].max);
  }
  std::span<const ConfidenceWeight> model = kCurvedModel;
  if (kind == SurfaceKind::kFlat) model = kFlatModel;
  double sum = 0.0;
  for (const ConfidenceWeight& w : model) sum += w.value * x[w.first] * x[w.second];
  return sum;
}

double logistic(double log_odds) { return 1.0 / (1.0 + std::exp(-log_odds)); }

}  // namespace

ConfidenceTerms confidence_terms(const Evidence& e, int dof, double log_prior) {
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
          std::log(kNone + e.meet_axis),
          std::log(kNone + e.miss_axis),
          static_cast<double>(dof),
          log_prior};
}

double confidence(const ConfidenceTerms& terms, SurfaceKind kind) {
  return logistic(log_odds(terms, kind));
}

double highest_confidence(ConfidenceTerms terms, std::string_view unknown, SurfaceKind kind) {
  const auto k = static_cast<std::size_t>(
      std::find(kConfidenceTerms.begin(), kConfidenceTerms.end(), unknown) -
      kConfidenceTerms.begin());
  const TermRange range = kTermRanges.at(k);
  const auto at = [&](double value) {
    terms[k] = value;
    return log_odds(terms, kind);
  };
  // The log odds are a parabola in each term, which lies highest at an end or at its vertex.
  const double low = at(range.min), high = at(range.max), rise = 0.5 * (high - low);
  const double middle = at(0.5 * (range.min + range.max)), bend = low + high - 2.0 * middle;
  double highest = std::max(low, high);
  if (bend < -std::abs(rise)) highest = middle - 0.5 * rise * rise / bend;
  return logistic(highest);
}

}  // namespace quadrille
