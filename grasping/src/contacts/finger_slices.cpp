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

constexpr float kInfinity = std::numeric_limits<float>::infinity();

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
  place_ = along(R.col(0), own_);
  const double low = place_.minCoeff(), high = place_.maxCoeff();
  if (!(low <= high)) return slices_;
  const int steps = static_cast<int>((high - low) / step_) + 1;
  const double first = 0.5 * (low + high) - 0.5 * step_ * (steps - 1);
  find_windows(R, first, static_cast<std::size_t>(steps));
  fill_slices(R, first, static_cast<std::size_t>(steps));
  for (std::size_t n = 0; n < windows_.size(); ++n) {
    if (members_[n].empty()) continue;
    slices_.push_back({first + static_cast<int>(n) * step_, windows_[n].top, members_[n]});
  }
  return slices_;
}

/// Sorts the points along a closing direction. One whole number as a key is sorted three times
/// faster than a pair of a length and an index.
void FingerSlices::sort_along(const Eigen::Vector3d& closing) {
  closing_ = closing;
  own_y_ = along(closing, own_);
  const double low = own_y_.minCoeff(), high = own_y_.maxCoeff();
  place_ = along(closing, points_);
  keys_.clear();
  for (Eigen::Index i = 0; i < place_.size(); ++i) {
    const double y = place_[i];
    if (!(y > low - reach_ && y < high + reach_ && std::abs(y) < kFarthest)) continue;
    keys_.push_back(std::llround(y / kUnit) * kIndices + i);
  }
  std::sort(keys_.begin(), keys_.end());
  const std::size_t count = keys_.size();
  sorted_.resize(static_cast<Eigen::Index>(count), 3);
  y_.resize(count), index_.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Index i = keys_[k] & (kIndices - 1);
    sorted_.row(static_cast<Eigen::Index>(k)) = points_.row(i);
    y_[k] = static_cast<float>(place_[i]);
    index_[k] = static_cast<std::uint32_t>(i);
  }
}

/// Calls visit(n) for the slices of a place in steps, at most two of them: fingers cover two steps,
/// so each point is between them at two places.
template <class Visit>
void each_slice_at(double place, std::size_t steps, Visit&& visit) {
  if (!(place >= -1.0 && place < static_cast<double>(steps))) return;
  const auto after = static_cast<std::size_t>(place + 1.0);
  if (after > 0) visit(after - 1);
  if (after < steps) visit(after);
}

void FingerSlices::find_windows(const Eigen::Matrix3d& R, double first, std::size_t steps) {
  windows_.assign(steps, {kInfinity, kInfinity, -kInfinity});
  place_ = (place_ - first) / step_;
  z_ = along(R.col(2), own_);
  for (Eigen::Index i = 0; i < own_.rows(); ++i) {
    const auto y = static_cast<float>(own_y_[i]), z = static_cast<float>(z_[i]);
    each_slice_at(place_[i], steps, [&](std::size_t n) {
      Window& window = windows_[n];
      window.top = std::min(window.top, z);
      window.low = std::min(window.low, y);
      window.high = std::max(window.high, y);
    });
  }
}

void FingerSlices::fill_slices(const Eigen::Matrix3d& R, double first, std::size_t steps) {
  if (members_.size() < steps) members_.resize(steps);
  for (std::vector<InSlice>& slice : members_) slice.clear();
  const auto beyond = static_cast<float>(reach_ + kRoundingSlack);
  place_ = (along(R.col(0), sorted_) - first) / step_;
  z_ = along(R.col(2), sorted_);
  for (Eigen::Index k = 0; k < sorted_.rows(); ++k) {
    const InSlice point{y_[k], static_cast<float>(z_[k]), index_[k]};
    each_slice_at(place_[k], steps, [&](std::size_t n) {
      const Window& window = windows_[n];
      const bool near = point.y >= window.low - beyond && point.y <= window.high + beyond;
      const bool level =
          point.z < window.top + heights_.below && point.z > window.top - heights_.above;
      if (near && level) members_[n].push_back(point);
    });
  }
}

}  // namespace quadrille
