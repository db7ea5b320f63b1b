#include "quadrille/scene_log.hpp"

#include "cli/progress_line.hpp"
#include "io/new_file.hpp"
#include "lab/scene/camera_path.hpp"
#include "lab/scene/scene_files.hpp"
#include "logs/posed_log_writer.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/wrist_hand.hpp"

namespace quadrille {
namespace {

/// Stream of the random numbers of the poses; scenes have the lower ones, two for each family.
constexpr std::uint64_t kPoseStream = 1000;

/// Takes a picture from a place, with the hand if there is one, which is no part of the layout.
scene::Scene picture_from(const Eigen::Isometry3d& X_TK, const scene::SceneOptions& options,
                          const scene::Layout& layout, const std::optional<WristHand>& hand,
                          scene::Random* sensor) {
  scene::Layout seen = layout;
  seen.X_CW = X_TK.inverse();
  // It is the last body, so that the others keep their numbers.
  if (hand) seen.bodies.push_back(hand->body(X_TK));
  scene::Scene picture = scene::take_picture(options, seen, sensor);
  picture.layout.bodies.resize(layout.bodies.size());
  return picture;
}

}  // namespace

SceneLogSummary write_scene_log(const std::string& path, const SceneLogOptions& options) {
  const scene::Layout layout = scene::make_layout(options.scene);
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
  std::optional<WristHand> hand;
  if (options.hand) hand.emplace(*options.hand);
  ProgressLine progress;
  for (int i = 0; i < options.clouds; ++i) {
    const scene::Scene picture =
        picture_from(camera.pose_at(i / options.rate), options.scene, layout, hand, &sensor);
    if (i == 0) {
      truth.write(scene::truth_text(picture));
      summary.quadrics = scene::count_quadrics(picture);
    }
    if (hand) {
      writer.write_before(kHandChannel, bus::encode(hand->message(writer.next_utime())));
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
