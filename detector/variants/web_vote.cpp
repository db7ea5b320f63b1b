#include "variants/web_vote.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace quadrille {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Largest and least number of cells along each coordinate: a three-dimensional grid must fit in
// memory, and inner cells must remain.
constexpr int kMaxCells = 64, kMinCells = 4;
// Least pivot of the lines' normal equations per line. Parallel lines, such as those of voters in
// one plane with the basis, do not meet.
constexpr double kMinPivot = 1e-3;

using Cell = std::array<int, 3>;

/// Counts of lines that cross each cell of λ.
class LineCounts {
 public:
  explicit LineCounts(const VoteOptions& options)
      : cells_(std::clamp(options.bins / 3, kMinCells, kMaxCells)),
        count_(static_cast<std::size_t>(cells_ * cells_ * cells_), 0.0f) {
    edges_.push_back(-kInfinity);
    for (int k = 1; k < cells_; ++k) {
      edges_.push_back(
          options.quantisation.lambda_at(static_cast<float>(k) / static_cast<float>(cells_)));
    }
    edges_.push_back(kInfinity);
  }

  /// Walks along the line from cell to cell, from one end to the other.
  void add(const WebLine& line) {
    Cell cell;
    std::array<double, 3> leaves;
    for (int k = 0; k < 3; ++k) {
      cell[k] = first_cell(line, k);
      leaves[k] = exit(line, cell[k], k);
    }
    for (;;) {
      const auto axis = std::min_element(leaves.begin(), leaves.end()) - leaves.begin();
      if (leaves[axis] == kInfinity) return;
      cell[axis] += line.direction[axis] > 0 ? 1 : -1;
      leaves[axis] = exit(line, cell[axis], static_cast<int>(axis));
      if (is_inner(cell)) count_[index(cell)] += 1.0f;
    }
  }

  /// Smooths the counts with the kernel 1, 2, 1 along each coordinate.
  void smooth() {
    std::vector<float> before;
    for (const int step : {1, cells_, cells_ * cells_}) {
      before = count_;
      for (std::size_t i = step; i + step < count_.size(); ++i) {
        count_[i] = before[i - step] + 2.0f * before[i] + before[i + step];
      }
    }
  }

  /// Returns the inner cell with the highest count, and clears it and its neighbours; nullopt if
  /// all are empty.
  std::optional<Cell> take_highest() {
    std::optional<Cell> best;
    float max_count = 0.0f;
    for_inner({1, 1, 1}, {cells_ - 2, cells_ - 2, cells_ - 2}, [&](const Cell& cell) {
      if (count_[index(cell)] > max_count) max_count = count_[index(cell)], best = cell;
    });
    if (!best) return best;
    Cell low = *best, high = *best;
    for (int k = 0; k < 3; ++k) low[k] = std::max(1, low[k] - 2);
    for (int k = 0; k < 3; ++k) high[k] = std::min(cells_ - 2, high[k] + 2);
    for_inner(low, high, [&](const Cell& cell) { count_[index(cell)] = 0.0f; });
    return best;
  }

  /// True if the line runs through the cell or one of its neighbours.
  bool passes(const WebLine& line, const Cell& cell) const {
    double from = -kInfinity, to = kInfinity;
    for (int k = 0; k < 3; ++k) {
      const double low = edges_[cell[k] - 1], high = edges_[cell[k] + 2];
      if (line.direction[k] == 0.0) {
        if (line.origin[k] < low || line.origin[k] > high) return false;
        continue;
      }
      const double a = (low - line.origin[k]) / line.direction[k];
      const double b = (high - line.origin[k]) / line.direction[k];
      from = std::max(from, std::min(a, b)), to = std::min(to, std::max(a, b));
    }
    return from <= to;
  }

 private:
  int first_cell(const WebLine& line, int axis) const {
    if (line.direction[axis] > 0.0) return 0;
    if (line.direction[axis] < 0.0) return cells_ - 1;
    const auto above = std::upper_bound(edges_.begin() + 1, edges_.end() - 1, line.origin[axis]);
    return static_cast<int>(above - edges_.begin()) - 1;
  }
  /// Parameter of the line at which it leaves a cell along an axis.
  double exit(const WebLine& line, int cell, int axis) const {
    const double d = line.direction[axis];
    if (d == 0.0) return kInfinity;
    const double edge = edges_[d > 0.0 ? cell + 1 : cell];
    return std::isfinite(edge) ? (edge - line.origin[axis]) / d : kInfinity;
  }
  bool is_inner(const Cell& cell) const {
    return std::all_of(cell.begin(), cell.end(), [&](int k) { return k > 0 && k < cells_ - 1; });
  }
  std::size_t index(const Cell& cell) const {
    const auto edge = static_cast<std::size_t>(cells_);
    const std::array at = {static_cast<std::size_t>(cell[0]), static_cast<std::size_t>(cell[1]),
                           static_cast<std::size_t>(cell[2])};
    return (at[2] * edge + at[1]) * edge + at[0];
  }
  template <class Visit>
  void for_inner(const Cell& low, const Cell& high, const Visit& visit) {
    for (int z = low[2]; z <= high[2]; ++z) {
      for (int y = low[1]; y <= high[1]; ++y) {
        for (int x = low[0]; x <= high[0]; ++x) visit(Cell{x, y, z});
      }
    }
  }

  int cells_;
  /// Bounds of the cells, from −∞ to ∞.
  std::vector<double> edges_;
  std::vector<float> count_;
};

/// The point nearest to all lines that pass through a cell or its neighbours.
std::optional<WebPeak> meeting_point(const std::vector<WebLine>& lines, const LineCounts& counts,
                                     const Cell& cell) {
  Eigen::Matrix3d across = Eigen::Matrix3d::Zero();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  WebPeak peak;
  for (const WebLine& line : lines) {
    if (!counts.passes(line, cell)) continue;
    const Eigen::Vector3d d = line.direction.normalized();
    const Eigen::Matrix3d projection = Eigen::Matrix3d::Identity() - d * d.transpose();
    across += projection;
    sum += projection * line.origin;
    ++peak.votes;
  }
  const Eigen::LDLT<Eigen::Matrix3d> ldlt(across);
  if (!(ldlt.vectorD().minCoeff() > kMinPivot * peak.votes)) return std::nullopt;
  peak.lambda = ldlt.solve(sum);
  return peak;
}

}  // namespace

std::vector<WebPeak> vote(const Web& web, const OrientedPointsf& voters,
                          const VoteOptions& options) {
  LineCounts counts(options);
  std::vector<WebLine> lines;
  for (Eigen::Index i = 0; i < voters.size(); ++i) {
    const std::optional<WebLine> line =
        line_of(web, voters.at(i), options.min_height, options.min_cosine);
    if (!line || !line->origin.allFinite()) continue;
    lines.push_back(*line);
    counts.add(*line);
  }
  counts.smooth();
  std::vector<WebPeak> peaks;
  for (int k = 0; k < options.peaks; ++k) {
    const std::optional<Cell> cell = counts.take_highest();
    if (!cell) break;
    if (const auto peak = meeting_point(lines, counts, *cell)) peaks.push_back(*peak);
  }
  std::stable_sort(peaks.begin(), peaks.end(),
                   [](const WebPeak& a, const WebPeak& b) { return a.votes > b.votes; });
  return peaks;
}

}  // namespace quadrille
