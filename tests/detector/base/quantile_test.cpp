#include "base/quantile.hpp"

#include "support/catch.hpp"

using namespace quadrille;

TEST_CASE("quantiles are elements of what they are taken of", "[quantile]") {
  std::vector<float> values = {5, 1, 4, 2, 3};
  CHECK(nth_smallest(values, 0) == 1);
  CHECK(nth_smallest(values, 4) == 5);
  CHECK(quantile(values, 0.0) == 1);
  CHECK(quantile(values, 0.5) == 3);
  CHECK(quantile(values, 0.74) == 3);
  CHECK(quantile(values, 0.75) == 4);
  CHECK(quantile(values, 1.0) == 5);
  CHECK(median(values) == 3);
}

TEST_CASE("of an even number the quantile is the lower one in the middle, the median the upper",
          "[quantile]") {
  std::vector<double> values = {4, 1, 3, 2};
  CHECK(quantile(values, 0.5) == 2);
  CHECK(median(values) == 3);
  std::vector<double> one = {7};
  CHECK(quantile(one, 0.3) == 7);
  CHECK(median(one) == 7);
}

TEST_CASE("the deviation of normal noise survives outliers", "[quantile]") {
  // The quartiles of a standard normal distribution, and two outliers.
  std::vector<double> values = {-100.0, -0.6745, 0.6745, 0.6745, 100.0};
  CHECK(robust_std(values) == Approx(1.0).epsilon(1e-4));
}
