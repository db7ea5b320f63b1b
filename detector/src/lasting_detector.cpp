#include "quadrille/detector/lasting_detector.hpp"

#include <algorithm>
#include <iomanip>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "detect_with.hpp"
#include "views/join_views.hpp"
#include "views/kept_views.hpp"
#include "views/seen_view.hpp"
#include "views/view_parts.hpp"

namespace quadrille {
namespace {

/// A kept view in the frame C of a newer one, `age` seconds later.
SceneView placed(const KeptView<KeptParts>& view, const Eigen::Isometry3d& X_CV, double age) {
  const KeptParts& kept = view.content;
  ViewCells cells;
  cells.scatter = moved(kept.scatter, X_CV);
  cells.boxes = moved(kept.lasting_boxes(), X_CV);
  cells.age = std::max(0.0, age);
  return {std::move(cells), moved(kept.parts, X_CV), moved(kept.sight, X_CV)};
}

/// Says what is given in place of a cloud that shows nothing.
std::string describe_remembered(const Scene& scene) {
  std::ostringstream text;
  text << "this cloud shows nothing: the result is what " << scene.views.size()
       << (scene.views.size() == 1 ? " other cloud showed, " : " others showed, the newest ")
       << std::fixed << std::setprecision(2) << scene.views.front().age << " s before";
  return text.str();
}

}  // namespace

struct LastingDetector::Views {
  DetectorOptions options;
  KeptViews<KeptParts> kept;

  /// Keeps the view of a scene, and joins it with the views before it.
  Scene add(std::int64_t utime, Scene scene, const Eigen::Isometry3d& X_WC, int camera) {
    if (scene.viewpoint().allFinite()) {
      kept.add(utime, seen_view(scene.views.front().pyramid, options), kept_parts(scene), X_WC,
               camera);
    }
    const auto others = kept.others(utime, X_WC, camera);
    if (others.empty()) return scene;
    std::vector<SceneView> views;
    views.push_back(single_view(std::move(scene)));
    for (const auto& [view, X_CV] : others) {
      views.push_back(placed(*view, X_CV, elapsed_seconds(view->utime, utime)));
    }
    return join_views(std::move(views), options);
  }

  /// Joins the kept views if the new cloud shows nothing; nullopt if there are none.
  /// @param eye_C  the viewpoint of the new cloud
  std::optional<Scene> remembered(std::int64_t utime, const Eigen::Isometry3d& X_WC,
                                  const Eigen::Vector3d& eye_C, int camera) const {
    std::vector<SceneView> views;
    for (const auto& [view, X_CV] : kept.others(utime, X_WC, camera)) {
      views.push_back(placed(*view, X_CV, elapsed_seconds(view->utime, utime)));
    }
    if (views.empty()) return std::nullopt;
    Scene scene = join_views(std::move(views), options);
    scene.views.front().cloud.viewpoint = eye_C;
    return scene;
  }
};

LastingDetector::LastingDetector(const DetectorOptions& options) {
  options.check();
  views_ = std::make_unique<Views>(Views{options, KeptViews<KeptParts>(options.views)});
}
LastingDetector::~LastingDetector() = default;
LastingDetector::LastingDetector(LastingDetector&&) noexcept = default;
LastingDetector& LastingDetector::operator=(LastingDetector&&) noexcept = default;

DetectionResult LastingDetector::detect(std::int64_t utime, const CloudView& cloud,
                                        const Eigen::Isometry3d& X_WC, int camera) {
  if (views_->options.views.remember == 0.0) return quadrille::detect(cloud, views_->options);
  views_->kept.begin(utime, camera);
  Eigen::Vector3d shift_C = Eigen::Vector3d::Zero();
  bool shows_something = false;
  std::string warning;
  const auto join = [&](std::vector<Scene> scenes,
                        const Eigen::Vector3d& shift) -> std::optional<Scene> {
    shift_C = shift;
    shows_something = !scenes.empty();
    const Eigen::Isometry3d X_WS = X_WC * Eigen::Translation3d(-shift);
    if (shows_something) return views_->add(utime, std::move(scenes.front()), X_WS, camera);
    std::optional<Scene> scene = views_->remembered(utime, X_WS, cloud.viewpoint + shift_C, camera);
    if (scene) warning = describe_remembered(*scene);
    return scene;
  };
  DetectionResult result = detect_joined(join, {&cloud, 1}, views_->options);
  // It comes first, because what is wrong with the cloud is of less interest.
  if (!warning.empty()) result.warnings.insert(result.warnings.begin(), warning);
  KeptParts* const parts = views_->kept.content(utime, camera);
  if (shows_something && parts != nullptr) {
    std::vector<Box> boxes = result.boxes;
    for (Box& box : boxes) box.X_CB.pretranslate(shift_C);
    keep_boxes(boxes, parts);
  }
  return result;
}

Eigen::Isometry3d LastingDetector::correction(int camera) const {
  return views_->kept.correction(camera);
}

void LastingDetector::forget() { views_->kept.forget(); }

void LastingDetector::forget(const Eigen::Isometry3d& X_WR, const Eigen::AlignedBox3d& box_R) {
  views_->kept.forget(X_WR, box_R);
}

std::size_t LastingDetector::size() const { return views_->kept.size(); }

}  // namespace quadrille
