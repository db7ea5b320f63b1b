#include "contacts/finger_slices.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>

#include "quadrille/detector/vector_clones.hpp"

namespace quadrille {
namespace {

// A key to sort by holds a length in units of kUnit [m] and the index of a point below kIndices.
// Points farther from the target than kFarthest [m] are of no interest.
constexpr double kUnit = 1e-8, kFarthest = 100.0;
constexpr int kIndexBits = 26;
constexpr std::int64_t kIndices = std::int64_t{1} << kIndexBits;
constexpr auto kMostUnits = static_cast<std::int64_t>(kFarthest / kUnit) + 1;
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
      own_(std::count_if(own.begin(), own.end(), [](char is_own) { return is_own != 0; }), 3),
      is_own_(own.begin(), own.end()) {
  for (Eigen::Index i = 0; i < points_.rows(); ++i) points_.row(i) = points[i].transpose();
  Eigen::Index n = 0;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i]) own_.row(n++) = points[i].transpose();
  }
  if (own_.rows() > 0) middle_ = own_.colwise().mean();
  squares_ = (points_.rowwise() - middle_.transpose()).rowwise().squaredNorm();
  own_squares_ = (own_.rowwise() - middle_.transpose()).rowwise().squaredNorm();
}

const std::vector<FingerSlice>& FingerSlices::cut(const Eigen::Matrix3d& R) {
  slices_.clear();
  if (own_.rows() == 0) return slices_;
  sorted_ = &sorted_along(R.col(1));
  places_ = along(R.col(0), own_);
  const double low = places_.minCoeff(), high = places_.maxCoeff();
  if (!(low <= high)) return slices_;
  const int steps = static_cast<int>((high - low) / step_) + 1;
  const double first = 0.5 * (low + high) - 0.5 * step_ * (steps - 1);
  find_strips(R, first, steps);
  find_own_ranges(steps);
  find_windows();
  fill();
  for (std::size_t n = 0; n < ranges_.size(); ++n) {
    const std::span<const std::uint32_t> points = within_reach(n);
    if (points.empty()) continue;
    slices_.push_back({first + static_cast<int>(n) * step_, ranges_[n].top, points});
  }
  return slices_;
}

SortedPoints FingerSlices::sorted() const {
  if (sorted_ == nullptr) return {};
  const auto is_last = [&](const Sorted& one) { return &one == sorted_; };
  const auto number = std::find_if(directions_.begin(), directions_.end(), is_last);
  const std::span index(sorted_->index.data(), static_cast<std::size_t>(sorted_->index.size()));
  return {sorted_->exact_y.data(), sorted_->y.data(), z_.data(), index,
          static_cast<std::size_t>(number - directions_.begin())};
}

/// Returns the points sorted along a closing direction.
const FingerSlices::Sorted& FingerSlices::sorted_along(const Eigen::Vector3d& closing) {
  const auto known = std::find_if(directions_.begin(), directions_.end(),
                                  [&](const Sorted& one) { return one.closing == closing; });
  if (known != directions_.end()) return *known;
  directions_.emplace_back();
  directions_.back().closing = closing;
  sort(directions_.back());
  return directions_.back();
}

/// Sorts the points along a closing direction. A point that shares a slice with an own one lies at
/// most a finger's width and one of the heights from the highest own point there, so that points
/// farther beside the own ones are left out, too.
void FingerSlices::sort(Sorted& sorted) {
  const Eigen::Vector3d& closing = sorted.closing;
  own_y_ = along(closing, own_);
  const double low = own_y_.minCoeff(), high = own_y_.maxCoeff();
  const double middle = closing.dot(middle_);
  const double beside =
      std::sqrt(std::max(0.0, (own_squares_ - (own_y_ - middle).square()).maxCoeff()));
  const double farthest =
      beside + std::hypot(2.0 * step_, std::max(heights_.above, heights_.below)) + kRoundingSlack;
  find_keys(closing, low - reach_, high + reach_, farthest * farthest);
  sort_keys();
  sorted.points.resize(key_count_, 3);
  sorted.exact_y.resize(key_count_), sorted.y.resize(key_count_), sorted.index.resize(key_count_);
  sorted.own_places.resize(own_.rows());
  const double *from_x = points_.col(0).data(), *from_y = points_.col(1).data(),
               *from_z = points_.col(2).data(), *places = places_.data();
  double *x = sorted.points.col(0).data(), *y = sorted.points.col(1).data(),
         *z = sorted.points.col(2).data(), *exact_y = sorted.exact_y.data();
  const char* is_own = is_own_.data();
  std::uint32_t* own_places = sorted.own_places.data();
  for (Eigen::Index k = 0; k < key_count_; ++k) {
    const std::int64_t i = keys_.data()[k] & (kIndices - 1);
    x[k] = from_x[i], y[k] = from_y[i], z[k] = from_z[i];
    exact_y[k] = places[i];
    sorted.y.data()[k] = static_cast<float>(places[i]);
    sorted.index.data()[k] = static_cast<std::uint32_t>(i);
    if (is_own[i] != 0) *own_places++ = static_cast<std::uint32_t>(k);
  }
  sorted.own_places.conservativeResize(own_places - sorted.own_places.data());
}

