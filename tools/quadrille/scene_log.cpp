#include "quadrille/scene_log.hpp"

#include "cli/progress_line.hpp"
#include "io/new_file.hpp"
#include "lab/scene/camera_path.hpp"
#include "lab/scene/scene_files.hpp"
#include "logs/posed_log_writer.hpp"

namespace quadrille {
namespace {

/// Stream of the random numbers of the poses; scenes have the lower ones, two for each family.
constexpr std::uint64_t kPoseStream = 1000;

}  // namespace

SceneLogSummary write_scene_log(const std::string& path, const SceneLogOptions& options) {
  scene::Layout layout = scene::make_layout(options.scene);
  const double duration = (options.clouds - 1) / options.rate;
  const scene::CameraPath camera(layout, duration);
  scene::Random poses(options.scene.seed, kPoseStream);
  const scene::PoseError error(options.pose_error, duration, &poses);
  // T is the frame of the layout.
  const Eigen::Isometry3d X_WT = camera.pose_at(0.0).inverse();
  const auto pose_at = [&](double time) { return X_WT * camera.pose_at(time) * error.at(time); };

  io::NewFile log(path), truth(scene::truth_path(path));
  logs::CloudLogOptions format;
  format.rate = options.rate;
  format.channel = kCloudChannel;
  logs::PosedLogWriter writer(log.path(), format, kCameraChannel, pose_at, path);
  scene::Random sensor = scene::sensor_random(options.scene);
  SceneLogSummary summary;
  ProgressLine progress;
  for (int i = 0; i < options.clouds; ++i) {
    layout.X_CW = camera.pose_at(i / options.rate).inverse();
    const scene::Scene picture = scene::take_picture(options.scene, layout, &sensor);
    if (i == 0) {
      truth.write(scene::truth_text(picture));
      summary.quadrics = scene::count_quadrics(picture);
    }
    writer.write(scene::organised_cloud(picture.camera, picture.view));
    progress.show((i + 1.0) / options.clouds);
  }
  writer.finish();
  summary.bytes = writer.bytes();
  // The log appears last, so that its ground truth is there before it.
  truth.commit();
  log.commit();
  return summary;
}

}  // namespace quadrille
