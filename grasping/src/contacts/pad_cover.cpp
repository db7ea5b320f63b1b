#include "contacts/pad_cover.hpp"

#include <algorithm>
#include <limits>

namespace quadrille {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

PadCover::PadCover(double x, double tip, const Gripper& gripper)
    : x_min_(x - 0.5 * gripper.finger.x()),
      z_min_(tip - 2.0 * gripper.finger_front),
      x_edge_(gripper.finger.x() / kAcross),
      z_edge_(2.0 * gripper.finger_front / kAlong) {
  low_.fill(kInfinity);
  high_.fill(-kInfinity);
}

double PadCover::filled() const {
  const auto count =
      std::count_if(low_.begin(), low_.end(), [](double y) { return y < kInfinity; });
  return static_cast<double>(count) / static_cast<double>(low_.size());
}

double PadCover::flat() const {
  const double low = *std::min_element(low_.begin(), low_.end());
  const double high = *std::max_element(high_.begin(), high_.end());
  const auto at_low =
      std::count_if(low_.begin(), low_.end(), [&](double y) { return y < low + kNearlyAsFar; });
  const auto at_high =
      std::count_if(high_.begin(), high_.end(), [&](double y) { return y > high - kNearlyAsFar; });
  return static_cast<double>(std::min(at_low, at_high)) / static_cast<double>(low_.size());
}

}  // namespace quadrille
