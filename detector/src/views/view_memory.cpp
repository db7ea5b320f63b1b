#include "quadrille/detector/view_memory.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "quadrille/detector/detection.hpp"
#include "views/align.hpp"
#include "views/joined_samples.hpp"
#include "views/outdated.hpp"
#include "views/outlook.hpp"
#include "views/seen_view.hpp"
#include "views/thinned.hpp"

namespace quadrille {
namespace {

// The errors of poses change slowly, so that a correction lasts for some time [s].
constexpr double kCorrectionLasts = 0.5;

/// Also for times of any sender, whose difference may not fit into their type.
double seconds_between(std::int64_t before, std::int64_t after) {
  return 1e-6 * (static_cast<double>(after) - static_cast<double>(before));
}

/// Brings a sight from frame C into frame F.
Sight moved(Sight sight, const Eigen::Isometry3d& X_FC) {
  sight.X_VC = sight.X_VC * X_FC.inverse().cast<float>();
  return sight;
}

}  // namespace

struct ViewMemory::Kept {
  int camera = 0;
  std::int64_t utime = 0;
  /// The cloud in the frame C in which it came, so that its pixels stay where they were.
  PointCloud cloud;
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  /// The depths that the view saw, in C.
  Sight sight;
  /// The view's samples, in W.
  SurfaceSamples samples;
  /// From where and at what the view looked. A view that replaces another one takes over that one's
  /// outlook; if it had its own, a slowly moving camera would leave no view behind.
  Outlook outlook;
};

/// The kept view of the same camera from the direction nearest to another one's, and the angle
/// between them [rad]; infinite if there is none.
struct ViewMemory::Nearest {
  std::size_t index = 0;
  double angle = std::numeric_limits<double>::infinity();
};

ViewMemory::ViewMemory(const DetectorOptions& options) : options_(options) { options_.check(); }
ViewMemory::~ViewMemory() = default;
ViewMemory::ViewMemory(ViewMemory&&) noexcept = default;
ViewMemory& ViewMemory::operator=(ViewMemory&&) noexcept = default;

std::size_t ViewMemory::size() const { return kept_.size(); }

void ViewMemory::forget() {
  kept_.clear();
  cameras_.clear();
}

/// Forgets the views of a camera from a time on, and later ones of others, since a log has been
/// restarted.
void ViewMemory::forget_from(std::int64_t utime, int camera) {
  std::erase_if(kept_, [&](const Kept& view) {
    return view.utime > utime || (view.utime == utime && view.camera == camera);
  });
  std::erase_if(cameras_, [&](const auto& camera) { return camera.second.utime > utime; });
}

void ViewMemory::forget(const Eigen::Isometry3d& X_WR, const Eigen::AlignedBox3d& box_R) {
  for (Kept& view : kept_) {
    drop_seen_in(box_R.cast<float>(), (X_WR.inverse() * view.X_WC).cast<float>(), &view.cloud);
  }
}

Eigen::Isometry3d ViewMemory::add(std::int64_t utime, const PointCloud& cloud,
                                  const Eigen::Isometry3d& X_WC, int camera) {
  const auto known = cameras_.find(camera);
  if (known != cameras_.end() && utime < known->second.utime) forget_from(utime, camera);
  std::erase_if(kept_, [&](const Kept& view) {
    return std::abs(seconds_between(view.utime, utime)) > options_.views.remember;
  });
  Camera& of_view = cameras_[camera];
  of_view.utime = utime;
  if (kept_.empty()) of_view.X_WW = Eigen::Isometry3d::Identity();
  if (options_.views.remember == 0.0) return of_view.X_WW;
  std::optional<SeenView> seen = seen_view(cloud, options_);
  if (!seen) return of_view.X_WW;

  Kept view{camera, utime, thinned(cloud, seen->sight), X_WC, std::move(seen->sight), {}, {}};
  view.outlook = outlook_of(view.sight, X_WC);
  view.samples = moved(std::move(seen->samples), X_WC);
  const Nearest nearest = nearest_to(view);
  correct(nearest, &view, &of_view);
  for (Kept& other : kept_) {
    // Another camera's cloud may have come before an older one of this camera.
    if (other.utime > view.utime) {
      const Sight newer = moved(other.sight, view.X_WC.inverse() * other.X_WC);
      drop_outdated(view.sight, newer, &view.cloud);
    } else {
      const Sight newer = moved(view.sight, other.X_WC.inverse() * view.X_WC);
      drop_outdated(other.sight, newer, &other.cloud);
    }
  }
  keep(std::move(view), nearest);
  return of_view.X_WW;
}

ViewMemory::Nearest ViewMemory::nearest_to(const Kept& view) const {
  Nearest nearest;
  for (std::size_t k = 0; k < kept_.size(); ++k) {
    if (kept_[k].camera != view.camera) continue;
    const double angle = angle_between(kept_[k].outlook, view.outlook);
    if (angle < nearest.angle) nearest = {k, angle};
  }
  return nearest;
}

/// The samples of the views from the directions nearest to another one's. Views from farther aside
/// see little of what it sees.
std::vector<const SurfaceSamples*> ViewMemory::samples_about(const Kept& view) const {
  constexpr std::size_t kViews = 2;
  std::vector<std::pair<double, const SurfaceSamples*>> others;
  for (const Kept& other : kept_) {
    others.emplace_back(angle_between(other.outlook, view.outlook), &other.samples);
  }
  std::stable_sort(others.begin(), others.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const SurfaceSamples*> nearest;
  for (std::size_t k = 0; k < std::min(kViews, others.size()); ++k) {
    nearest.push_back(others[k].second);
  }
  return nearest;
}

/// Corrects the pose of a view: by what it has in common with the others, if it is from a new
/// direction or its camera's last correction is old, and otherwise by that one.
void ViewMemory::correct(const Nearest& nearest, Kept* view, Camera* camera) const {
  const bool is_new = nearest.angle > 0.5 * options_.views.sector;
  const bool is_old = seconds_between(camera->corrected, view->utime) > kCorrectionLasts;
  if (!kept_.empty() && (is_new || is_old)) {
    const std::vector<const SurfaceSamples*> others = samples_about(*view);
    const std::vector<int> no_cells(others.size(), 0);
    camera->X_WW = align(view->samples, view->outlook.eye_W, joined_samples(others, no_cells, 0.0),
                         options_.views)
                       .value_or(Eigen::Isometry3d::Identity());
    camera->corrected = view->utime;
  }
  view->samples = moved(std::move(view->samples), camera->X_WW);
  view->X_WC = camera->X_WW * view->X_WC;
}

/// Keeps a view in place of its camera's one from nearly the same direction, or beside the others
/// if there is none. A view between two directions serves neither.
void ViewMemory::keep(Kept view, const Nearest& nearest) {
  if (nearest.angle < 0.5 * options_.views.sector) {
    view.outlook = kept_[nearest.index].outlook;
    kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(nearest.index));
  } else if (nearest.angle < options_.views.sector) {
    return;
  }
  const auto place = std::find_if(kept_.begin(), kept_.end(),
                                  [&](const Kept& other) { return other.utime <= view.utime; });
  kept_.insert(place, std::move(view));
  if (kept_.size() > static_cast<std::size_t>(options_.views.most)) kept_.pop_back();
}

std::vector<PointCloud> ViewMemory::others(std::int64_t utime, const Eigen::Isometry3d& X_WC,
                                           int camera) const {
  const auto known = cameras_.find(camera);
  const bool is_last = known != cameras_.end() && known->second.utime == utime;
  const Eigen::Isometry3d X_CW = (is_last ? known->second.X_WW * X_WC : X_WC).inverse();
  std::vector<PointCloud> views;
  for (const Kept& view : kept_) {
    if (view.camera == camera && view.utime == utime) continue;
    views.push_back(moved(view.cloud, X_CW * view.X_WC));
  }
  return views;
}

}  // namespace quadrille
