#include "surfaces/evidence/confidence.hpp"

#include <cmath>
#include <set>

#include "support/catch.hpp"

using namespace quadrille;

namespace {

Evidence example() {
  Evidence e;
  e.log_count = 3.0, e.spread = 1.0, e.smooth_border = 0.1, e.two_planes = 1.0;
  return e;
}

double log_odds(double p) { return std::log(p / (1.0 - p)); }

}  // namespace

TEST_CASE("the weights are named, each once, and in the order of the terms", "[confidence]") {
  std::set<std::string_view> names;
  for (const ConfidenceWeight& row : kConfidenceWeights) {
    CHECK(names.insert(row.term).second);
    CHECK_FALSE(row.unit.empty());
    CHECK_FALSE(row.meaning.empty());
  }
  Evidence e;
  e.log_count = 5.5, e.spread = 2.0, e.smooth_border = 3.0, e.open_border = 4.0;
  e.depth_edge = 5.0, e.thickness = 6.0, e.two_planes = 0.4, e.misfit = 2.0, e.remainder = 0.95;
  const auto terms = confidence_terms(e, 7);
  const auto value = [&](std::string_view name) {
    for (std::size_t k = 0; k < terms.size(); ++k) {
      if (kConfidenceWeights[k].term == name) return terms[k];
    }
    FAIL("no term " << name);
    return 0.0;
  };
  CHECK(value("one") == 1.0);
  CHECK(value("log_count") == 5.5);
  CHECK(value("spread") == 2.0);
  CHECK(value("smooth_border") == 3.0);
  CHECK(value("open_border") == 4.0);
  CHECK(value("depth_edge") == 5.0);
  CHECK(value("thickness") == 6.0);
  CHECK(value("two_planes") == 0.4);
  CHECK(value("box_edge") == Approx(0.5 * 0.4));
  CHECK(value("dof") == 7.0);
  CHECK(value("log_misfit") == Approx(std::log(2.0)));
  CHECK(value("log_remainder") == Approx(0.0).margin(1e-12));
}

TEST_CASE("the log odds are the prior and the weighted terms", "[confidence]") {
  const Evidence e = example();
  const auto terms = confidence_terms(e, 5);
  double sum = -1.5;
  for (std::size_t k = 0; k < terms.size(); ++k) sum += kConfidenceWeights[k].weight * terms[k];
  CHECK(log_odds(confidence(e, 5, -1.5)) == Approx(sum));
}

TEST_CASE("the prior shifts the log odds of the confidence", "[confidence]") {
  const Evidence e = example();
  CHECK(log_odds(confidence(e, 5, -2.0)) == Approx(log_odds(confidence(e, 5)) - 2.0));
}

TEST_CASE("many samples that two planes explain as well are a box edge, few may be anything",
          "[confidence]") {
  Evidence e;
  e.spread = 1.0;
  const auto gain = [&](double log_count) {
    e.log_count = log_count;
    e.two_planes = 0.1;
    const double edge = confidence(e, 5);
    e.two_planes = 1.0;
    const double round = confidence(e, 5);
    return log_odds(round) - log_odds(edge);
  };
  CHECK(gain(6.0) > gain(4.0) + 1.0);
}

TEST_CASE("confidence lies in (0, 1) and moves with each piece of evidence", "[confidence]") {
  const Evidence e = example();
  const double base = confidence(e, 5);
  CHECK(base > 0.0);
  CHECK(base < 1.0);
  const auto changed = [&](double Evidence::*field, double by) {
    Evidence other = e;
    other.*field += by;
    return confidence(other, 5);
  };
  CHECK(changed(&Evidence::log_count, 1.0) > base);
  CHECK(changed(&Evidence::smooth_border, 0.1) < base);
  CHECK(changed(&Evidence::open_border, 0.1) < base);
  CHECK(changed(&Evidence::depth_edge, 0.1) < base);
  CHECK(changed(&Evidence::thickness, 0.1) < base);
  CHECK(changed(&Evidence::two_planes, 1.0) > base);
  CHECK(changed(&Evidence::misfit, 0.5) < base);
  CHECK(changed(&Evidence::remainder, 0.5) < base);
  CHECK(confidence(e, 9) < base);
}
