#include "contacts/success.hpp"

#include <algorithm>
#include <cmath>

#include "contacts/score_calibration.hpp"
#include "contacts/success_weights.hpp"

namespace quadrille {

double success_probability(const GraspTerms& terms) {
  double log_odds = kSuccessBias;
  std::size_t n = 0;
  GraspTerms::visit(terms, [&](const char*, double term) {
    // A term that is NaN counts as the worst.
    log_odds += kSuccessWeights[n++] * (term > 0.0 ? std::min(term, 1.0) : 0.0);
  });
  return 1.0 / (1.0 + std::exp(-kCalibrationSlope * log_odds - kCalibrationOffset));
}

}  // namespace quadrille
