#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "quadrille/detector/stage_options.hpp"
#include "views/align.hpp"
#include "views/contradiction.hpp"
#include "views/joined_samples.hpp"
#include "views/outlook.hpp"
#include "views/seen_view.hpp"

namespace quadrille {

/// Brings a sight from frame C into frame F.
inline Sight moved(Sight sight, const Eigen::Isometry3d& X_FC) {
  sight.X_VC = sight.X_VC * X_FC.inverse().cast<float>();
  return sight;
}

/// Difference of two times [s]; also for times of any sender, whose difference may not fit into
/// their type.
inline double elapsed_seconds(std::int64_t before, std::int64_t after) {
  return 1e-6 * (static_cast<double>(after) - static_cast<double>(before));
}

/// A view of a moving camera that is kept.
/// @tparam Content  what is kept of it; it has the functions drop(const Contradiction&) and
///   drop(const ForgottenBox&)
template <class Content>
struct KeptView {
  int camera = 0;
  std::int64_t utime = 0;
  /// In the frame C in which the cloud came, so that its pixels stay where they were.
  Content content;
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  /// The depths that the view saw, in C.
  Sight sight;
  /// The view's samples, in W.
  SamplesOnDemand samples;
  /// From where and at what the view looked. A view that replaces another one takes over that one's
  /// outlook; if it had its own, a slowly moving camera would leave no view behind.
  Outlook outlook;
};

/// Chooses the views of moving cameras that are kept, corrects their poses, and forgets what newer
/// views contradict; see the public ViewMemory.
template <class Content>
class KeptViews {
 public:
  using View = KeptView<Content>;
  /// A kept view, and the pose of its frame in another frame C.
  struct Placed {
    const View* view;
    Eigen::Isometry3d X_CV;
  };

  explicit KeptViews(const ViewOptions& options) : options_(options) {}

  /// Begins with a view of a camera: forgets what is too old, and, if the camera's clock has been
  /// set back, all that is newer.
  void begin(std::int64_t utime, int camera) {
    const auto known = cameras_.find(camera);
    if (known != cameras_.end() && utime < known->second.utime) forget_from(utime, camera);
    std::erase_if(views_, [&](const View& view) {
      return std::abs(elapsed_seconds(view.utime, utime)) > options_.remember;
    });
    Camera& of_view = cameras_[camera];
    of_view.utime = utime;
    if (views_.empty()) of_view.X_WW = Eigen::Isometry3d::Identity();
  }

  /// Adds the view, from what it saw in C and the pose of C.
  void add(std::int64_t utime, SeenView seen, Content content, const Eigen::Isometry3d& X_WC,
           int camera) {
    seen.samples.move(X_WC);
    View view{
        camera, utime, std::move(content), X_WC, std::move(seen.sight), std::move(seen.samples),
        {}};
    view.outlook = outlook_of(view.sight, X_WC);
    const Nearest nearest = nearest_to(view);
    correct(nearest, &view, &cameras_[camera]);
    for (View& other : views_) {
      // Another camera's cloud may have come before an older one of this camera.
      const bool is_newer = other.utime <= view.utime;
      drop_outdated(is_newer ? &other : &view, is_newer ? view : other);
    }
    keep(std::move(view), nearest);
  }

  /// The motion within W that corrects the pose of a camera's last view.
  Eigen::Isometry3d correction(int camera) const {
    const auto known = cameras_.find(camera);
    return known == cameras_.end() ? Eigen::Isometry3d::Identity() : known->second.X_WW;
  }

  /// The views but the one that this camera had at this time, the newest first.
  /// @param X_WC  pose of C in W; that of the camera's last view is corrected as this one was
  std::vector<Placed> others(std::int64_t utime, const Eigen::Isometry3d& X_WC, int camera) const {
    const auto known = cameras_.find(camera);
    const bool is_last = known != cameras_.end() && known->second.utime == utime;
    const Eigen::Isometry3d X_CW = (is_last ? known->second.X_WW * X_WC : X_WC).inverse();
    std::vector<Placed> placed;
    for (const View& view : views_) {
      if (view.camera == camera && view.utime == utime) continue;
      placed.push_back({&view, X_CW * view.X_WC});
    }
    return placed;
  }

  /// What is kept of the view that a camera had at a time; null if it is not kept.
  Content* content(std::int64_t utime, int camera) {
    const auto found = std::find_if(views_.begin(), views_.end(), [&](const View& view) {
      return view.utime == utime && view.camera == camera;
    });
    return found == views_.end() ? nullptr : &found->content;
  }

