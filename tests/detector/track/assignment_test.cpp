#include "track/assignment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "base/random.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

double sum_of(const Eigen::MatrixXd& cost, const std::vector<int>& columns, double alone) {
  double sum = 0.0;
  for (std::size_t row = 0; row < columns.size(); ++row) {
    sum += columns[row] < 0 ? alone : cost(static_cast<Eigen::Index>(row), columns[row]);
  }
  return sum;
}

/// The least sum over all assignments, by trying them.
double min_sum(const Eigen::MatrixXd& cost, double alone) {
  const int rows = static_cast<int>(cost.rows()), columns = static_cast<int>(cost.cols());
  std::vector<int> order(static_cast<std::size_t>(columns + rows));
  std::iota(order.begin(), order.end(), 0);
  double least = std::numeric_limits<double>::infinity();
  do {
    std::vector<int> chosen(order.begin(), order.begin() + rows);
    for (int& column : chosen) column = column < columns ? column : -1;
    least = std::min(least, sum_of(cost, chosen, alone));
  } while (std::next_permutation(order.begin(), order.end()));
  return least;
}

TEST_CASE("the sum is least, not each pair", "[assign]") {
  Eigen::MatrixXd cost(2, 2);
  cost << 1.0, 2.0, 1.5, 9.0;
  CHECK(assign(cost, 10.0) == std::vector<int>{1, 0});
}

TEST_CASE("no pair is made that costs as much as staying alone", "[assign]") {
  Eigen::MatrixXd cost(2, 2);
  cost << 1.0, 5.0, 4.0, std::numeric_limits<double>::infinity();
  CHECK(assign(cost, 4.0) == std::vector<int>{0, -1});
  cost(0, 0) = std::nan("");
  CHECK(assign(cost, 4.0) == std::vector<int>{-1, -1});
}

TEST_CASE("there may be rows or columns only, or none", "[assign]") {
  CHECK(assign(Eigen::MatrixXd(0, 3), 1.0).empty());
  CHECK(assign(Eigen::MatrixXd(2, 0), 1.0) == std::vector<int>{-1, -1});
  CHECK_THROWS_AS(assign(Eigen::MatrixXd(1, 1), 0.0), std::invalid_argument);
}

TEST_CASE("no assignment of random costs is cheaper", "[assign]") {
  RandomStream random(1, 0);
  for (int trial = 0; trial < 60; ++trial) {
    Eigen::MatrixXd cost(1 + trial % 3, 1 + trial % 4);
    for (double& c : cost.reshaped()) c = 10.0 * random.uniform();
    const std::vector<int> columns = assign(cost, 6.0);
    std::vector<int> used = columns;
    std::erase(used, -1);
    std::sort(used.begin(), used.end());
    CHECK(std::adjacent_find(used.begin(), used.end()) == used.end());
    CHECK(sum_of(cost, columns, 6.0) == Approx(min_sum(cost, 6.0)));
  }
}

}  // namespace
}  // namespace quadrille
