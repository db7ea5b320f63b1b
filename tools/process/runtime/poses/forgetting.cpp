#include "process/runtime/poses/forgetting.hpp"

#include <stdexcept>
#include <utility>

#include "poses/cloud_frame.hpp"
#include "poses/placement.hpp"
#include "poses/pose_history.hpp"
#include "process/runtime/logging.hpp"
#include "quadrille/bus/quadrics_message.hpp"

namespace quadrille {
namespace {

// A cloud is worked on no later than this after it was taken [s].
constexpr double kLongestDelay = 10.0;

}  // namespace

std::optional<ForgottenRegion> region_of(const forget_t& message, const Placement* placement,
                                         const std::string& cloud_frame) {
  if (message.all) return std::nullopt;
  Eigen::Isometry3d X_WF = Eigen::Isometry3d::Identity();
  if (message.frame != to_string(CloudFrame::kWorld)) {
    if (placement == nullptr) return std::nullopt;
    const Eigen::Isometry3d X_FK = pose_of_camera(message.frame, *placement, cloud_frame);
    if (!placement->X_WK) return std::nullopt;
    X_WF = *placement->X_WK * X_FK.inverse();
  }
  const Eigen::Vector3d half = 0.5 * Eigen::Vector3d(message.region_size);
  return ForgottenRegion{X_WF * bus::from_message(message.region), {-half, half}};
}

Job forgetting_job(const std::string& channel, const forget_t& message,
                   std::function<void(const forget_t&)> forget,
                   std::function<void(const bus::Rejection&)> reject) {
  const auto run = [message, forget = std::move(forget), reject = std::move(reject)] {
    try {
      forget(message);
    } catch (const std::invalid_argument& error) {
      reject({bus::RejectReason::kBadValue, error.what()});
    }
  };
  // A job that can be refused is not replaced by a newer one.
  const auto refuse = [channel](const std::string& why) { log_warning(channel + ": " + why); };
  return {message.utime, run, refuse};
}

bool ForgottenTime::is_after(std::int64_t cloud_utime) const {
  if (!utime_) return false;
  // If the cloud is much older, the clock was set back, and the cloud is new.
  const double before = seconds_between(cloud_utime, *utime_);
  return before >= 0.0 && before < kLongestDelay;
}

}  // namespace quadrille
