#include "quadrille/scene_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/choice_option.hpp"
#include "cli/number_list.hpp"
#include "cli/output.hpp"
#include "cli/rate_option.hpp"
#include "cli/seed_option.hpp"
#include "io/describe.hpp"
#include "io/planner/gripper_file.hpp"
#include "lab/scene/scene.hpp"
#include "lab/scene/scene_files.hpp"
#include "logs/posed_log_writer.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/printable.hpp"
#include "quadrille/scene_log.hpp"
#include "quadrille/scene_views.hpp"

namespace quadrille {
namespace {

/// Limits of --path: with one cloud nothing moves, and a thousand make a log of 4 GB.
constexpr int kFewestClouds = 2, kMostClouds = 1000;
/// Limit of --views: with nine the camera moves by 15 degrees from one to the next.
constexpr int kMostViews = 10;
/// The camera's poses come at a constant rate, so that a slow log would hold little else [Hz].
constexpr double kLeastRate = 1.0;
/// Limits of the error of poses [m, degrees]; with larger ones they say nothing.
constexpr double kMostShift = 0.1, kMostTurn = 10.0;

struct SceneArguments {
  std::string out;
  SceneLogOptions options;
  bool labels = false;
  /// Number of views of a picture.
  int views = 1;
};

const Choices<scene::Family>& scene_families() {
  static const Choices<scene::Family> choices = {{"easy", scene::Family::kEasy},
                                                 {"medium", scene::Family::kMedium},
                                                 {"hard", scene::Family::kHard},
                                                 {"tabletop", scene::Family::kTabletop}};
  return choices;
}

/// Reads --pose-error.
scene::PoseErrorSize pose_error_of(const std::string& list) {
  const char *option = "--pose-error", *form = "M,DEGREES";
  const std::vector<double> v = numbers_of(option, list, 2, form);
  if (!(v[0] >= 0.0 && v[0] <= kMostShift && v[1] >= 0.0 && v[1] <= kMostTurn)) {
    throw CLI::ValidationError(
        option, fmt::format("'{}' must be from 0 to {} m and from 0 to {} degrees", printable(list),
                            kMostShift, kMostTurn));
  }
  return {v[0], v[1] * std::numbers::pi / 180.0};
}

/// Reads --hand.
Gripper hand_of(const std::string& name) {
  try {
    return io::load_gripper(name);
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError("--hand", std::string(error.what()) + ", or a .toml file");
  }
}

void write_picture(const SceneArguments& arguments) {
  scene::Scene made;
  std::vector<WrittenView> further;
  if (arguments.views > 1) {
    further = write_scene_views(arguments.out, arguments.options.scene, arguments.labels,
                                arguments.views, &made);
  } else {
    made = scene::make_scene(arguments.options.scene);
    scene::write_scene(arguments.out, made, arguments.labels);
  }
  print(fmt::format("{}: {} points, {}; truth in {}\n", arguments.out, made.view.points.size(),
                    io::count_of(static_cast<std::size_t>(scene::count_quadrics(made)), "quadric"),
                    scene::truth_path(arguments.out)));
  for (const WrittenView& view : further) {
    const Eigen::Vector3d p = view.X_CK.translation();
    const Eigen::Quaterniond R = rotation_of(view.X_CK);
    print(fmt::format("{}: --camera-pose={:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n",
                      view.path, p.x(), p.y(), p.z(), R.w(), R.x(), R.y(), R.z()));
  }
}

void write_log(const SceneArguments& arguments) {
  const SceneLogSummary log = write_scene_log(arguments.out, arguments.options);
  print(fmt::format("{}: {} clouds on {}, poses on {}, {:.1f} MB, {}; truth in {}\n", arguments.out,
                    arguments.options.clouds, kCloudChannel, kCameraChannel,
                    static_cast<double>(log.bytes) * 1e-6,
                    io::count_of(static_cast<std::size_t>(log.quadrics), "quadric"),
                    scene::truth_path(arguments.out)));
}

void run(const SceneArguments& arguments) {
  const bool is_log = arguments.options.clouds > 0;
  if (!arguments.out.ends_with(is_log ? ".lcm" : ".ply")) {
    throw CLI::ValidationError(
        "OUT", fmt::format("'{}' must end in {}", printable(arguments.out),
                           is_log ? ".lcm, as --path writes a log" : ".ply, or needs --path"));
  }
  if (is_log) {
    write_log(arguments);
  } else {
    write_picture(arguments);
  }
}

void add_path_options(CLI::App& command, SceneArguments& arguments) {
  CLI::Option* path =
      command
          .add_option("--path", arguments.options.clouds,
                      fmt::format("Write an LCM log of N clouds instead (OUT.lcm), from a camera "
                                  "that moves about the scene, on {}, with its poses on {}. Their "
                                  "fixed frame, and that of the truth, is the camera's frame in "
                                  "the first cloud",
                                  kCloudChannel, kCameraChannel))
          ->check(CLI::Range(kFewestClouds, kMostClouds))
          ->type_name("N");
  add_rate_option(command, arguments.options.rate, kLeastRate, logs::PosedLogWriter::kMaxRate)
      ->needs(path);
  command
      .add_option_function<std::string>(
          "--pose-error",
          [&arguments](const std::string& list) {
            arguments.options.pose_error = pose_error_of(list);
          },
          "Standard deviations of a slow error of the poses, of position and direction along and "
          "about each axis of the camera")
      ->type_name("M,DEGREES")
      ->needs(path);
  command
      .add_option_function<std::string>(
          "--hand",
          [&arguments](const std::string& name) { arguments.options.hand = hand_of(name); },
          fmt::format("A hand, by built-in name or as a TOML file, whose fingers the camera at its "
                      "wrist has in the picture; its shapes are told on {}",
                      kHandChannel))
      ->type_name("NAME|FILE")
      ->needs(path);
  command.get_option("--labels")->excludes(path);
  command.get_option("--views")->excludes(path);
}

}  // namespace

void add_scene_command(CLI::App& app) {
  auto arguments = std::make_shared<SceneArguments>();
  CLI::App* command = app.add_subcommand("scene", "Render a depth-camera scene with its truth");
  command->add_option("OUT", arguments->out, "The cloud to write (.ply), or the log (.lcm)")
      ->required();
  scene::SceneOptions& scene = arguments->options.scene;
  add_choice_option(*command, "--family", scene.family, scene_families(), "How hard the scene is");
  add_seed_option(*command, scene.seed, "the scene");
  command->add_flag("--labels", arguments->labels,
                    "Also write the surface and the true normal of each point");
  command
      ->add_option("--views", arguments->views,
                   "Also write views from other places, as OUT.view1.ply and so on, all in the "
                   "frame of OUT.ply, and print the poses of their cameras")
      ->check(CLI::Range(2, kMostViews))
      ->type_name("N");
  add_path_options(*command, *arguments);
  command->callback([arguments] { run(*arguments); });
}

}  // namespace quadrille
