#include "surfaces/evidence/confidence.hpp"

#include <algorithm>
#include <cmath>

#include "detector/pipe.hpp"
#include "detector/surfaces/evidence/confidence_examples.hpp"
#include "fit/family_spec.hpp"
#include "support/catch.hpp"
#include "support/surface_grid.hpp"
#include "surfaces/evidence/confidence_weights.hpp"
#include "surfaces/evidence/intruders.hpp"
#include "surfaces/evidence/sample_blocks.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// What samples show of a cylinder along z.
ConfidenceTerms terms_of_cylinder(const SurfaceSamples& samples, const std::vector<int>& region,
                                  double radius) {
  const Quadric Q(diagonal(1, 1, 0, -radius * radius));
  Evidence e = collect_evidence(samples, region, Q);
  add_intruders(samples, SampleBlocks(samples), region, Q, &e);
  return confidence_terms(e, family_spec(Family::kCylinder).dof, 0.0);
}

double log_odds(double p) { return std::log(p / (1.0 - p)); }

}  // namespace

TEST_CASE("probabilities are those that numpy computes in training", "[confidence]") {
  for (const ConfidenceExample& example : kConfidenceExamples) {
    CAPTURE(example.terms);
    CHECK(confidence(example.terms, example.kind) == Approx(example.probability).margin(1e-4));
  }
}

TEST_CASE("beyond what the training showed, terms say no more", "[confidence]") {
  for (const ConfidenceExample& example : kConfidenceExamples) {
    for (std::size_t k = 0; k < kConfidenceTerms.size(); ++k) {
      CAPTURE(kConfidenceTerms[k]);
      ConfidenceTerms terms = example.terms;
      terms[k] = kTermRanges[k].max;
      const double at_the_end = confidence(terms, example.kind);
      terms[k] += 10.0;
      CHECK(confidence(terms, example.kind) == at_the_end);
    }
  }
}

TEST_CASE("the highest confidence is the highest over all values of a term", "[confidence]") {
  constexpr int kSteps = 1000;
  for (const ConfidenceExample& example : kConfidenceExamples) {
    for (std::size_t k = 0; k < kConfidenceTerms.size(); ++k) {
      CAPTURE(kConfidenceTerms[k]);
      ConfidenceTerms terms = example.terms;
      double highest = 0.0;
      for (int step = 0; step <= kSteps; ++step) {
        const double share = static_cast<double>(step) / kSteps;
        terms[k] = kTermRanges[k].min + share * (kTermRanges[k].max - kTermRanges[k].min);
        highest = std::max(highest, confidence(terms, example.kind));
      }
      const double bound = highest_confidence(example.terms, kConfidenceTerms[k], example.kind);
      CHECK(bound >= highest - 1e-12);
      CHECK(bound == Approx(highest).epsilon(1e-3));
    }
  }
}

TEST_CASE("a cylinder is believed, a wrong one and a scrap of one are not", "[confidence]") {
  const SurfaceSamples samples = pipe();
  const auto belief = [&](double radius, int from_row, int to_row) {
    std::vector<int> region;
    for (int i = from_row * kPipeColumns; i < to_row * kPipeColumns; ++i) region.push_back(i);
    return confidence(terms_of_cylinder(samples, region, radius), SurfaceKind::kCurved);
  };
  const double whole = belief(kPipeRadius, 0, kPipeRows);
  CHECK(whole > 0.9);
  CHECK(whole < 1.0);
  CHECK(belief(1.3 * kPipeRadius, 0, kPipeRows) < 0.5 * whole);
  // Cut out of the middle: the surface goes on at both ends. Its odds are a hundred times less.
  const double scrap = belief(kPipeRadius, kPipeRows / 2, kPipeRows / 2 + 2);
  CHECK(log_odds(scrap) < log_odds(whole) - std::log(100.0));
}
