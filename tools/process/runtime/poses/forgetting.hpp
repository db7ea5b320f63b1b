#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <lcmtypes/quadrille/forget_t.hpp>
#include <optional>
#include <string>

#include "poses/placement.hpp"
#include "process/runtime/node.hpp"
#include "quadrille/bus/rejection.hpp"

namespace quadrille {

/// A box of which everything is forgotten that was seen in it and through it.
struct ForgottenRegion {
  /// Pose of the box's frame R in the fixed frame.
  Eigen::Isometry3d X_WR = Eigen::Isometry3d::Identity();
  /// In R [m].
  Eigen::AlignedBox3d box_R;
};

/// Returns the region that a message names. It is nullopt if all is to be forgotten, be it that the
/// message says so or that the region cannot be placed yet and so might be anywhere.
/// @param placement  that of the last cloud; null before the first
/// @throws std::invalid_argument if the region's frame is not known
std::optional<ForgottenRegion> region_of(const forget_t& message, const Placement* placement,
                                         const std::string& cloud_frame);

/// Returns the job of a message. No newer job replaces it.
/// @param forget  forgets what a message names; throws std::invalid_argument if that cannot be told
/// @param reject  called with the reason if it was thrown
Job forgetting_job(const std::string& channel, const forget_t& message,
                   std::function<void(const forget_t&)> forget,
                   std::function<void(const bus::Rejection&)> reject);

/// Remembers when something was last forgotten.
class ForgottenTime {
 public:
  void set(std::int64_t utime) { utime_ = utime; }
  /// True if a cloud was taken before then, so that it may show what is no longer so.
  bool is_after(std::int64_t cloud_utime) const;

 private:
  std::optional<std::int64_t> utime_;
};

}  // namespace quadrille
