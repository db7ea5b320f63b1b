#include "quadrille/detector/view_memory.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/quantile.hpp"
#include "quadrille/detector/detection.hpp"
#include "views/align.hpp"
#include "views/joined_samples.hpp"
#include "views/outdated.hpp"
#include "views/seen_view.hpp"

namespace quadrille {
namespace {

// Views of one direction are of different places if these lie farther apart than this share of
// their distance from the camera.
constexpr double kOtherPlace = 0.5;

/// Where a view looks from, and at what.
struct Outlook {
  Eigen::Vector3d eye_W, place_W;

  double distance() const { return (eye_W - place_W).norm(); }
};

/// The place is that of the median depth along the view's axis.
Outlook outlook_of(const Sight& sight, const Eigen::Isometry3d& X_WC) {
  std::vector<float> seen;
  for (const float w : sight.w) {
    if (w > 0.0f) seen.push_back(w);
  }
  const double depth = seen.empty() ? 1.0 : 1.0 / median(seen);
  const Eigen::Isometry3d X_WV = X_WC * sight.X_VC.inverse().cast<double>();
  return {X_WV.translation(), X_WV * Eigen::Vector3d(0.0, 0.0, depth)};
}

/// Angle between the directions from which two views see the place of the first [rad]; infinite if
/// they look at different places.
double angle_between(const Outlook& a, const Outlook& b) {
  if ((a.place_W - b.place_W).norm() > kOtherPlace * a.distance()) {
    return std::numeric_limits<double>::infinity();
  }
  const Eigen::Vector3d to_a = a.eye_W - a.place_W, to_b = b.eye_W - a.place_W;
  return std::atan2(to_a.cross(to_b).norm(), to_a.dot(to_b));
}

Sight moved(Sight sight, const Eigen::Isometry3d& X_FC) {
  sight.X_VC = sight.X_VC * X_FC.inverse().cast<float>();
  return sight;
}

}  // namespace

struct ViewMemory::Kept {
  std::int64_t utime = 0;
  /// In the frame C in which it came, so that it keeps its pixels to the last bit.
  PointCloud cloud;
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  /// What it saw, in C.
  Sight sight;
  /// In W.
  SurfaceSamples samples;
  /// That of the first view that was kept here, so that a slowly moving camera leaves views behind.
  Outlook outlook;
};

ViewMemory::ViewMemory(const DetectorOptions& options) : options_(options) { options_.check(); }
ViewMemory::~ViewMemory() = default;
ViewMemory::ViewMemory(ViewMemory&&) noexcept = default;
ViewMemory& ViewMemory::operator=(ViewMemory&&) noexcept = default;

std::size_t ViewMemory::size() const { return kept_.size(); }

void ViewMemory::forget() { kept_.clear(); }

void ViewMemory::forget(const Eigen::Isometry3d& X_WR, const Eigen::AlignedBox3d& box_R) {
  const Eigen::AlignedBox3f box = box_R.cast<float>();
  for (Kept& view : kept_) {
    const Eigen::Isometry3f X_RC = (X_WR.inverse() * view.X_WC).cast<float>();
    Mask inside;
    for (const Eigen::Vector3f& p : view.cloud.points) inside.push_back(box.contains(X_RC * p));
    drop(inside, &view.cloud);
  }
}

Eigen::Isometry3d ViewMemory::add(std::int64_t utime, PointCloud cloud,
                                  const Eigen::Isometry3d& X_WC) {
  if (utime < utime_) forget();
  utime_ = utime;
  X_WW_ = Eigen::Isometry3d::Identity();
  std::erase_if(kept_, [&](const Kept& view) {
    return static_cast<double>(utime - view.utime) > 1e6 * options_.views.remember;
  });
  if (options_.views.remember == 0.0) return X_WW_;
  std::optional<SeenView> seen = seen_view(cloud, options_);
  if (!seen) return X_WW_;
  const Outlook outlook = outlook_of(seen->sight, X_WC);
  Kept view{utime,
            std::move(cloud),
            X_WC,
            std::move(seen->sight),
            moved(std::move(seen->samples), X_WC),
            outlook};
  std::vector<const SurfaceSamples*> before;
  for (const Kept& other : kept_) before.push_back(&other.samples);
  if (!before.empty()) {
    const auto motion =
        align(view.samples, view.outlook.eye_W,
              joined_samples(before, std::vector<int>(before.size(), 0), 0.0), options_.views);
    if (motion) X_WW_ = *motion;
    view.samples = moved(std::move(view.samples), X_WW_);
    view.X_WC = X_WW_ * X_WC;
  }
  for (Kept& other : kept_) {
    const Sight newer = moved(view.sight, other.X_WC.inverse() * view.X_WC);
    drop_outdated(other.sight, newer, put_down(newer, other.sight), &other.cloud);
  }
  place(std::move(view));
  return X_WW_;
}

/// Keeps a view in place of the one from nearly the same direction, or beside the others if there
/// is none. A view between two places serves neither.
void ViewMemory::place(Kept view) {
  const double sector = options_.views.sector;
  const auto nearest =
      std::min_element(kept_.begin(), kept_.end(), [&](const Kept& a, const Kept& b) {
        return angle_between(a.outlook, view.outlook) < angle_between(b.outlook, view.outlook);
      });
  const double angle = nearest == kept_.end() ? std::numeric_limits<double>::infinity()
                                              : angle_between(nearest->outlook, view.outlook);
  if (angle < 0.5 * sector) {
    view.outlook = nearest->outlook;
    kept_.erase(nearest);
  } else if (angle < sector) {
    return;
  }
  kept_.insert(kept_.begin(), std::move(view));
  if (kept_.size() > static_cast<std::size_t>(options_.views.most)) kept_.pop_back();
}

std::vector<PointCloud> ViewMemory::others(std::int64_t utime,
                                           const Eigen::Isometry3d& X_WC) const {
  const bool newest = utime == utime_;
  const Eigen::Isometry3d X_CW = (newest ? X_WW_ * X_WC : X_WC).inverse();
  std::vector<PointCloud> views;
  for (const Kept& view : kept_) {
    if (view.utime != utime) views.push_back(moved(view.cloud, X_CW * view.X_WC));
  }
  return views;
}

}  // namespace quadrille
