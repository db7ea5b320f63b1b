#include "contacts/finger_slices.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille {
namespace {

// A key to sort by holds a length in units of kUnit [m] and the index of a point below kIndices.
// Points farther from the target than kFarthest [m] are of no interest.
constexpr double kUnit = 1e-8, kFarthest = 100.0;
constexpr std::int64_t kIndices = std::int64_t{1} << 26;
// Reserve for the rounding of floats, where points beyond a distance are left out [m].
constexpr double kRoundingSlack = 1e-4;

using Points = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// How far points lie along a direction.
auto along(const Eigen::Vector3d& d, const Points& points) {
  return points.col(0).array() * d.x() + points.col(1).array() * d.y() +
         points.col(2).array() * d.z();
}

}  // namespace

FingerSlices::FingerSlices(std::span<const Eigen::Vector3d> points, std::span<const char> own,
                           const Gripper& gripper, const SliceHeights& heights)
    : step_(0.5 * gripper.finger.x()),
      reach_(gripper.max_opening + gripper.finger.y()),
      heights_(heights),
      points_(std::min<Eigen::Index>(kIndices, std::ssize(points)), 3),
      own_(std::count_if(own.begin(), own.end(), [](char is_own) { return is_own != 0; }), 3) {
  for (Eigen::Index i = 0; i < points_.rows(); ++i) points_.row(i) = points[i].transpose();
  Eigen::Index n = 0;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i]) own_.row(n++) = points[i].transpose();
  }
}

const std::vector<FingerSlice>& FingerSlices::cut(const Eigen::Matrix3d& R) {
  slices_.clear();
  if (own_.rows() == 0) return slices_;
  if (R.col(1) != closing_) sort_along(R.col(1));
  places_ = along(R.col(0), own_);
  const double low = places_.minCoeff(), high = places_.maxCoeff();
  if (!(low <= high)) return slices_;
  const int steps = static_cast<int>((high - low) / step_) + 1;
  const double first = 0.5 * (low + high) - 0.5 * step_ * (steps - 1);
  const std::vector<OwnRange> ranges = own_ranges(R, first, steps);
  fill(R, first, ranges);
  for (std::size_t n = 0; n < ranges.size(); ++n) {
    if (members_[n].empty()) continue;
    slices_.push_back({first + static_cast<int>(n) * step_, ranges[n].top, members_[n]});
  }
  return slices_;
}

/// Sorts the points along a closing direction. One whole number as a key is sorted three times
/// faster than a pair of a length and an index.
void FingerSlices::sort_along(const Eigen::Vector3d& closing) {
  closing_ = closing;
  places_ = along(closing, own_);
  own_y_ = places_.cast<float>();
  const double low = places_.minCoeff(), high = places_.maxCoeff();
  places_ = along(closing, points_);
  keys_.clear();
  for (Eigen::Index i = 0; i < places_.size(); ++i) {
    const double y = places_[i];
    if (!(y > low - reach_ && y < high + reach_ && std::abs(y) < kFarthest)) continue;
    keys_.push_back(std::llrint(y / kUnit) * kIndices + i);
  }
  std::sort(keys_.begin(), keys_.end());
  const std::size_t count = keys_.size();
  sorted_.resize(static_cast<Eigen::Index>(count), 3);
  y_.resize(sorted_.rows()), index_.resize(sorted_.rows());
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Index i = keys_[k] & (kIndices - 1);
    sorted_.row(static_cast<Eigen::Index>(k)) = points_.row(i);
    y_[static_cast<Eigen::Index>(k)] = static_cast<float>(places_[i]);
    index_[static_cast<Eigen::Index>(k)] = static_cast<std::uint32_t>(i);
  }
}

/// Finds the strip of each point, and how far it lies along the approach. The strips are the parts
/// that two neighbouring slices share, and the halves of the outermost ones: slice n consists of
/// strips n + 1 and n + 2. Points before and beyond are in strips 0 and `steps` + 2.
void FingerSlices::find_strips(const Eigen::Matrix3d& R, const Points& points, double first,
                               int steps) {
  // The shift makes all values positive, so that truncation rounds down.
  places_ = ((along(R.col(0), points) - first) / step_).max(-2.0).min(steps) + 2.0;
  strips_ = places_.cast<int>();
  z_ = along(R.col(2), points).cast<float>();
}

std::vector<FingerSlices::OwnRange> FingerSlices::own_ranges(const Eigen::Matrix3d& R, double first,
                                                             int steps) {
  find_strips(R, own_, first, steps);
  std::vector<OwnRange> strips(static_cast<std::size_t>(steps) + 3);
  for (Eigen::Index i = 0; i < own_.rows(); ++i) {
    OwnRange& strip = strips[static_cast<std::size_t>(strips_[i])];
    strip.join({z_[i], own_y_[i], own_y_[i]});
  }
  std::vector<OwnRange> slices;
  for (int n = 0; n < steps; ++n) {
    slices.push_back(strips[static_cast<std::size_t>(n) + 1]);
    slices.back().join(strips[static_cast<std::size_t>(n) + 2]);
  }
  return slices;
}

/// Fills the slices with the points near their own ones.
void FingerSlices::fill(const Eigen::Matrix3d& R, double first,
                        const std::vector<OwnRange>& ranges) {
  const int steps = static_cast<int>(ranges.size());
  if (members_.size() < ranges.size()) members_.resize(ranges.size());
  for (std::vector<InSlice>& slice : members_) slice.clear();
  find_strips(R, sorted_, first, steps);
  const auto beyond = static_cast<float>(reach_ + kRoundingSlack);
  const auto add = [&](const InSlice& point, int n) {
    const OwnRange& own = *(ranges.data() + n);
    const bool near = point.z < own.top + heights_.below && point.z > own.top - heights_.above &&
                      point.y >= own.low - beyond && point.y <= own.high + beyond;
    if (near) members_[static_cast<std::size_t>(n)].push_back(point);
  };
  // Eigen's arrays are not checked at each access, as vectors are.
  for (Eigen::Index k = 0; k < strips_.size(); ++k) {
    const int strip = strips_[k];
    if (strip == 0 || strip == steps + 2) continue;
    const InSlice point{y_[k], z_[k], index_[k]};
    if (strip > 1) add(point, strip - 2);
    if (strip <= steps) add(point, strip - 1);
  }
}

}  // namespace quadrille
