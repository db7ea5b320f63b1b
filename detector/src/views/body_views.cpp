#include "views/body_views.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace quadrille {
namespace {

// A view shows a body if so many of its samples are on it; fewer are noise.
constexpr int kMinSamples = 8;
// Samples count if they lie no farther than noise from the body's box [m].
constexpr double kNear = 0.004;

bool has_part(const SceneBody& body, int id) {
  return std::find(body.parts.begin(), body.parts.end(), id) != body.parts.end();
}

/// Counts samples on a body in each view.
class SampleCounts {
 public:
  SampleCounts(const SceneBody& body, std::size_t views)
      : X_BC_(body.X_CB.inverse()),
        near_B_(-0.5 * body.size - Eigen::Vector3d::Constant(kNear),
                0.5 * body.size + Eigen::Vector3d::Constant(kNear)),
        count_(views, 0) {}

  void add(const SurfaceSamples& samples, int i) {
    count_[samples.view_of(i)] += near_B_.contains(X_BC_ * samples.raw[i].cast<double>());
  }
  /// The number of samples that a view must show to show the body; of small bodies no view shows
  /// many.
  int enough() const {
    return std::clamp(*std::max_element(count_.begin(), count_.end()), 1, kMinSamples);
  }
  int in_view(std::size_t view) const { return count_[view]; }

 private:
  Eigen::Isometry3d X_BC_;
  Eigen::AlignedBox3d near_B_;
  std::vector<int> count_;
};

}  // namespace

void note_views(const Scene& scene, const std::vector<int>& owner,
                const std::vector<int>& plane_ids, std::vector<SceneBody>* bodies) {
  for (SceneBody& body : *bodies) {
    SampleCounts counts(body, scene.views.size());
    for (int i = 0; i < scene.finest.size(); ++i) {
      if (owner[i] <= 0 || has_part(body, owner[i])) counts.add(scene.finest, i);
    }
    for (std::size_t k = 0; k < scene.planes.size(); ++k) {
      if (!has_part(body, plane_ids[k])) continue;
      for (const int i : scene.planes[k].samples) counts.add(scene.coarse, i);
    }
    int views = 0;
    double unseen = std::numeric_limits<double>::infinity();
    for (std::size_t v = 0; v < scene.views.size(); ++v) {
      if (counts.in_view(v) < counts.enough()) continue;
      ++views;
      unseen = std::min(unseen, scene.views[v].age);
    }
    // No view shows enough of such a body; it counts as seen by the newest one, which is the first.
    body.views = std::max(views, 1);
    body.unseen = views == 0 ? scene.views.front().age : unseen;
  }
}

}  // namespace quadrille