/// Finds how far the points lie along a closing direction, and the keys of those between two limits
/// that lie no farther beside the middle than allowed.
/// @param farthest  the square of that distance [m²]
QUADRILLE_VECTOR_CLONES
void FingerSlices::find_keys(const Eigen::Vector3d& closing, double low, double high,
                             double farthest) {
  // A double of this size has no digits behind the point, so that adding it rounds to the nearest
  // whole number as llrint() does, which the compiler does not do for several numbers at once.
  constexpr double kWhole = 0x1.8p52;
  constexpr std::int64_t kNone = -1;
  const Eigen::Index count = points_.rows();
  places_.resize(count), keys_.resize(count);
  const double *px = points_.col(0).data(), *py = points_.col(1).data(),
               *pz = points_.col(2).data(), *squares = squares_.data();
  const double dx = closing.x(), dy = closing.y(), dz = closing.z();
  const double middle = closing.dot(middle_);
  double* __restrict places = places_.data();
  std::int64_t* __restrict keys = keys_.data();
  for (Eigen::Index i = 0; i < count; ++i) {
    const double y = px[i] * dx + py[i] * dy + pz[i] * dz, off = y - middle;
    const bool near =
        (y > low) & (y < high) & (std::abs(y) < kFarthest) & (squares[i] - off * off < farthest);
    const auto units =
        std::bit_cast<std::int64_t>(y / kUnit + kWhole) - std::bit_cast<std::int64_t>(kWhole);
    places[i] = y;
    // All keys become positive, so that none equals kNone.
    keys[i] = near ? (units + kMostUnits) * kIndices + i : kNone;
  }
  key_count_ = std::remove(keys, keys + count, kNone) - keys;
}

/// Sorts the keys by their lengths, digit by digit, the last digit first. Keys of one length are in
/// the order of their indices from the start, and stay in it.
void FingerSlices::sort_keys() {
  if (key_count_ == 0) return;
  // The counts of so many digits take 2 KB, which stay in the L1 cache.
  constexpr int kDigitBits = 9;
  constexpr std::int64_t kDigits = 1 << kDigitBits;
  const auto [least, most] = std::minmax_element(keys_.data(), keys_.data() + key_count_);
  const std::int64_t low = *least / kIndices * kIndices, range = *most - low;
  sorted_keys_.resize(keys_.size());
  for (int shift = kIndexBits; range >> shift != 0; shift += kDigitBits) {
    const auto digit = [&](std::int64_t key) { return (key - low) >> shift & (kDigits - 1); };
    std::array<std::uint32_t, kDigits> numbers{};
    // Unlike vectors, these do not check each access.
    std::uint32_t* starts = numbers.data();
    const std::int64_t *from = keys_.data(), *end = from + key_count_;
    std::int64_t* to = sorted_keys_.data();
    for (const std::int64_t* key = from; key != end; ++key) ++starts[digit(*key)];
    std::exclusive_scan(numbers.begin(), numbers.end(), numbers.begin(), 0u);
    for (const std::int64_t* key = from; key != end; ++key) to[starts[digit(*key)]++] = *key;
    keys_.swap(sorted_keys_);
  }
}

