#include "contacts/success.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "contacts/score_calibration.hpp"
#include "contacts/success_weights.hpp"
#include "grasping/scenes.hpp"
#include "quadrille/grasping/plan_options.hpp"
#include "support/catch.hpp"

using namespace quadrille;

namespace {

/// The log odds that the weights alone give.
double weighted_sum(const GraspTerms& terms) {
  double sum = kSuccessBias;
  std::size_t n = 0;
  GraspTerms::visit(terms, [&](const char*, double term) { sum += kSuccessWeights[n++] * term; });
  return sum;
}

GraspTerms all(double value) {
  GraspTerms terms;
  GraspTerms::visit(terms, [&](const char*, double& term) { term = value; });
  return terms;
}

/// The probability that the calibration makes of one that the weights alone give.
double calibrated(double weighted) {
  const double log_odds = std::log(weighted / (1.0 - weighted));
  return 1.0 / (1.0 + std::exp(-(kCalibrationSlope * log_odds + kCalibrationOffset)));
}

}  // namespace

TEST_CASE("the thresholds of scores belong to this calibration", "[grasp][success]") {
  // They were chosen as .5, .7 and .8 of the weights alone: the least score of a plan, and
  // kNearlySureScore and kSureScore of scene/view_chance.cpp.
  CHECK(calibrated(0.5) == Approx(0.61).margin(0.005));
  CHECK(calibrated(0.7) == Approx(0.82).margin(0.005));
  CHECK(calibrated(0.8) == Approx(0.9).margin(0.005));
  CHECK(PlanOptions{}.min_score == 0.61);
}

TEST_CASE("the log odds of success are a slope times the weighted terms plus an offset",
          "[grasp][success]") {
  for (const double value : {0.0, 0.25, 0.5, 1.0}) {
    const double p = success_probability(all(value));
    CHECK(std::log(p / (1.0 - p)) ==
          Approx(kCalibrationSlope * weighted_sum(all(value)) + kCalibrationOffset));
  }
}

TEST_CASE("the calibration keeps the order of grasps that the weights give", "[grasp][success]") {
  std::mt19937 random(1);
  for (int n = 0; n < 1000; ++n) {
    GraspTerms one, other;
    GraspTerms::visit(one,
                      [&](const char*, double& term) { term = test::uniform(random, 0.0, 1.0); });
    GraspTerms::visit(other,
                      [&](const char*, double& term) { term = test::uniform(random, 0.0, 1.0); });
    CHECK((success_probability(one) < success_probability(other)) ==
          (weighted_sum(one) < weighted_sum(other)));
  }
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
