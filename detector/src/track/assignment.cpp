#include "track/assignment.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace quadrille {
namespace {

/// State of the method: potentials, and the row of each column. Rows and columns count from 1;
/// index 0 means none.
class Matching {
 public:
  Matching(const Eigen::MatrixXd& cost, double alone)
      : cost_(cost),
        alone_(alone),
        rows_(static_cast<int>(cost.rows())),
        columns_(static_cast<int>(cost.cols()) + rows_),
        u_(static_cast<std::size_t>(rows_) + 1, 0.0),
        v_(static_cast<std::size_t>(columns_) + 1, 0.0),
        row_of_(static_cast<std::size_t>(columns_) + 1, 0) {
    for (int row = 1; row <= rows_; ++row) add(row);
  }

  std::vector<int> columns() const {
    std::vector<int> result(static_cast<std::size_t>(rows_), -1);
    for (int column = 1; column <= static_cast<int>(cost_.cols()); ++column) {
      if (row_of_[column] == 0) continue;
      const int row = row_of_[column] - 1;
      if (cost_(row, column - 1) < alone_) result[row] = column - 1;
    }
    return result;
  }

 private:
  /// Cost of a pair. Beyond the true columns, each row has a column of its own in which it stays
  /// alone.
  double cost(int row, int column) const {
    const int own = column - static_cast<int>(cost_.cols());
    if (own > 0) return own == row ? alone_ : forbidden();
    const double c = cost_(row - 1, column - 1);
    return c < alone_ ? c : forbidden();
  }
  /// Cost of a forbidden pair: more than if all rows stay alone, and so never part of the least
  /// sum.
  double forbidden() const { return (rows_ + 1) * alone_; }

  /// Matches one more row along the shortest augmenting path.
  void add(int row) {
    std::vector<double> min_cost(v_.size(), std::numeric_limits<double>::infinity());
    std::vector<int> from(v_.size(), 0);
    std::vector<char> done(v_.size(), 0);
    row_of_[0] = row;
    int column = 0;
    do {
      done[column] = 1;
      column = extend(column, done, &min_cost, &from);
    } while (row_of_[column] != 0);
    while (column != 0) {
      row_of_[column] = row_of_[from[column]];
      column = from[column];
    }
  }

  /// Grows the tree of shortest paths by one column, and returns that column.
  int extend(int column, const std::vector<char>& done, std::vector<double>* min_cost,
             std::vector<int>* from) {
    const int row = row_of_[column];
    int next = 0;
    double delta = std::numeric_limits<double>::infinity();
    for (int j = 1; j <= columns_; ++j) {
      if (done[j]) continue;
      const double reduced = cost(row, j) - u_[row] - v_[j];
      if (reduced < (*min_cost)[j]) {
        (*min_cost)[j] = reduced;
        (*from)[j] = column;
      }
      if ((*min_cost)[j] < delta) {
        delta = (*min_cost)[j];
        next = j;
      }
    }
    for (int j = 0; j <= columns_; ++j) {
      if (done[j]) {
        u_[row_of_[j]] += delta;
        v_[j] -= delta;
      } else {
        (*min_cost)[j] -= delta;
      }
    }
    return next;
  }

  const Eigen::MatrixXd& cost_;
  const double alone_;
  const int rows_, columns_;
  std::vector<double> u_, v_;
  std::vector<int> row_of_;
};

}  // namespace

std::vector<int> assign(const Eigen::MatrixXd& cost, double alone) {
  if (!(alone > 0.0) || !std::isfinite(alone)) {
    throw std::invalid_argument("alone: must be positive and finite");
  }
  return Matching(cost, alone).columns();
}

}  // namespace quadrille
