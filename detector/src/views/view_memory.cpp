#include "quadrille/detector/view_memory.hpp"

#include <memory>
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

/// What the view saw, unless it is of no use, and what is kept of it then.
struct PreparedView::Parts {
  std::optional<SeenView> seen;
  KeptCloud content;
};

PreparedView::PreparedView(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
PreparedView::PreparedView(PreparedView&&) noexcept = default;
PreparedView& PreparedView::operator=(PreparedView&&) noexcept = default;
PreparedView::~PreparedView() = default;

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

PreparedView ViewMemory::prepare(const PointCloud& cloud) const {
  auto parts = std::make_unique<PreparedView::Parts>();
  if (views_->options.views.remember > 0.0) parts->seen = seen_view(cloud, views_->options);
  if (parts->seen) parts->content.cloud = thinned(cloud, parts->seen->sight);
  return PreparedView(std::move(parts));
}

Eigen::Isometry3d ViewMemory::add(std::int64_t utime, const PointCloud& cloud,
                                  const Eigen::Isometry3d& X_WC, int camera) {
  return add(utime, prepare(cloud), X_WC, camera);
}

Eigen::Isometry3d ViewMemory::add(std::int64_t utime, PreparedView view,
                                  const Eigen::Isometry3d& X_WC, int camera) {
  KeptViews<KeptCloud>& kept = views_->kept;
  PreparedView::Parts& parts = *view.parts_;
  kept.begin(utime, camera);
  if (parts.seen) {
    kept.add(utime, *std::move(parts.seen), std::move(parts.content), X_WC, camera);
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
