#include "quadrille/scene_views.hpp"

#include <utility>

#include "io/ply/ply.hpp"
#include "lab/scene/camera_path.hpp"
#include "lab/scene/scene_files.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {
namespace {

/// Duration of a camera's path that reaches as far as any [s].
constexpr double kPathDuration = 6.0;

/// Returns when a camera on the path is at the place of a view; the views are counted from 0. A
/// single one is at the end, since the first view is in the middle.
double time_of(int view, int views) {
  return views == 1 ? kPathDuration : kPathDuration * view / (views - 1);
}

}  // namespace

std::vector<WrittenView> write_scene_views(const std::string& path,
                                           const scene::SceneOptions& options, bool labels,
                                           int views, scene::Scene* first) {
  const scene::Layout layout = scene::make_layout(options);
  const scene::CameraPath camera(layout, kPathDuration);
  scene::Random sensor = scene::sensor_random(options);
  *first = scene::take_picture(options, layout, &sensor);
  const std::string base = path.substr(0, path.rfind(".ply"));
  std::vector<WrittenView> written;
  for (int view = 0; view < views - 1; ++view) {
    scene::Layout seen = layout;
    const Eigen::Isometry3d X_WK = camera.pose_at(time_of(view, views - 1));
    seen.X_CW = X_WK.inverse();
    PointCloud cloud;
    cloud.points = scene::take_picture(options, seen, &sensor).view.points;
    // All views are in the frame of the first one.
    cloud.frame = scene::kCameraFrame;
    const Eigen::Isometry3d X_CK = layout.X_CW * X_WK;
    const std::string name = base + ".view" + std::to_string(view + 1) + ".ply";
    io::write_ply(name, moved(std::move(cloud), X_CK));
    written.push_back({name, X_CK});
  }
  // The first view appears last, so that all is there with it.
  scene::write_scene(path, *first, labels);
  return written;
}

}  // namespace quadrille