  void forget() {
    views_.clear();
    cameras_.clear();
  }
  /// @param X_WR  pose of the box's frame R in W
  void forget(const Eigen::Isometry3d& X_WR, const Eigen::AlignedBox3d& box_R) {
    for (View& view : views_) {
      const Eigen::Isometry3d X_RC = X_WR.inverse() * view.X_WC;
      view.content.drop(ForgottenBox{Eigen::AlignedBox3f(box_R), X_RC.cast<float>()});
    }
  }

  std::size_t size() const { return views_.size(); }

 private:
  /// The errors of poses change slowly, so that a correction lasts for some time [s].
  static constexpr double kCorrectionLasts = 0.5;

  /// The last view of a camera, and the correction of its poses.
  struct Camera {
    /// Time of the view [us].
    std::int64_t utime = 0;
    /// The correction of its pose, and when it was found [us].
    Eigen::Isometry3d X_WW = Eigen::Isometry3d::Identity();
    std::int64_t corrected = 0;
  };
  /// The kept view of the same camera from the direction nearest to another one's, and the angle
  /// between them [rad]; infinite if there is none.
  struct Nearest {
    std::size_t index = 0;
    double angle = std::numeric_limits<double>::infinity();
  };

  /// Forgets the views of a camera from a time on, and later ones of others.
  void forget_from(std::int64_t utime, int camera) {
    std::erase_if(views_, [&](const View& view) {
      return view.utime > utime || (view.utime == utime && view.camera == camera);
    });
    std::erase_if(cameras_, [&](const auto& other) { return other.second.utime > utime; });
  }

  Nearest nearest_to(const View& view) const {
    Nearest nearest;
    for (std::size_t k = 0; k < views_.size(); ++k) {
      if (views_[k].camera != view.camera) continue;
      const double angle = angle_between(views_[k].outlook, view.outlook);
      if (angle < nearest.angle) nearest = {k, angle};
    }
    return nearest;
  }

  /// The samples of the views from the directions nearest to another one's. Views from farther
  /// aside see little of what it sees.
  std::vector<const SurfaceSamples*> samples_about(const View& view) {
    constexpr std::size_t kViews = 2;
    std::vector<std::pair<double, SamplesOnDemand*>> others;
    for (View& other : views_) {
      others.emplace_back(angle_between(other.outlook, view.outlook), &other.samples);
    }
    std::stable_sort(others.begin(), others.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<const SurfaceSamples*> nearest;
    for (std::size_t k = 0; k < std::min(kViews, others.size()); ++k) {
      nearest.push_back(&others[k].second->get());
    }
    return nearest;
  }

  /// Corrects the pose of a view: by what it has in common with the others, if it is from a new
  /// direction or its camera's last correction is old, and otherwise by that one.
  void correct(const Nearest& nearest, View* view, Camera* camera) {
    const bool is_new = nearest.angle > 0.5 * options_.sector;
    const bool is_old = elapsed_seconds(camera->corrected, view->utime) > kCorrectionLasts;
    if (!views_.empty() && (is_new || is_old)) {
      const std::vector<const SurfaceSamples*> others = samples_about(*view);
      camera->X_WW =
          align(view->samples.get(), view->outlook.eye_W, joined_places(others), options_)
              .value_or(Eigen::Isometry3d::Identity());
      camera->corrected = view->utime;
    }
    view->samples.move(camera->X_WW);
    view->X_WC = camera->X_WW * view->X_WC;
  }

  static void drop_outdated(View* older, const View& newer) {
    const Sight sight = moved(newer.sight, older->X_WC.inverse() * newer.X_WC);
    older->content.drop(Contradiction(older->sight, sight));
  }

  /// Keeps a view in place of its camera's one from nearly the same direction, or beside the others
  /// if there is none. A view between two directions serves neither.
  void keep(View view, const Nearest& nearest) {
    if (nearest.angle < 0.5 * options_.sector) {
      view.outlook = views_[nearest.index].outlook;
      views_.erase(views_.begin() + static_cast<std::ptrdiff_t>(nearest.index));
    } else if (nearest.angle < options_.sector) {
      return;
    }
    const auto place = std::find_if(views_.begin(), views_.end(),
                                    [&](const View& other) { return other.utime <= view.utime; });
    views_.insert(place, std::move(view));
    if (views_.size() > static_cast<std::size_t>(options_.most)) views_.pop_back();
  }

  ViewOptions options_;
  /// The views, the newest first.
  std::vector<View> views_;
  std::map<int, Camera> cameras_;
};

}  // namespace quadrille