/// Finds the strip of each sorted point, and how far it lies along the approach. The strips are the
/// parts that two neighbouring slices share, and the halves of the outermost ones: slice n consists
/// of strips n + 1 and n + 2. Points before and beyond all slices are in strip 0.
QUADRILLE_VECTOR_CLONES
void FingerSlices::find_strips(const Eigen::Matrix3d& R, double first, int steps) {
  const Points& points = sorted_->points;
  const Eigen::Index count = points.rows();
  strips_.resize(count), z_.resize(count);
  const double *x = points.col(0).data(), *y = points.col(1).data(), *z = points.col(2).data();
  const double ax = R(0, 0), ay = R(1, 0), az = R(2, 0), bx = R(0, 2), by = R(1, 2), bz = R(2, 2);
  const double step = step_, most = steps;
  const int beyond = steps + 2;
  int* __restrict strips = strips_.data();
  float* __restrict heights = z_.data();
  for (Eigen::Index i = 0; i < count; ++i) {
    double place = (x[i] * ax + y[i] * ay + z[i] * az - first) / step;
    // No point has a NaN; it would become -2.
    place = place > -2.0 ? place : -2.0;
    place = place < most ? place : most;
    // The shift makes all values positive, so that truncation rounds down.
    const int strip = static_cast<int>(place + 2.0);
    strips[i] = strip * static_cast<int>(strip < beyond);
    heights[i] = static_cast<float>(x[i] * bx + y[i] * by + z[i] * bz);
  }
}

void FingerSlices::find_own_ranges(int steps) {
  own_strips_.assign(static_cast<std::size_t>(steps) + 3, {});
  // Unlike vectors, these do not check each access.
  OwnRange* strips = own_strips_.data();
  const int* strip_of = strips_.data();
  const float *y = sorted_->y.data(), *z = z_.data();
  for (const std::uint32_t k : sorted_->own_places) strips[strip_of[k]].join({z[k], y[k], y[k]});
  ranges_.clear();
  for (int n = 0; n < steps; ++n) {
    ranges_.push_back(strips[n + 1]);
    ranges_.back().join(strips[n + 2]);
  }
}

/// Finds the heights that matter in each strip to the slices that share it.
void FingerSlices::find_windows() {
  windows_.assign(ranges_.size() + 3, {});
  for (std::size_t n = 0; n < ranges_.size(); ++n) {
    const OwnRange& own = ranges_[n];
    if (own.low > own.high) continue;  // without own points
    for (const std::size_t strip : {n + 1, n + 2}) {
      Window& window = windows_[strip];
      window.low = std::min(window.low, own.top - heights_.above);
      window.high = std::max(window.high, own.top + heights_.below);
    }
  }
}

/// Fills the slices with the points near their own ones.
void FingerSlices::fill() {
  // A slice holds no more points than its two strips do. The two outermost slices, before the first
  // and beyond the last one, are there so that each strip belongs to two; they stay empty.
  const std::size_t size = ranges_.size() + 2, all = static_cast<std::size_t>(strips_.size());
  counts_.assign(size + 1, 0);
  kept_.resize(strips_.size());
  // Unlike vectors, these do not check each access.
  std::size_t* counts = counts_.data();
  std::uint32_t* kept = kept_.data();
  const int* strips = strips_.data();
  const float* z = z_.data();
  const Window* windows = windows_.data();
  std::size_t number = 0;
  for (std::size_t k = 0; k < all; ++k) {
    const int strip = strips[k];
    const auto is_in = static_cast<std::size_t>(z[k] > windows[strip].low) &
                       static_cast<std::size_t>(z[k] < windows[strip].high);
    counts[strip] += is_in;
    kept[number] = static_cast<std::uint32_t>(k);
    number += is_in;
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
  std::uint32_t* members = members_.data();
  for (std::size_t m = 0; m < number; ++m) {
    const std::uint32_t k = kept[m];
    const float height = z[k];
    Limits* slices = limits + strips[k] - 1;
    for (Limits* slice : {slices, slices + 1}) {
      members[slice->end] = k;
      slice->end += static_cast<std::size_t>(height < slice->high_z) &
                    static_cast<std::size_t>(height > slice->low_z);
    }
  }
}

/// Returns the points of the n-th slice within reach of its own ones, which lie side by side.
std::span<const std::uint32_t> FingerSlices::within_reach(std::size_t n) const {
  const auto beyond = static_cast<float>(reach_ + kRoundingSlack);
  const float low = ranges_[n].low - beyond, high = ranges_[n].high + beyond;
  const Limits& slice = limits_[n + 1];
  // Unlike vectors, these do not check each access.
  const float* y = sorted_->y.data();
  const std::uint32_t *begin = members_.data() + slice.first, *end = members_.data() + slice.end;
  const auto* first = std::partition_point(begin, end, [&](std::uint32_t k) { return y[k] < low; });
  const auto* last =
      std::partition_point(first, end, [&](std::uint32_t k) { return y[k] <= high; });
  return {first, last};
}

}  // namespace quadrille
