#include "contacts/success.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "contacts/success_weights.hpp"
#include "support/catch.hpp"

using namespace quadrille;

namespace {

GraspTerms all(double value) {
  GraspTerms terms;
  GraspTerms::visit(terms, [&](const char*, double& term) { term = value; });
  return terms;
}

}  // namespace

TEST_CASE("the probability of success is the logistic function of the weighted terms",
          "[grasp][success]") {
  double log_odds = kSuccessBias;
  for (const double weight : kSuccessWeights) log_odds += 0.5 * weight;
  CHECK(success_probability(all(0.5)) == Approx(1.0 / (1.0 + std::exp(-log_odds))));
}

TEST_CASE("each term but the distance makes a grasp more likely to succeed", "[grasp][success]") {
  const double middle = success_probability(all(0.5));
  std::size_t count = 0;
  GraspTerms better = all(0.5);
  GraspTerms::visit(better, [&](const std::string& name, double& term) {
    term = 0.9;
    CHECK((success_probability(better) > middle) == (name != "range"));
    term = 0.5;
    ++count;
  });
  CHECK(count == kSuccessWeights.size());
}

TEST_CASE("terms out of range count as the nearest in range, and NaN as the worst",
          "[grasp][success]") {
  CHECK(success_probability(all(7.0)) == success_probability(all(1.0)));
  CHECK(success_probability(all(-7.0)) == success_probability(all(0.0)));
  GraspTerms terms = all(0.5);
  terms.friction = std::numeric_limits<double>::quiet_NaN();
  GraspTerms zero = all(0.5);
  zero.friction = 0.0;
  CHECK(success_probability(terms) == success_probability(zero));
}
