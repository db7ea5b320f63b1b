#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "boxes/face.hpp"

namespace quadrille {

/// A point beside a face: its distance from the end of a row, along the row, its height over the
/// face [m], and whether it shows that the face ends there.
struct Beside {
  double distance = 0.0, height = 0.0;
  bool shows_end = false;
};

/// A line of points that runs towards an edge.
struct Row {
  double end = -std::numeric_limits<double>::infinity();
  Eigen::Vector3d last_C = Eigen::Vector3d::Zero();
  /// The points that were seen beyond the end.
  std::vector<Beside> beside;
  /// True if these points show that the face ends there.
  bool seen = false;

  bool empty() const { return !std::isfinite(end); }
};

/// Rows of points side by side, which run towards an edge.
class Rows {
 public:
  Rows(const Face& face, const Eigen::Vector3d& out_C, double width)
      : out_C_(out_C), across_C_(face.n_C.cross(out_C)), width_(width) {
    const auto [low, high] = face.reach(across_C_);
    low_ = low;
    rows_.resize(1 + static_cast<std::size_t>(std::max(0.0, (high - low) / width)));
    for (const Eigen::Vector3d& p : face.points_C) {
      if (Row* row = at(p)) {
        const double end = out_C_.dot(p);
        if (end > row->end) {
          row->end = end;
          row->last_C = p;
        }
      }
    }
  }

  /// The row that contains a place in the plane; nullptr outside all rows.
  Row* at(const Eigen::Vector3d& on_C) {
    const double place = (across_C_.dot(on_C) - low_) / width_;
    if (!(place >= 0.0 && place < static_cast<double>(rows_.size()))) return nullptr;
    return &rows_[static_cast<std::size_t>(place)];
  }
  std::vector<Row>& all() { return rows_; }
  const std::vector<Row>& all() const { return rows_; }

 private:
  Eigen::Vector3d out_C_, across_C_;
  double width_, low_ = 0.0;
  std::vector<Row> rows_;
};

}  // namespace quadrille
