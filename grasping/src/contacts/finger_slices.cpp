#include "contacts/finger_slices.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "quadrille/detector/vector_clones.hpp"

namespace quadrille {
namespace {

// A key to sort by holds a length in units of kUnit [m] and the index of a point below kIndices.
// Points farther from the target than kFarthest [m] are of no interest.
constexpr double kUnit = 1e-8, kFarthest = 100.0;
constexpr int kIndexBits = 26;
constexpr std::int64_t kIndices = std::int64_t{1} << kIndexBits;
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
  find_own_ranges(R, first, steps);
  fill(R, first);
  for (std::size_t n = 0; n < ranges_.size(); ++n) {
    const std::span<const InSlice> points = within_reach(n);
    if (points.empty()) continue;
    slices_.push_back({first + static_cast<int>(n) * step_, ranges_[n].top, points});
  }
  return slices_;
}

/// Sorts the points along a closing direction.
void FingerSlices::sort_along(const Eigen::Vector3d& closing) {
  closing_ = closing;
  places_ = along(closing, own_);
  own_y_ = places_.cast<float>();
  const double low = places_.minCoeff(), high = places_.maxCoeff();
  places_ = along(closing, points_);
  keys_.resize(static_cast<std::size_t>(places_.size()));
  // Unlike vectors, this does not check each access.
  std::int64_t* keys = keys_.data();
  for (Eigen::Index i = 0; i < places_.size(); ++i) {
    const double y = places_[i];
    if (!(y > low - reach_ && y < high + reach_ && std::abs(y) < kFarthest)) continue;
    *keys++ = std::llrint(y / kUnit) * kIndices + i;
  }
  keys_.resize(static_cast<std::size_t>(keys - keys_.data()));
  sort_keys();
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

/// Sorts the keys by their lengths, digit by digit, the last digit first. Keys of one length are in
/// the order of their indices from the start, and stay in it.
void FingerSlices::sort_keys() {
  if (keys_.empty()) return;
  constexpr int kDigitBits = 9;
  constexpr std::int64_t kDigits = 1 << kDigitBits;
  const auto [least, most] = std::minmax_element(keys_.begin(), keys_.end());
  const std::int64_t low = *least / kIndices * kIndices - kIndices, range = *most - low;
  sorted_keys_.resize(keys_.size());
  for (int shift = kIndexBits; range >> shift != 0; shift += kDigitBits) {
    const auto digit = [&](std::int64_t key) { return (key - low) >> shift & (kDigits - 1); };
    std::array<std::uint32_t, kDigits> numbers{};
    // Unlike vectors, these do not check each access.
    std::uint32_t* starts = numbers.data();
    std::int64_t* to = sorted_keys_.data();
    for (const std::int64_t key : keys_) ++starts[digit(key)];
    std::exclusive_scan(numbers.begin(), numbers.end(), numbers.begin(), 0u);
    for (const std::int64_t key : keys_) to[starts[digit(key)]++] = key;
    keys_.swap(sorted_keys_);
  }
}

/// Finds the strip of each point, and how far it lies along the approach. The strips are the parts
/// that two neighbouring slices share, and the halves of the outermost ones: slice n consists of
/// strips n + 1 and n + 2. Points before, beyond and outside of the window are in strip 0.
QUADRILLE_VECTOR_CLONES
void FingerSlices::find_strips(const Eigen::Matrix3d& R, const Points& points, double first,
                               int steps, const Window& window) {
  strips_.resize(points.rows()), z_.resize(points.rows());
  const double *x = points.col(0).data(), *y = points.col(1).data(), *z = points.col(2).data();
  const double ax = R(0, 0), ay = R(1, 0), az = R(2, 0), bx = R(0, 2), by = R(1, 2), bz = R(2, 2);
  const double step = step_, most = steps;
  const float low = window.low, high = window.high;
  const int beyond = steps + 2;
  int* __restrict strips = strips_.data();
  float* __restrict heights = z_.data();
  const auto count = static_cast<std::size_t>(points.rows());
  for (std::size_t i = 0; i < count; ++i) {
    double place = (x[i] * ax + y[i] * ay + z[i] * az - first) / step;
    // No point has a NaN; it would become -2.
    place = place > -2.0 ? place : -2.0;
    place = place < most ? place : most;
    // The shift makes all values positive, so that truncation rounds down.
    const auto height = static_cast<float>(x[i] * bx + y[i] * by + z[i] * bz);
    const int in_window = static_cast<int>(height > low) & static_cast<int>(height < high);
    const int strip = static_cast<int>(place + 2.0);
    strips[i] = strip * (in_window & static_cast<int>(strip < beyond));
    heights[i] = height;
  }
}

void FingerSlices::find_own_ranges(const Eigen::Matrix3d& R, double first, int steps) {
  find_strips(R, own_, first, steps, {});
  own_strips_.assign(static_cast<std::size_t>(steps) + 3, {});
  // Unlike vectors, these do not check each access.
  OwnRange* strips = own_strips_.data();
  for (Eigen::Index i = 0; i < own_.rows(); ++i) {
    strips[strips_[i]].join({z_[i], own_y_[i], own_y_[i]});
  }
  ranges_.clear();
  for (int n = 0; n < steps; ++n) {
    ranges_.push_back(strips[n + 1]);
    ranges_.back().join(strips[n + 2]);
  }
}

/// Returns the heights that matter in any slice.
FingerSlices::Window FingerSlices::window() const {
  Window all{std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};
  for (const OwnRange& own : ranges_) {
    if (own.low > own.high) continue;  // without own points
    all.low = std::min(all.low, own.top - heights_.above);
    all.high = std::max(all.high, own.top + heights_.below);
  }
  return all;
}

/// Fills the slices with the points near their own ones.
void FingerSlices::fill(const Eigen::Matrix3d& R, double first) {
  const int steps = static_cast<int>(ranges_.size());
  find_strips(R, sorted_, first, steps, window());
  // A slice holds no more points than its two strips do. The two outermost slices, before the first
  // and beyond the last one, are there so that each strip belongs to two; they stay empty.
  const std::size_t size = ranges_.size() + 2;
  counts_.assign(size + 1, 0);
  kept_.resize(static_cast<std::size_t>(strips_.size()));
  // Unlike vectors, these do not check each access.
  std::size_t* counts = counts_.data();
  std::uint32_t* kept = kept_.data();
  const int* strips = strips_.data();
  std::size_t number = 0;
  for (Eigen::Index k = 0; k < strips_.size(); ++k) {
    ++counts[strips[k]];
    kept[number] = static_cast<std::uint32_t>(k);
    number += strips[k] != 0;
  }
  limits_.assign(size, {});
  Limits* limits = limits_.data();
  std::size_t start = 0;
  for (std::size_t n = 0; n + 2 < size; ++n) {
    const OwnRange& own = ranges_[n];
    limits[n + 1] = {own.top - heights_.above, own.top + heights_.below, start, start};
    // One place more, since points are written before it is known whether they count.
    start += counts[n + 1] + counts[n + 2] + 1;
  }
  limits[0].first = limits[0].end = limits[size - 1].first = limits[size - 1].end = start;
  if (members_.size() <= start) members_.resize(start + 1);
  InSlice* members = members_.data();
  for (std::size_t m = 0; m < number; ++m) {
    const std::uint32_t k = kept[m];
    const InSlice point{y_.data()[k], z_.data()[k], index_.data()[k]};
    Limits* slices = limits + strips[k] - 1;
    for (Limits* slice : {slices, slices + 1}) {
      members[slice->end] = point;
      slice->end += static_cast<std::size_t>(point.z < slice->high_z) &
                    static_cast<std::size_t>(point.z > slice->low_z);
    }
  }
}

/// Returns the points of the n-th slice within reach of its own ones, which lie side by side.
std::span<const InSlice> FingerSlices::within_reach(std::size_t n) const {
  const auto beyond = static_cast<float>(reach_ + kRoundingSlack);
  const float low = ranges_[n].low - beyond, high = ranges_[n].high + beyond;
  const Limits& slice = limits_[n + 1];
  const auto begin = members_.begin() + static_cast<std::ptrdiff_t>(slice.first);
  const auto end = members_.begin() + static_cast<std::ptrdiff_t>(slice.end);
  const auto first =
      std::partition_point(begin, end, [&](const InSlice& point) { return point.y < low; });
  const auto last =
      std::partition_point(first, end, [&](const InSlice& point) { return point.y <= high; });
  return {first, last};
}

}  // namespace quadrille
