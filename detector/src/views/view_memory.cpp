#include "quadrille/detector/view_memory.hpp"

#include <optional>
#include <utility>

#include "cloud/drop_points.hpp"
#include "quadrille/detector/detection.hpp"
#include "views/kept_views.hpp"
#include "views/seen_view.hpp"
#include "views/thinned.hpp"

namespace quadrille {

/// The points of a view in its frame C.
struct KeptCloud {
  PointCloud cloud;

  void drop(const Contradiction& contradiction) {
    drop_points(contradiction.of_points(cloud.points), &cloud);
  }
  void drop(const ForgottenBox& box) {
    drop_points(box.of_points(cloud.points, cloud.viewpoint), &cloud);
  }
};

struct ViewMemory::Views {
  DetectorOptions options;
  KeptViews<KeptCloud> kept;
};

ViewMemory::ViewMemory(const DetectorOptions& options) {
  options.check();
  views_ = std::make_unique<Views>(Views{options, KeptViews<KeptCloud>(options.views)});
}
ViewMemory::~ViewMemory() = default;
ViewMemory::ViewMemory(ViewMemory&&) noexcept = default;
ViewMemory& ViewMemory::operator=(ViewMemory&&) noexcept = default;

std::size_t ViewMemory::size() const { return views_->kept.size(); }

void ViewMemory::forget() { views_->kept.forget(); }

void ViewMemory::forget(const Eigen::Isometry3d& X_WR, const Eigen::AlignedBox3d& box_R) {
  views_->kept.forget(X_WR, box_R);
}

Eigen::Isometry3d ViewMemory::add(std::int64_t utime, const PointCloud& cloud,
                                  const Eigen::Isometry3d& X_WC, int camera) {
  KeptViews<KeptCloud>& kept = views_->kept;
  const DetectorOptions& options = views_->options;
  kept.begin(utime, camera);
  if (options.views.remember > 0.0) {
    if (std::optional<SeenView> seen = seen_view(cloud, options)) {
      KeptCloud content{thinned(cloud, seen->sight)};
      kept.add(utime, *std::move(seen), std::move(content), X_WC, camera);
    }
  }
  return kept.correction(camera);
}

std::vector<PointCloud> ViewMemory::others(std::int64_t utime, const Eigen::Isometry3d& X_WC,
                                           int camera) const {
  std::vector<PointCloud> clouds;
  for (const auto& [view, X_CV] : views_->kept.others(utime, X_WC, camera)) {
    clouds.push_back(moved(view->content.cloud, X_CV));
  }
  return clouds;
}

}  // namespace quadrille
